import { defineField, type Field, type Range, type Rule, type Values } from '../field.ts';
import { FrameError } from '../frame-error.ts';
import type { Severity } from '../problem.ts';
import type { FieldKind } from '../span.ts';

/** The value as a whole number from `least` to `most`; throws a `FrameError` for anything else. */
export function wholeNumber(value: unknown, path: string, least: number, most: number): number {
  if (value === undefined) throw new FrameError(path, { code: 'field-missing' });
  if (typeof value !== 'number' || !Number.isInteger(value) || value < least || value > most) {
    throw new FrameError(path, { code: 'number-out-of-range', least, most, got: value });
  }
  return value;
}

interface NumberParts {
  readonly kind?: FieldKind;
  readonly range?: Range;
  readonly allowed?: readonly number[];
  readonly rules?: readonly Rule<number>[];
  readonly replyRules?: readonly Rule<number>[];
  readonly derive?: (fields: Values) => number | undefined;
}

function numberField<N extends string>(name: N, width: 1 | 2, parts: NumberParts): Field<N, number> {
  const most = width === 1 ? 0xff : 0xffff;
  return defineField<N, number>(name, {
    kind: 'number',
    ...parts,
    width,
    plain: true,
    read: width === 1 ? readU8 : readU16,
    accept: (value, path) => wholeNumber(value, path, 0, most),
    write: width === 1 ? writeU8 : writeU16,
  });
}

const readU8 = (bytes: Uint8Array, at: number) => bytes[at] as number;
const readU16 = (bytes: Uint8Array, at: number) => ((bytes[at] as number) << 8) | (bytes[at + 1] as number);
const writeU8 = (out: Uint8Array, at: number, value: number) => {
  out[at] = value;
};
const writeU16 = (out: Uint8Array, at: number, value: number) => {
  out[at] = value >>> 8;
  out[at + 1] = value & 0xff;
};

/** A byte. */
export const u8 = <N extends string>(name: N, parts: NumberParts = {}) => numberField(name, 1, parts);

/** A 16-bit number, high byte first (AP 4.2). */
export const u16 = <N extends string>(name: N, parts: NumberParts = {}) => numberField(name, 2, parts);

/** A 16-bit address counted from zero (AP 4.4). */
export const address = <N extends string>(name: N, replyRules: readonly Rule<number>[] = []) =>
  u16(name, { kind: 'address', replyRules });

/** A byte or 16-bit number of which only the listed values are legal. */
export function choice<N extends string>(
  name: N,
  allowed: readonly number[],
  { width = 1, replyRules = [] }: { width?: 1 | 2; replyRules?: readonly Rule<number>[] } = {},
): Field<N, number> {
  const known: Rule<number> = (got) =>
    allowed.includes(got) ? undefined : { code: 'value-not-allowed', severity: 'error', got, allowed };
  return numberField(name, width, { kind: 'choice', allowed, rules: [known], replyRules });
}

/** The range of a number. */
export const within = (least: number, most: number): Range => ({ least, most, code: 'value-out-of-range' });

interface QuantityParts {
  readonly least: number;
  readonly most: number;
  /** The field with the first address, whose range must not pass 65535. */
  readonly from: string;
  readonly derive?: (fields: Values) => number | undefined;
  /** A lower limit of old controllers, worth a note (PI App. B). */
  readonly oldLimit?: number;
  readonly replyRules?: readonly Rule<number>[];
}

/** How many registers, coils or inputs: its limits, and address + quantity ≤ 65536 (AP 4.4; AP 7, code 02). */
export function quantity<N extends string>(name: N, parts: QuantityParts): Field<N, number> {
  const { least, most, from, derive, oldLimit, replyRules = [] } = parts;
  const rules: Rule<number>[] = [
    (got, { fields }) => {
      const first = fields[from] as number;
      return first + got > 0x10000
        ? { code: 'address-range-over-end', severity: 'error', address: first, quantity: got, section: 'AP 4.4' }
        : undefined;
    },
  ];
  if (oldLimit !== undefined) {
    rules.push((got) =>
      got > oldLimit && got <= most
        ? { code: 'old-controller-limit', severity: 'note', got, limit: oldLimit, section: 'PI App. B' }
        : undefined,
    );
  }
  const range = { least, most, code: 'quantity-out-of-range' } as const;
  return u16(name, { kind: 'quantity', range, rules, replyRules, ...(derive && { derive }) });
}

/** The fields of a request that reads the first element of a table. */
export const oneElement = { startAddress: 0, quantity: 1 } as const;

interface CountParts {
  readonly least: number;
  readonly most: number;
  readonly derive: (fields: Values) => number | undefined;
  readonly width?: 1 | 2;
  /** `count` (the default) counts bytes, `quantity` items. */
  readonly kind?: 'count' | 'quantity';
  readonly rules?: readonly Rule<number>[];
  readonly replyRules?: readonly Rule<number>[];
}

/** A count or length that the encoder works out from the field it counts. */
export function count<N extends string>(name: N, parts: CountParts): Field<N, number> {
  const { least, most, derive, width = 1, kind = 'count', rules = [], replyRules = [] } = parts;
  const range = { least, most, code: 'count-out-of-range' } as const;
  return numberField(name, width, { kind, range, rules, replyRules, derive });
}

/** The rule that a byte count is even: registers have two bytes. */
export const even: Rule<number> = (got) => (got % 2 === 0 ? undefined : { code: 'count-odd', severity: 'error', got });

/** The rule that a byte count is what a quantity read before it needs. */
export const fitsQuantity =
  (bytesFor: (quantity: number) => number): Rule<number> =>
  (got, { items: quantity }) => {
    const expected = bytesFor(quantity);
    return got === expected
      ? undefined
      : { code: 'count-contradicts-quantity', severity: 'error', got, expected, quantity };
  };

/** The rule that a reply's byte count is what its request asked for. */
export const fitsRequest =
  (name: string, bytesFor: (quantity: number) => number): Rule<number> =>
  (got, { request }) => {
    const asked = request?.fields[name];
    if (typeof asked !== 'number') return undefined;
    const expected = bytesFor(asked);
    return got === expected ? undefined : { code: 'count-not-as-requested', severity: 'error', got, expected };
  };

/** The rule that a reply repeats the request's field of this name. */
export const echoes =
  (field: string, severity: Severity = 'error'): Rule<unknown> =>
  (value, { request }) => {
    if (request === undefined) return undefined;
    const asked = Object.hasOwn(request.fields, field) ? request.fields[field] : request.derived[field];
    return asked === undefined || same(asked, value) ? undefined : { code: 'echo-differs', severity, field };
  };

function same(a: unknown, b: unknown): boolean {
  return a === b || (typeof a === 'object' && JSON.stringify(a) === JSON.stringify(b));
}

/** The sum over the groups of a list field; `undefined` if it is not a list of groups. */
export const sumOf =
  (name: string, of: (group: Values) => number) =>
  (fields: Values): number | undefined => {
    const list = fields[name];
    const isGroup = (group: unknown): group is Values => typeof group === 'object' && group !== null;
    return Array.isArray(list) && list.every(isGroup) ? list.reduce((sum, group) => sum + of(group), 0) : undefined;
  };

/** The bytes of a list of registers in a group. */
export const bytesOfList = (list: unknown): number => (Array.isArray(list) ? bytesOfRegisters(list.length) : 0);

export const bytesOfBits = (bits: number): number => Math.ceil(bits / 8);
export const bytesOfRegisters = (registers: number): number => 2 * registers;

/** The number of items of a list field, for deriving counts; `undefined` if there is no list. */
export const lengthOf =
  (name: string, of: (items: number) => number = (items) => items) =>
  (fields: Values): number | undefined => {
    const list = fields[name];
    return Array.isArray(list) ? of(list.length) : undefined;
  };
