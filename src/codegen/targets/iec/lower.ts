import {
  type Argument,
  binary,
  type Code,
  type Constant,
  type Expression,
  element,
  int,
  type Name,
  name,
  type Routine,
  type Scalar,
  type Statement,
  type Table,
} from '../../code.ts';

/** The array that a routine fills with a frame, and how many bytes of it are filled where that is not known beforehand. */
export const FRAME = 'frame';
const LENGTH = 'frame length';
/** The variable that holds what a function gives; its name there is that of the function. */
export const RESULT = 'result of the function';

export interface Local {
  readonly name: Name;
  readonly type: Scalar;
}

/** A routine in a language that has no growing arrays, no declarations among statements and no values of `return`. */
export interface Lowered {
  readonly body: readonly Statement[];
  readonly locals: readonly Local[];
  readonly constants: readonly Constant[];
  readonly tables: readonly Table[];
  /** The routines it calls. */
  readonly calls: ReadonlySet<Name>;
}

/**
 * Bytes are put at a constant index as long as it is known, then at one that is counted. Results are set; a `return` that is
 * left only ends the routine.
 */
export function lowered(routine: Routine, code: Code): Lowered {
  const frames = new Frames();
  const body = frames.statements(withoutReturn(routine.body));
  const end = routine.gives.kind === 'frame' ? [set(name('int', RESULT), frames.length)] : [];
  const all = [...body, ...end];
  const used = new Uses();
  used.statements(all);
  return {
    body: all,
    locals: [...used.locals.values()],
    constants: code.constants.filter(({ name }) => used.names.has(name)),
    tables: code.tables.filter(({ name }) => used.names.has(name)),
    calls: used.calls,
  };
}

const set = (to: Extract<Expression, { kind: 'name' | 'element' }>, value: Expression): Statement => ({
  kind: 'set',
  to,
  value,
});
const plus = (left: Expression, right: number): Expression =>
  left.kind === 'number' ? int(left.value + right) : binary(left, '+', int(right));

/** The end of a routine needs no `return`. */
const withoutReturn = (body: readonly Statement[]): readonly Statement[] =>
  body.map((statement, index) =>
    index === body.length - 1 && statement.kind === 'return'
      ? { ...statement, kind: 'set', to: name(statement.value.type, RESULT) }
      : statement,
  );

const puts = (statements: readonly Statement[]): boolean =>
  statements.some((one) => {
    if (one.kind === 'put') return true;
    if (one.kind === 'if') return puts(one.then) || puts(one.otherwise);
    return (one.kind === 'for' || one.kind === 'while') && puts(one.body);
  });

class Frames {
  /** A number as long as it is known. */
  length: Expression = int(0);

  statements(all: readonly Statement[]): readonly Statement[] {
    return all.flatMap((one) => this.#statement(one));
  }

  #statement(one: Statement): readonly Statement[] {
    const of = (expression: Expression) => replaced(expression, this.length);
    switch (one.kind) {
      case 'put':
        return this.#put(one, of(one.value));
      case 'declare':
        return [{ ...one, value: of(one.value) }];
      case 'set':
        return [{ ...one, to: of(one.to) as typeof one.to, value: of(one.value) }];
      case 'return':
        return [
          { ...one, kind: 'set', to: name(one.value.type, RESULT), value: of(one.value) },
          { kind: 'return', value: int(0) },
        ];
      case 'remark':
        return [one];
      case 'if': {
        const counted = this.#counted([...one.then, ...one.otherwise]);
        const then = this.statements(one.then);
        return [...counted, { ...one, when: of(one.when), then, otherwise: this.statements(one.otherwise) }];
      }
      case 'for':
        return [
          ...this.#counted(one.body),
          { ...one, from: of(one.from), to: of(one.to), body: this.statements(one.body) },
        ];
      case 'while':
        return [...this.#counted(one.body), { ...one, when: of(one.when), body: this.statements(one.body) }];
    }
  }

  #put({ spans, comment }: Statement, value: Expression): readonly Statement[] {
    const put: Statement = { kind: 'set', to: element('byte', FRAME, this.length), value, spans, comment };
    if (this.length.kind !== 'number') return [put, { ...set(name('int', LENGTH), plus(this.length, 1)), spans }];
    this.length = int(this.length.value + 1);
    return [put];
  }

  /** What begins to count if a block puts a number of bytes that nobody knows before. */
  #counted(body: readonly Statement[]): readonly Statement[] {
    if (this.length.kind !== 'number' || !puts(body)) return [];
    const start: Statement = { kind: 'declare', name: LENGTH, value: this.length, changes: true };
    this.length = name('int', LENGTH);
    return [start];
  }
}

/** The expression with the number of bytes put so far in it. */
function replaced(expression: Expression, length: Expression): Expression {
  const of = (one: Expression) => replaced(one, length);
  switch (expression.kind) {
    case 'put so far':
      return length;
    case 'element':
      return { ...expression, index: of(expression.index) };
    case 'binary':
      return { ...expression, left: of(expression.left), right: of(expression.right) };
    case 'call': {
      const given = (one: Argument) => (one.kind === 'array' ? one : of(one));
      return { ...expression, arguments: expression.arguments.map(given) };
    }
    case 'not':
    case 'convert':
    case 'signed':
    case 'float':
    case 'floor':
      return { ...expression, of: of(expression.of) };
    default:
      return expression;
  }
}

/** The names in statements. */
export class Uses {
  readonly names = new Set<Name>();
  readonly calls = new Set<Name>();
  readonly kinds = new Set<Expression['kind']>();
  readonly locals = new Map<Name, Local>();

  statements(all: readonly Statement[]): void {
    for (const one of all) this.#statement(one);
  }

  #statement(one: Statement): void {
    switch (one.kind) {
      case 'declare':
        this.locals.set(one.name, { name: one.name, type: one.value.type });
        this.expression(one.value);
        break;
      case 'set':
        this.expression(one.to);
        this.expression(one.value);
        break;
      case 'put':
      case 'return':
        this.expression(one.value);
        break;
      case 'if':
        this.expression(one.when);
        this.statements(one.then);
        this.statements(one.otherwise);
        break;
      case 'for':
        this.locals.set(one.name, { name: one.name, type: 'int' });
        this.expression(one.from);
        this.expression(one.to);
        this.statements(one.body);
        break;
      case 'while':
        this.expression(one.when);
        this.statements(one.body);
        break;
      case 'remark':
    }
  }

  expression(one: Argument): void {
    this.kinds.add(one.kind as Expression['kind']);
    switch (one.kind) {
      case 'name':
        this.names.add(one.name);
        break;
      case 'array':
        this.names.add(one.array);
        break;
      case 'element':
        this.names.add(one.array);
        this.expression(one.index);
        break;
      case 'binary':
        this.expression(one.left);
        this.expression(one.right);
        break;
      case 'call':
        this.calls.add(one.routine);
        for (const argument of one.arguments) this.expression(argument);
        break;
      case 'not':
      case 'convert':
      case 'signed':
      case 'float':
      case 'floor':
        this.expression(one.of);
        break;
      default:
    }
  }
}
