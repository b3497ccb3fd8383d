import type { Code, Name, Statement } from '../../../src/codegen/code.ts';
import type { Plan } from '../../../src/codegen/plan.ts';
import { namesIn } from '../../../src/codegen/routines/used.ts';

/** Variables that are declared in statements, wherever they stand. */
function declaredIn(body: readonly Statement[]): readonly Name[] {
  return body.flatMap((one) => {
    if (one.kind === 'declare') return [one.name];
    if (one.kind === 'if') return [...declaredIn(one.then), ...declaredIn(one.otherwise)];
    return one.kind === 'for' || one.kind === 'while' ? declaredIn(one.body) : [];
  });
}

/** Names that a list is written into, too. */
const filledIn = (body: readonly Statement[]): readonly Name[] =>
  body.flatMap((one) => {
    if (one.kind === 'set') return one.to.kind === 'element' ? [one.to.array] : [];
    if (one.kind === 'if') return [...filledIn(one.then), ...filledIn(one.otherwise)];
    return one.kind === 'for' || one.kind === 'while' ? filledIn(one.body) : [];
  });

/** What is written and not used: parameters, variables, routines, tables and constants. */
export function unusedIn({
  code,
  requests,
  sequence,
}: Pick<Plan, 'code' | 'requests' | 'sequence'>): readonly string[] {
  const inside = code.routines.flatMap(({ name, parameters, body }) => {
    const used = new Set([...namesIn(body), ...filledIn(body)]);
    const all = [...parameters.map((one) => one.name), ...declaredIn(body)];
    return all.filter((one) => !used.has(one)).map((one) => `${name}: ${one}`);
  });
  const called = new Set([
    ...code.routines.flatMap(({ body }) => [...namesIn(body)]),
    ...requests.flatMap(({ table, build, check, wanted, items, values, arguments: given }) => [
      table ?? '',
      build ?? '',
      check ?? '',
      wanted ?? '',
      items?.routine ?? '',
      ...values.map(({ routine }) => routine),
      ...given.flatMap(({ scaled }) => (scaled ?? []).map(({ routine }) => routine)),
    ]),
    ...[...JSON.stringify(sequence ?? {}).matchAll(/"holds":"([^"]*)"/g)].map(([, name = '']) => name),
  ]);
  const parts: readonly (keyof Code)[] = ['constants', 'tables', 'routines'];
  return [
    ...inside,
    ...parts.flatMap((part) => code[part].map(({ name }) => name)).filter((name) => !called.has(name)),
  ];
}
