import { formTypes } from './form-types.ts';
import type { NumberType, Value } from './number-type.ts';
import { fromRegisters, type Order, toRegisters } from './order.ts';
import { type Padding, readText, type TextReading, type TextRoom, type TextWriting, writeText } from './text.ts';
import {
  isFormType,
  isNumberType,
  isTextType,
  type NumberTypeName,
  numberTypes,
  registersOf,
  type ValueType,
} from './types.ts';

export type ValueReading =
  | { readonly kind: 'value'; readonly value: Value }
  | { readonly kind: 'too-few-registers'; readonly got: number; readonly needed: number }
  /** The bits are no value of the type: a digit of BCD above 9, a date that does not exist. */
  | { readonly kind: 'no-value' }
  | Exclude<TextReading, { kind: 'value' }>;

function roomFor(registers: number) {
  const bytes = new Uint8Array(2 * registers);
  return { bytes, view: new DataView(bytes.buffer) };
}

/** Where registers are put together before they are read, by their number: nothing of it is kept. */
const rooms = Array.from({ length: 5 }, (_, registers) => roomFor(registers));

/**
 * The value that begins with the first of the registers; a text takes all of them. NaN and infinities are values of floats.
 * Throws a `RangeError` for registers that are not 0…65535.
 */
export function readValue(
  registers: readonly number[],
  type: ValueType,
  order: Order,
  padding?: Padding,
): ValueReading {
  if (isTextType(type)) return readText(registers, type, order, padding);
  const needed = registersOf(type);
  if (registers.length < needed) return { kind: 'too-few-registers', got: registers.length, needed };
  const { bytes, view } = rooms[needed] ?? roomFor(needed);
  fromRegisters(registers.slice(0, needed), order, bytes);
  const value = isFormType(type) ? formTypes[type].read(view) : numberTypes[type].read(view);
  return value === undefined ? { kind: 'no-value' } : { kind: 'value', value };
}

export type ValueWriting =
  | {
      readonly kind: 'registers';
      readonly registers: readonly number[];
      /** What is read back. */
      readonly stored: Value;
      /** Whether that is what was meant. */
      readonly exact: boolean;
    }
  | {
      readonly kind: 'out-of-range';
      readonly got: number | bigint;
      readonly least: number | bigint;
      readonly most: number | bigint;
    }
  /** 1.5, NaN or an infinity for a type of whole numbers. */
  | { readonly kind: 'not-whole'; readonly got: number }
  /** A text that is not a date, an address, … as the type has them. */
  | { readonly kind: 'no-such-form'; readonly got: string }
  | Exclude<TextWriting, { kind: 'registers' }>;

/**
 * The registers that hold a value. A number that a float type cannot hold exactly is rounded to the nearest, a tie to the
 * even one: `exact` is false if its shortest decimal is then another number (21.7 is written exactly, 16777217 as f32 is not).
 * NaN and infinities are written to floats as they are. Throws a `TypeError` for a string instead of a number, or the reverse,
 * and a `RangeError` for a text's room that is not 0…65536 registers.
 */
export function writeValue(value: Value, type: ValueType, order: Order, room: TextRoom = {}): ValueWriting {
  if (isNumberType(type)) {
    if (typeof value === 'string') throw new TypeError(`no ${type}: ${typeof value}`);
    return writeNumber(value, type, order);
  }
  if (typeof value !== 'string') throw new TypeError(`no ${type}: ${typeof value}`);
  if (isTextType(type)) return writeText(value, type, order, room);
  const { registers: size, read, write } = formTypes[type];
  const { bytes, view } = roomFor(size);
  if (!write(view, value)) return { kind: 'no-such-form', got: value };
  const registers = toRegisters(bytes, order);
  return { kind: 'registers', registers, stored: read(view) ?? value, exact: true };
}

function writeNumber(value: number | bigint, type: NumberTypeName, order: Order): ValueWriting {
  const { kind, registers: size, least, most, write, read, finite: always } = numberTypes[type] as NumberType;
  const finite = typeof value === 'bigint' || Number.isFinite(value);
  if (kind !== 'float' && typeof value === 'number' && !Number.isInteger(value))
    return { kind: 'not-whole', got: value };
  const { bytes, view } = roomFor(size);
  const refused = { kind: 'out-of-range', got: value, least, most } as const;
  if ((kind !== 'float' || always) && !(value >= least && value <= most)) return refused;
  write(view, value);
  const stored = read(view) ?? value;
  // A little above the largest number still rounds to it; what rounds to infinity does not fit.
  if (kind === 'float' && finite && !Number.isFinite(stored)) return refused;
  const registers = toRegisters(bytes, order);
  return { kind: 'registers', registers, stored, exact: kind !== 'float' || isNearest(Number(stored), value, type) };
}

/** Whether the shortest decimal of what is stored is the number that was meant. */
const isNearest = (stored: number, meant: number | bigint, type: NumberTypeName): boolean =>
  typeof meant === 'bigint'
    ? Number.isFinite(stored) && BigInt(stored) === meant
    : Object.is(stored, meant) || Object.is(Number(shortestFloat(stored, type)), meant);

/** Significant digits that tell any two numbers of the program apart. */
const MOST_DIGITS = 17;

/** The shortest decimal that reads back as this float of the type: 77.5146, not 77.51460266113281. `NaN`, `-Infinity`. */
export function shortestFloat(value: number, type: NumberTypeName): string {
  if (Object.is(value, -0)) return '-0';
  const { kind, registers, write, read } = numberTypes[type];
  // A float of 64 bits is a number of the program, whose shortest decimal is its text.
  if (kind !== 'float' || registers === 4 || !Number.isFinite(value)) return String(value);
  const { view } = roomFor(registers);
  for (let digits = 1; digits < MOST_DIGITS; digits++) {
    const text = String(Number(value.toPrecision(digits)));
    write(view, Number(text));
    if (read(view) === value) return text;
  }
  return String(value);
}
