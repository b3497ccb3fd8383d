import type { Argument, Expression, Name, Routine, Statement } from '../code.ts';

/** Every expression of statements, from the outside in. */
export function* expressionsIn(body: readonly Statement[]): Generator<Expression | Argument> {
  for (const statement of body) {
    if ('value' in statement) yield* within(statement.value);
    if (statement.kind === 'set') yield* within(statement.to);
    if (statement.kind === 'if') {
      yield* within(statement.when);
      yield* expressionsIn(statement.then);
      yield* expressionsIn(statement.otherwise);
    }
    if (statement.kind === 'for') {
      yield* within(statement.from);
      yield* within(statement.to);
      yield* expressionsIn(statement.body);
    }
    if (statement.kind === 'while') {
      yield* within(statement.when);
      yield* expressionsIn(statement.body);
    }
  }
}

function* within(of: Expression | Argument): Generator<Expression | Argument> {
  yield of;
  if (of.kind === 'binary') {
    yield* within(of.left);
    yield* within(of.right);
  }
  if (of.kind === 'element') yield* within(of.index);
  if ('of' in of) yield* within(of.of);
  if (of.kind === 'call') for (const one of of.arguments) yield* within(one);
}

/** The names that statements read: variables, arrays, and routines that are called. */
export function namesIn(body: readonly Statement[]): Set<Name> {
  const found = new Set<Name>();
  for (const one of expressionsIn(body)) {
    if (one.kind === 'name') found.add(one.name);
    if (one.kind === 'element' || one.kind === 'array') found.add(one.array);
    if (one.kind === 'call') found.add(one.routine);
  }
  return found;
}

/** The statements without variables that nobody reads. */
export function withoutUnused(body: readonly Statement[]): readonly Statement[] {
  const used = namesIn(body);
  const kept = body.filter((statement) => statement.kind !== 'declare' || used.has(statement.name));
  return kept.length === body.length ? kept : withoutUnused(kept);
}

/** What a routine uses of others. */
export const usedBy = ({ body }: Routine): ReadonlySet<Name> => namesIn(body);
