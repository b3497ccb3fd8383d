import { defineField, type Field, outOfRange, type Rule, type Seen, type Values, type ValuesOf } from '../field.ts';
import { FrameError } from '../frame-error.ts';
import type { Fault } from '../problem.ts';
import { Span } from '../span.ts';
import { acceptList } from './registers.ts';

/** One group of a repeated field as it stands in the bytes. */
export interface Group {
  readonly from: number;
  readonly to: number;
  readonly fields: Record<string, unknown>;
  readonly derived: Record<string, unknown>;
  readonly spans: readonly Span[];
  /** Rules broken inside the group, with the span each sits on. */
  readonly faults: readonly { readonly fault: Fault; readonly span: Span }[];
}

/** The groups of `bytes[at, end)`, as far as they hold together. */
export function readGroups(group: readonly Field[], bytes: Uint8Array, at: number, end: number): readonly Group[] {
  const groups: Group[] = [];
  let from = at;
  while (from < end) {
    const read = readGroup(group, bytes, from, end);
    if (read === undefined) break;
    groups.push(read);
    from = read.to;
  }
  return groups;
}

const ignore = () => undefined;
const widthOf = (group: readonly Field[]) => group.reduce((sum, { width }) => sum + width, 0);

function readGroup(group: readonly Field[], bytes: Uint8Array, from: number, end: number): Group | undefined {
  const fields: Record<string, unknown> = {};
  const derived: Record<string, unknown> = {};
  const seen = { fields, count: 0, items: 0, request: undefined, forced: {}, force: ignore, report: ignore };
  const spans: Span[] = [];
  const faults: { fault: Fault; span: Span }[] = [];
  let at = from;
  for (let i = 0; i < group.length; i++) {
    const field = group[i] as Field;
    const size = field.size(bytes, at, end, seen);
    if (size < 0 || size > end - at || field.whole(bytes, at, at + size) !== size) return undefined;
    const span = new Span(field.name, field.kind, at, at + size);
    const value = field.read(bytes, at, at + size, seen);
    (field.derive ? derived : fields)[field.name] = value;
    if (field.kind === 'count') seen.count = value as number;
    else if (field.derive) seen.items = value as number;
    const wrong = outOfRange(field, value);
    if (wrong) faults.push({ fault: wrong, span });
    for (const rule of field.rules) {
      const fault = rule(value, seen);
      if (fault) faults.push({ fault, span });
    }
    spans.push(span);
    at += size;
  }
  return { from, to: at, fields, derived, spans, faults };
}

interface GroupsParts {
  /** Where a byte count decides: the bytes all groups take. */
  readonly size?: (seen: Seen) => number;
  /** Where a number of groups decides. */
  readonly number?: (seen: Seen) => number;
  readonly fewer?: NonNullable<Field['fewer']>;
  readonly rules?: readonly Rule<readonly Values[]>[];
  readonly replyRules?: readonly Rule<readonly Values[]>[];
  /** Turns the fields of a group as read into those a person sees, and back. */
  readonly show?: (fields: Values) => Values;
  readonly hide?: (fields: Values, path: string) => Values;
}

/** A list of groups of fields, as an array of objects. Bytes after the last group that holds together are not taken. */
export function groups<N extends string, const F extends readonly Field[]>(name: N, group: F, parts: GroupsParts) {
  const {
    size,
    number,
    fewer,
    rules = [],
    replyRules = [],
    show = (fields) => fields,
    hide = (fields) => fields,
  } = parts;
  const field = defineField<N, readonly Values[]>(name, {
    kind: 'groups',
    group,
    rules,
    replyRules,
    ...(fewer && { fewer }),
    size: (bytes, at, end, seen) => (size ? size(seen) : sizeOfGroups(group, bytes, at, end, number?.(seen) ?? 0)),
    whole: (bytes, at, to) => {
      const read = readGroups(group, bytes, at, to);
      return (read[read.length - 1]?.to ?? at) - at;
    },
    read: (bytes, from, to, seen) =>
      readGroups(group, bytes, from, to).map(({ fields, faults }) => {
        for (const { fault, span } of faults) seen.report(fault, span);
        return show(fields);
      }),
    accept: (value, path) => {
      const list = acceptList(value, path);
      return list.map((item, i) => acceptGroup(group, item, `${path}[${i}]`, hide));
    },
    length: (values) => values.reduce((sum, item) => sum + sumOfLengths(group, item), 0),
    write: (out, at, values) => {
      let next = at;
      for (const item of values) {
        for (const field of group) {
          const value = item[field.name];
          field.write(out, next, value, undefined);
          next += field.length(value);
        }
      }
    },
  });
  // Each item has what the group's fields read.
  return field as Field<N, readonly ValuesOf<F>[]>;
}

/** The number of bytes that `number` groups take; a lower bound if the bytes end before the last group. */
function sizeOfGroups(group: readonly Field[], bytes: Uint8Array, at: number, end: number, number: number): number {
  const least = widthOf(group);
  let taken = 0;
  for (let left = number; left > 0; left--) {
    const size = at + taken < end ? sizeOfGroup(group, bytes, at + taken, end) : least;
    if (size > end - at - taken) return taken + Math.max(size, least) + (left - 1) * least;
    taken += size;
  }
  return taken;
}

/** The number of bytes that the group at `from` takes; a lower bound if the bytes end in it. Lists in it are not read. */
function sizeOfGroup(group: readonly Field[], bytes: Uint8Array, from: number, end: number): number {
  const seen = { fields: {}, count: 0, items: 0, request: undefined, forced: {}, force: ignore, report: ignore };
  let at = from;
  for (let i = 0; i < group.length; i++) {
    const field = group[i] as Field;
    const size = field.width || field.size(bytes, at, end, seen);
    if (size > end - at) return at - from + size + widthOf(group.slice(i + 1));
    if (field.kind === 'count') seen.count = field.read(bytes, at, at + size, seen) as number;
    else if (field.derive) seen.items = field.read(bytes, at, at + size, seen) as number;
    at += size;
  }
  return at - from;
}

const sumOfLengths = (group: readonly Field[], item: Values) =>
  group.reduce((sum, field) => sum + field.length(item[field.name]), 0);

function acceptGroup(
  group: readonly Field[],
  item: unknown,
  path: string,
  hide: (fields: Values, path: string) => Values,
): Values {
  if (typeof item !== 'object' || item === null) throw new FrameError(path, { code: 'not-a-list', got: item });
  const fields = hide(item as Values, path);
  const accepted: Record<string, unknown> = {};
  const accept = (field: Field, value: unknown) => {
    accepted[field.name] = field.accept(value, `${path}.${field.name}`);
  };
  // What is derived comes last, so that what is missing is named itself.
  for (const field of group) if (!field.derive) accept(field, fields[field.name]);
  for (const field of group) if (field.derive) accept(field, field.derive(fields));
  return accepted;
}
