import type { Fault, Section } from './problem.ts';
import type { FieldKind, Span } from './span.ts';

/** The values of a frame by field name. */
export type Values = Readonly<Record<string, unknown>>;

/** Values that replace what the encoder would derive: a number, or bytes verbatim as hexadecimal pairs. */
export type Force = Readonly<Record<string, number | string>>;

/** What is known of a frame while its fields are read in order; a rule sees the same. */
export interface Seen {
  /** What a person chooses. */
  readonly fields: Record<string, unknown>;
  /** The number of bytes stated by the byte count read last, and of items by the quantity that belongs to a list. */
  readonly count: number;
  readonly items: number;
  /** The request that this frame answers, if it is known and has the same function. */
  readonly request: { readonly fields: Values; readonly derived: Values } | undefined;
  /** Values the bytes hold and the encoder would not have written. */
  readonly forced: Force;
  /** Adds to `forced`. */
  force(name: string, value: number | string): void;
  /** Adds a problem found inside a field. */
  report(fault: Fault, span: Span): void;
}

/**
 * One rule about a value that has bytes; it answers `undefined` if the value keeps it. Typed as a method, so that fields of
 * any value fit into one list.
 */
export type Rule<T> = { rule(value: T, seen: Seen): Fault | undefined }['rule'];

/** The smallest and the largest legal value of a number, and what it is called to be outside. */
export interface Range {
  readonly least: number;
  readonly most: number;
  readonly code: 'quantity-out-of-range' | 'count-out-of-range' | 'value-out-of-range';
}

/**
 * One field of a function's request or reply. Both walkers, the form, the limits and the explanation follow from it.
 * All fields are of this one shape, so that the walkers stay fast.
 */
export interface Field<N extends string = string, T = unknown> {
  readonly name: N;
  readonly kind: FieldKind;
  /** Bytes of a field of fixed width, else 0: a list, or bytes whose number other fields or the frame's end decide. */
  readonly width: number;
  /** Whether no byte says where the field ends, so that it takes all the bytes there are. */
  readonly open: boolean;
  /** The number of bytes that an open field usually takes; 0 if no number is usual. */
  readonly usual: number;
  /** Legal range of a number, if it is narrower than the width of the field allows. */
  readonly range: Range | undefined;
  /** Legal values of a choice. */
  readonly allowed: readonly number[] | undefined;
  /** The fields of one group, for `groups`. */
  readonly group: readonly Field[] | undefined;
  readonly rules: readonly Rule<T>[];
  /** Rules of a reply against its request, for when that is known. */
  readonly replyRules: readonly Rule<T>[];
  /** Whether it is a plain number of `width` bytes, high byte first. */
  readonly plain: boolean;
  /** The bytes this field takes from `at`, given what was read before; more than `end − at` if some are missing. */
  size(bytes: Uint8Array, at: number, end: number, seen: Seen): number;
  /** How many of `bytes[at, to)` make whole items; the bytes after them belong to no item. */
  whole(bytes: Uint8Array, at: number, to: number): number;
  read(bytes: Uint8Array, from: number, to: number, seen: Seen): T;
  /** The value as the encoder takes it; throws a `FrameError` if the value has no bytes. */
  accept(value: unknown, path: string): T;
  /** The bytes an accepted value takes. */
  length(value: T): number;
  write(out: Uint8Array, at: number, value: T, force: Force | undefined): void;
  /** For a field that the encoder derives: its value from the others, or `undefined` if one of them is missing. */
  readonly derive: ((fields: Values) => T | undefined) | undefined;
  /** For groups counted by number: what it means that the frame ends cleanly after fewer than `by` states. */
  readonly fewer: { readonly by: string; readonly fault: (seen: Seen) => Fault } | undefined;
}

/** What is wrong with a number outside its field's range. */
export function outOfRange({ range }: Field, value: unknown): Fault | undefined {
  if (range === undefined) return undefined;
  const { least, most, code } = range;
  const got = value as number;
  return got < least || got > most ? { code, severity: 'error', got, least, most } : undefined;
}

type Needed = 'kind' | 'read' | 'accept' | 'write';
type FieldParts<N extends string, T> = Pick<Field<N, T>, Needed> & Partial<Omit<Field<N, T>, Needed | 'name'>>;

/** Makes a field from the parts that are its own. */
export function defineField<N extends string, T>(name: N, parts: FieldParts<N, T>): Field<N, T> {
  const width = parts.width ?? 0;
  // One literal with every part, in one order: to the engine, all fields are of one shape.
  return {
    name,
    kind: parts.kind,
    width,
    plain: parts.plain ?? false,
    open: parts.open ?? false,
    usual: parts.usual ?? 0,
    range: parts.range,
    allowed: parts.allowed,
    group: parts.group,
    rules: parts.rules ?? [],
    replyRules: parts.replyRules ?? [],
    size: parts.size ?? (() => width),
    whole: parts.whole ?? ((_bytes, at, to) => to - at),
    read: parts.read,
    accept: parts.accept,
    length: parts.length ?? (() => width),
    write: parts.write,
    derive: parts.derive,
    fewer: parts.fewer,
  };
}

/**
 * The end of a layout's list of fields, if a value that was read decides which fields follow: the chosen layout continues.
 */
export interface Choice {
  readonly by: string;
  readonly cases: Readonly<Record<number, Layout>>;
  readonly otherwise: Layout;
}

/** The fields of a request or a reply in the order of their bytes. */
export interface Layout<F extends readonly Field[] = readonly Field[]> {
  readonly fields: F;
  /** Those that the encoder works out: at most one byte count and one quantity. */
  readonly derived: readonly Field[];
  readonly then: Choice | undefined;
  /** Where it stands, if not in the function's own section. */
  readonly section: Section | undefined;
}

export function layout<const F extends readonly Field[]>(fields: F, then?: Choice, section?: Section): Layout<F> {
  return { fields, derived: fields.filter(({ derive }) => derive !== undefined), then, section };
}

/**
 * The layout that continues after this one, given the fields read so far; `undefined` if there is no choice or its value is
 * absent.
 */
export function next({ then }: Layout, fields: Values): Layout | undefined {
  const value = then && fields[then.by];
  return typeof value === 'number' ? (then?.cases[value] ?? then?.otherwise) : undefined;
}

/** The values that the fields of a layout have, by name, without those of a choice that follows. */
export type ValuesOf<F extends readonly Field[]> = {
  readonly [One in F[number] as One['name']]: One extends Field<string, infer T> ? T : never;
};

interface Laid {
  readonly section: Section;
  readonly request: Layout;
  readonly response: Layout;
}

/** A field, and the section that lays it down. */
export interface PlacedField {
  readonly field: Field;
  readonly section: Section;
}

/**
 * The fields of a request or reply in the order of their bytes, through the choices that its values make. `values` may be
 * filled in during the walk: a choice reads its value only after the fields before it.
 */
export function* fieldsOf(
  description: Laid | undefined,
  direction: 'request' | 'response',
  values: Values,
): Generator<PlacedField, void, undefined> {
  for (let layout = description?.[direction]; layout !== undefined; layout = next(layout, values)) {
    const section = layout.section ?? (description as Laid).section;
    for (const field of layout.fields) yield { field, section };
  }
}
