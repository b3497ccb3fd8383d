import {
  compare,
  type Fraction,
  isBig,
  isNumberType,
  isTextType,
  type NumberTypeName,
  numberTypes,
  type Order,
  type Padding,
  shortestFloat,
  toNumber,
  type Value,
  type ValueType,
  type ValueWriting,
  writeValue,
} from '../../modbus/index.ts';
import { splitSign } from '../number.ts';
import { readExact } from './number-value.ts';
import { type InUnits, type UnitLimits, type UnitScale, writeInUnits } from './units.ts';

/** What is worth knowing before a value is written. */
export type ValueNote =
  /** The type holds only `stored` instead of what was typed. */
  | { readonly code: 'precision-lost'; readonly typed: string; readonly stored: string }
  | { readonly code: 'not-finite'; readonly typed: string }
  /** A value typed in a unit, and the number that stands for it. */
  | { readonly code: 'in-units'; readonly typed: string; readonly inUnits: InUnits };

/** Why a piece of the text is not a value. */
export type ValueFault =
  | { readonly code: 'value-missing' }
  /** Other values of this text have a type, this one has none. */
  | { readonly code: 'type-missing'; readonly typed: string }
  | { readonly code: 'name-unknown'; readonly name: string }
  | { readonly code: 'not-a-value'; readonly typed: string; readonly type: ValueType }
  /** Hexadecimal could be the bits of a float or its number. */
  | { readonly code: 'hex-float'; readonly typed: string }
  | { readonly code: 'quote-open' }
  | { readonly code: 'text-unquoted'; readonly typed: string }
  | { readonly code: 'refused'; readonly typed: string; readonly type: ValueType; readonly refusal: Refusal }
  /** `known` are the units that a value at this place may have. */
  | { readonly code: 'unit-unknown'; readonly unit: string; readonly known: readonly string[] }
  | { readonly code: 'outside-limits'; readonly typed: string; readonly limits: UnitLimits }
  | {
      readonly code: 'outside-type';
      readonly typed: string;
      readonly raw: Fraction;
      readonly type: NumberTypeName;
      readonly limits: UnitLimits;
    };

/** Why the type does not hold the value. */
type Refusal = Exclude<ValueWriting, { kind: 'registers' }>;

/** A value that was read, and the registers that hold it. */
export interface TypedValue {
  readonly type: ValueType;
  readonly order: Order;
  readonly value: Value;
  readonly registers: readonly number[];
  readonly notes: readonly ValueNote[];
}

/** What comes before the values of an item. */
export interface Head {
  type?: ValueType;
  order?: Order;
  padding?: Padding;
  room?: number;
}

/** Whether a text is written as a number. */
export const isNumeric = (text: string): boolean => readExact(text) !== undefined || readSpecial(text) !== undefined;

/** Reads one value as its item's names have it: a number, or a text in double quotes. */
export function readOne(text: string, { type: named, order = 'ABCD', padding, room }: Head): TypedValue | ValueFault {
  if (text.startsWith('"')) {
    const type = named ?? 'text';
    if (!/^"(?:[^"]|"")*"$/.test(text) || text === '"') return { code: 'quote-open' };
    if (isNumberType(type)) return { code: 'not-a-value', typed: text, type };
    const value = text.slice(1, -1).replaceAll('""', '"');
    return written(value, text, type, order, writeValue(value, type, order, { registers: room, padding }));
  }
  const type = named ?? 'u16';
  if (isTextType(type)) return { code: 'text-unquoted', typed: text };
  if (!isNumberType(type)) return written(text, text, type, order, writeValue(text, type, order));
  const value = readFor(text, type);
  if (typeof value === 'object') return value;
  return written(value, text, type, order, writeValue(value, type, order));
}

/** Reads a value in a unit. The item's names go before what is known of the unit. */
export function readWithUnit(text: string, known: UnitScale, head: Head): TypedValue | ValueFault {
  const type = head.type ?? known.type;
  const value = readExact(text)?.exactly;
  if (!isNumberType(type) || value === undefined) return { code: 'not-a-value', typed: text, type };
  const order = head.order ?? (type === known.type ? known.order : 'ABCD');
  const typed = `${text} ${known.unit}`;
  const writing = writeInUnits(value, { ...known, type, order });
  switch (writing.kind) {
    case 'outside-limits':
      return { code: 'outside-limits', typed, limits: writing.limits };
    case 'outside-type':
      return { code: 'outside-type', typed, raw: writing.raw, type, limits: writing.limits };
    case 'registers': {
      const { registers, inUnits } = writing;
      return { type, order, value: inUnits.raw, registers, notes: [{ code: 'in-units', typed, inUnits }] };
    }
  }
}

function written(
  value: Value,
  typed: string,
  type: ValueType,
  order: Order,
  writing: ValueWriting,
): TypedValue | ValueFault {
  if (writing.kind !== 'registers') return { code: 'refused', typed, type, refusal: writing };
  return { type, order, value, registers: writing.registers, notes: notesOn(value, typed, type, writing.stored) };
}

function notesOn(value: Value, typed: string, type: ValueType, stored: Value): ValueNote[] {
  if (!isNumberType(type) || numberTypes[type].kind !== 'float') return [];
  if (!Number.isFinite(Number(value))) return [{ code: 'not-finite', typed }];
  const text = shortestFloat(Number(stored), type);
  // Against the text: a double may have lost digits of it before the type is asked.
  const meant = readExact(typed)?.exactly;
  const kept = readExact(text)?.exactly;
  const same = meant !== undefined && kept !== undefined && compare(meant, kept) === 0;
  return same ? [] : [{ code: 'precision-lost', typed, stored: text }];
}

const SPECIAL: ReadonlyMap<string, number> = new Map([
  ['nan', Number.NaN],
  ['inf', Infinity],
  ['infinity', Infinity],
  ['∞', Infinity],
]);

const readSpecial = (text: string): number | undefined => {
  const name = text.toLowerCase();
  const size = SPECIAL.get(name.replace(/^[-−+]/, ''));
  return size !== undefined && /^[-−]/.test(name) ? -size : size;
};

/** A number for a type: exact where it is whole. */
function readFor(text: string, type: NumberTypeName): number | bigint | ValueFault {
  const { kind, least, most } = numberTypes[type];
  const special = readSpecial(text);
  if (special !== undefined) return special;
  const digits = text.replaceAll('_', '');
  // Bits are typed as they are shown, from the highest.
  if (kind === 'bits' && /^[01]{1,64}$/.test(digits) && digits.length <= 16 * numberTypes[type].registers)
    return isBig(type) ? BigInt(`0b${digits}`) : Number.parseInt(digits, 2);
  const read = readExact(text);
  if (read === undefined) return { code: 'not-a-value', typed: text, type };
  if (kind === 'float') {
    if (read.based) return { code: 'hex-float', typed: text };
    const { negative, body } = splitSign(text);
    const got = (negative ? -1 : 1) * Number(body);
    return Number.isFinite(got)
      ? got
      : { code: 'refused', typed: text, type, refusal: { kind: 'out-of-range', got, least, most } };
  }
  const { numerator, denominator } = read.exactly;
  if (denominator !== 1n) {
    return { code: 'refused', typed: text, type, refusal: { kind: 'not-whole', got: toNumber(read.exactly) } };
  }
  // A number that a double cannot hold exactly is outside the limits of all smaller types.
  const meant = read.based ? bitsMeant(numerator, type) : numerator;
  return isBig(type) ? meant : Number(meant);
}

/** Hexadecimal and binary of a signed type are its bits, as in every master: 0xFFFF is −1 as i16. */
function bitsMeant(number: bigint, type: NumberTypeName): bigint {
  const { kind, least, most } = numberTypes[type];
  const [first, last] = [BigInt(least), BigInt(most)];
  const isTwos = kind === 'integer' && first === -last - 1n;
  return isTwos && number > last && number < 2n * (last + 1n) ? number - 2n * (last + 1n) : number;
}
