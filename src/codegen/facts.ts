import { type Field, fieldsOf, fromHex, type Reading, type Values } from '../modbus/index.ts';

/**
 * What a function's description holds in closures, found by asking them: how a count follows from a list, how long a list is by
 * its count, what a reply repeats of its request and how much of it was asked for. A function that is added needs nothing here.
 * @module
 */

/** A number that follows from another, n: `times × n / by`, rounded up, and `plus`. */
export interface Formula {
  readonly times: number;
  readonly by: 1 | 8;
  readonly plus: number;
}

export const resultOf = ({ times, by, plus }: Formula, n: number): number => Math.ceil((times * n) / by) + plus;

/** The formula by which `ask` answers; `undefined` if it answers no number, or by none of the forms. */
export function formulaOf(ask: (n: number) => number | undefined): Formula | undefined {
  const asked = [1, 2, 8, 9, 17, 40].map((n) => [n, ask(n)] as const);
  const [one, two] = [asked[0]?.[1], asked[1]?.[1]];
  if (one === undefined || two === undefined) return undefined;
  const forms: Formula[] = [
    { times: two - one, by: 1, plus: 2 * one - two },
    { times: 1, by: 8, plus: one - 1 },
  ];
  return forms.find((form) => asked.every(([n, got]) => got === resultOf(form, n)));
}

/** Values of `n` items that a list field takes, by kind. */
const SAMPLES: Readonly<Partial<Record<Field['kind'], (n: number) => unknown>>> = {
  registers: (n) => new Array<number>(n).fill(0),
  bits: (n) => new Array<number>(n).fill(0),
  list: (n) => new Array<number>(n).fill(0),
  bytes: (n) => '00'.repeat(n),
};

export const isList = ({ kind, width, group }: Field): boolean =>
  width === 0 && (group !== undefined || SAMPLES[kind] !== undefined);

/** How the value of a derived field follows from the number of items of a list among the others; of groups too. */
export function countOf(
  field: Field,
  others: readonly Field[],
): { readonly of: Field; readonly by: Formula } | undefined {
  for (const of of others) {
    const sample = of.group ? (n: number) => new Array<Values>(n).fill({}) : SAMPLES[of.kind];
    if (of.width > 0 || sample === undefined) continue;
    const by = formulaOf((n) => field.derive?.({ [of.name]: sample(n) }) as number | undefined);
    if (by !== undefined) return { of, by };
  }
  return undefined;
}

/** What decides how many bytes a list takes. */
export type Size =
  | { readonly by: 'count' | 'items'; readonly formula: Formula }
  | { readonly by: 'constant'; readonly bytes: number }
  /** So many groups as `items` says, each as long as its own fields say. */
  | { readonly by: 'groups' }
  /** It takes all that there is. */
  | { readonly by: 'end' };

/** More bytes than any list takes that is asked for. */
const zeros = (): Uint8Array => new Uint8Array(256);
const nothing = () => undefined;
const NO_VALUES: Values = Object.freeze({});
const seen = (count: number, items: number, request?: { fields: Values; derived: Values }) => ({
  fields: {},
  count,
  items,
  request,
  forced: {},
  force: nothing,
  report: nothing,
});

/** How long a list is. Counts are asked from 8 on, where what they count beside the list is less. */
export function sizeOf(field: Field): Size {
  if (field.open) return { by: 'end' };
  const bytes = zeros();
  const size = (count: number, items: number) => field.size(bytes, 0, bytes.length, seen(count, items));
  const far = (ask: (n: number) => number): Formula | undefined => {
    const form = formulaOf((n) => ask(n + FAR));
    return form && { ...form, plus: form.plus - form.times * FAR };
  };
  const [still, byCount, byItems] = [size(FAR, FAR), size(FAR + 8, FAR), size(FAR, FAR + 8)];
  if (byCount !== still) {
    const formula = far((n) => size(n, FAR));
    if (formula?.by === 1) return { by: 'count', formula };
  } else if (byItems !== still) {
    if (field.group !== undefined) return { by: 'groups' };
    const formula = formulaOf((n) => size(FAR, n));
    if (formula !== undefined) return { by: 'items', formula };
  } else return { by: 'constant', bytes: still };
  return { by: 'end' };
}

/** More than any count has beside its list. */
const FAR = 16;

/** A number in a request: its field, and the index of its group and the name of the list, if it is in one. */
export interface Leaf {
  readonly name: string;
  readonly group?: { readonly list: string; readonly index: number } | undefined;
  readonly field: Field;
}

/** The plain numbers of a request that are not derived. */
export function leavesOf({ description, fields }: Reading): readonly Leaf[] {
  const leaves: Leaf[] = [];
  for (const { field } of fieldsOf(description, 'request', fields)) {
    const list = fields[field.name];
    if (field.group !== undefined && Array.isArray(list)) {
      const inner = field.group.filter((one) => one.plain && !one.derive);
      leaves.push(
        ...list.flatMap((_, index) =>
          inner.map((one) => ({ name: one.name, group: { list: field.name, index }, field: one })),
        ),
      );
    } else if (field.plain && field.derive === undefined) leaves.push({ name: field.name, field });
  }
  return leaves;
}

/** The fields of a request with one number changed. */
function withLeaf(fields: Values, { name, group }: Leaf, value: number): Values {
  if (group === undefined) return { ...fields, [name]: value };
  const list = fields[group.list] as readonly Values[];
  return {
    ...fields,
    [group.list]: list.map((item, index) => (index === group.index ? { ...item, [name]: value } : item)),
  };
}

/** The fault that a reply's rule finds in a value, with this request, and these fields of the reply. */
const faultOf = (
  field: Field,
  value: unknown,
  request: { fields: Values; derived: Values },
  fields: Values = NO_VALUES,
) =>
  field.replyRules
    .map((rule) => rule(value, { ...seen(0, 0, request), fields: { ...fields } }))
    .find((fault) => fault?.severity === 'error') as
    | { readonly code: string; readonly [data: string]: unknown }
    | undefined;

/** Values of which a request has one at most. */
const OTHERS = [Symbol('other'), true, false];

/** The field of the request that a field of its reply repeats, by name; `undefined` if it repeats none. */
export function echoOf(field: Field, { fields, derived }: Reading): string | undefined {
  if (field.replyRules.length === 0 || field.group !== undefined) return undefined;
  const faults = OTHERS.map((other) => faultOf(field, other, { fields, derived }));
  const fault = faults.find((one) => one?.code === 'echo-differs');
  return fault && String(fault['field']);
}

/** Whether a list of groups must be the request's own. */
export function echoesGroups(field: Field, { fields, derived }: Reading): boolean {
  if (field.group === undefined || field.replyRules.length === 0) return false;
  const fault = faultOf(field, [], { fields, derived });
  return fault?.code === 'echo-differs' && fault['field'] === field.name;
}

/** A reply that has one group only, which repeats a number of the request; `when` a choice in both has a value. */
export interface OneGroup {
  readonly repeats: string;
  readonly when: { readonly name: string; readonly value: number } | undefined;
}

/** Whether the groups of a reply are one, that is known by a number of the request; `undefined` if they may be any. */
export function oneGroupOf(field: Field, { description, fields, derived }: Reading): OneGroup | undefined {
  const repeats = field.group?.find(({ name, plain }) => plain && typeof fields[name] === 'number')?.name;
  if (repeats === undefined || field.replyRules.length === 0) return undefined;
  const other = [{ [repeats]: Number.NaN }];
  const isAsked = (asked: Values) => faultOf(field, other, { fields: asked, derived }, asked)?.code === 'echo-differs';
  for (const { field: choice } of fieldsOf(description, 'request', fields)) {
    if (choice.name === repeats || choice.allowed === undefined) continue;
    const values = choice.allowed.filter((value) => isAsked({ ...fields, [choice.name]: value }));
    if (values.length > 0 && values.length < choice.allowed.length)
      return { repeats, when: { name: choice.name, value: values[0] as number } };
  }
  return isAsked(fields) ? { repeats, when: undefined } : undefined;
}

/**
 * How long the list in each group of a reply is by the request: a formula of a number of the request's group of the same
 * index. `count` is what the count before the groups must be.
 */
export function groupLengths(
  field: Field,
  count: Field,
  reading: Reading,
): { readonly leaf: string; readonly formula: Formula } | undefined {
  const inner = field.group?.find(({ kind }) => kind === 'registers');
  const leaves = leavesOf(reading).filter(({ group }) => group !== undefined);
  const first = leaves[0]?.group;
  const several = first && (reading.fields[first.list] as readonly Values[]);
  if (inner === undefined || several === undefined || field.rules.length === 0) return undefined;
  for (const { name } of leaves.filter(({ group }) => group?.index === 0)) {
    const formula = formulaOf((n) => {
      // Two groups that are asked for, of which the first has another length.
      const [one] = several;
      const asked = {
        ...reading.fields,
        [first?.list ?? '']: [
          { ...one, [name]: n },
          { ...one, [name]: n },
        ],
      };
      const total = faultOf(count, -1, { fields: asked, derived: reading.derived });
      const groups = [{ [inner.name]: [] }, { [inner.name]: [] }];
      const request = { fields: asked, derived: reading.derived };
      const rule = field.rules
        .map((one) => one(groups, seen(Number(total?.['expected']), 0, request)))
        .find((fault) => fault?.code === 'count-not-as-requested') as { readonly expected?: number } | undefined;
      return rule?.expected;
    });
    if (formula !== undefined && formula.times > 0) return { leaf: name, formula };
  }
  return undefined;
}

/** What a count of the reply must be: a sum of terms, each a formula of a number of the request. */
export interface Expected {
  readonly terms: readonly { readonly leaf: Leaf; readonly formula: Formula }[];
  readonly plus: number;
}

/** What was asked for, as the count of a reply must be; `undefined` if the request does not decide it. */
export function expectedOf(field: Field, reading: Reading): Expected | undefined {
  const { fields, derived } = reading;
  const ask = (asked: Values) => {
    const fault = faultOf(field, -1, { fields: asked, derived });
    return fault?.code === 'count-not-as-requested' ? Number(fault['expected']) : undefined;
  };
  if (field.replyRules.length === 0 || ask(fields) === undefined) return undefined;
  const terms: { leaf: Leaf; formula: Formula }[] = [];
  for (const leaf of leavesOf(reading)) {
    const formula = formulaOf((n) => ask(withLeaf(fields, leaf, n)));
    if (formula === undefined) return undefined;
    if (formula.times !== 0) terms.push({ leaf, formula: { ...formula, plus: 0 } });
  }
  const zero = terms.reduce((all, { leaf }) => withLeaf(all, leaf, 0), fields);
  return { terms, plus: ask(zero) ?? 0 };
}

/** The number of the request that says how many bits of a reply count; `undefined` if none does. */
export function bitsAskedBy(field: Field, reading: Reading): Leaf | undefined {
  const many = (fields: Values) =>
    (field.read(zeros(), 0, 2, seen(2, 0, { fields, derived: reading.derived })) as readonly unknown[]).length;
  return leavesOf(reading).find(
    (leaf) => many(withLeaf(reading.fields, leaf, 11)) === 11 && many(withLeaf(reading.fields, leaf, 12)) === 12,
  );
}

/** The bytes of a field of two bytes for `true` and for `false`. */
export function flagBytes(field: Field): { readonly on: readonly number[]; readonly off: readonly number[] } {
  const write = (value: boolean) => {
    const out = new Uint8Array(field.width);
    field.write(out, 0, value, undefined);
    return [...out];
  };
  return { on: write(true), off: write(false) };
}

/** Whether the request is one that a device that follows the specification never answers. */
export function isSilent({ description, fields }: Reading): boolean {
  for (const { field } of fieldsOf(description, 'response', fields))
    if (field.rules.some((rule) => rule(fields[field.name], seen(0, 0))?.code === 'sub-function-without-reply'))
      return true;
  return false;
}

/** The bytes of a value of raw bytes. */
export const bytesOf = (value: unknown): readonly number[] => [...(fromHex(String(value)) ?? [])];
