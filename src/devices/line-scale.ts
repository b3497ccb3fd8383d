import {
  add,
  compare,
  decimalOf,
  demandWhole,
  divide,
  exactFraction,
  type Fraction,
  fraction,
  inverseScale,
  multiply,
  type Scale,
  simplestFraction,
  toNumber,
} from '../modbus/index.ts';
import { readFraction } from '../notation/index.ts';
import type { Register } from './profile.ts';

/** What a number in the registers of a line stands for: value = raw × factor + offset. */
export type LineScale = Pick<Scale, 'factor' | 'offset'>;

const ZERO = fraction(0);
const ONE = fraction(1);
const same = (a: Fraction, b: Fraction): boolean => compare(a, b) === 0;

const known = new WeakMap<Register, LineScale>();

/** The scale of a line, exactly. */
export function scaleOf(register: Register): LineScale {
  const found = known.get(register);
  if (found) return found;
  const { factor, offset, exact } = register;
  const scale = {
    factor: (exact && readFraction(exact.factor)) ?? simplestFraction(factor),
    offset: (exact && readFraction(exact.offset)) ?? simplestFraction(offset),
  };
  known.set(register, scale);
  return scale;
}

/** Whether the value of a line is another number than the one in its registers. */
export const isScaled = ({ factor, offset, scaleRegister }: Register): boolean =>
  factor !== 1 || offset !== 0 || scaleRegister !== undefined;

/** A scale as a line has it: as numbers, and exactly where a number is not enough. */
export function withScale({ factor, offset }: LineScale): Pick<Register, 'factor' | 'offset' | 'exact'> {
  const [times, plus] = [toNumber(factor), toNumber(offset)];
  const enough = isHeld(times, factor) && isHeld(plus, offset);
  return {
    factor: times,
    offset: plus,
    ...(!enough && { exact: { factor: ratioText(factor), offset: ratioText(offset) } }),
  };
}

const isHeld = (number: number, exactly: Fraction): boolean =>
  Number.isFinite(number) && same(simplestFraction(number), exactly);

/** Most digits behind the point of a number that is not written as a quotient. */
const DECIMALS = 9;

/** A factor as text that `readRatio` reads as the same: `0.1`, `15/2048`. */
export function ratioText(value: Fraction): string {
  const decimal = isHeld(toNumber(value), value) ? decimalOf(value, DECIMALS) : undefined;
  return decimal ?? `${value.numerator}/${value.denominator}`;
}

const DECIMAL = /^[-+−]?(?:\d+(?:[.,]\d+)?|[.,]\d+)(?:e[-+]?\d+)?$/i;

/**
 * A decimal number with point or comma, with or without exponent, or a quotient of two: `0,1`, `.5`, `1e-3`, `60/8192`. A number
 * alone is the simplest fraction that is the same double, a quotient is exact. `undefined` for any other text.
 */
export function readRatio(text: string): Fraction | undefined {
  const parts = text.split('/').map((part) => part.trim());
  if (!parts.every((part) => DECIMAL.test(part))) return undefined;
  const [first = '', ...others] = parts.map((part) =>
    part
      .replace(',', '.')
      .replace('−', '-')
      .replace(/^([-+]?)\./, '$10.'),
  );
  if (others.length > 0) return readFraction([first, ...others].join('/'));
  return Number.isFinite(Number(first)) ? simplestFraction(Number(first)) : undefined;
}

/** `readRatio` as the nearest number; `undefined` also if it is too large for one. */
export function readDecimal(text: string): number | undefined {
  const exactly = readRatio(text);
  const value = exactly && toNumber(exactly);
  return value !== undefined && Number.isFinite(value) ? value : undefined;
}

/**
 * A line of a table of the old meaning, raw = value × factor + offset, as a line of today: what a raw number stands for is the
 * same, exactly.
 */
export function fromOldMeaning(register: Register): Register {
  const { exact: _, ...line } = register;
  return register.factor === 1 && register.offset === 0
    ? register
    : { ...line, ...withScale(inverseScale(scaleOf(register))) };
}

/** The factor and the offset that a line has in the old meaning. */
export const inOldMeaning = (register: Register): Pick<Register, 'factor' | 'offset' | 'exact'> =>
  withScale(inverseScale(scaleOf(register)));

/** Powers of ten that a scale register holds (SunSpec Device Information Model Specification, 4.2.8). */
const MOST_POWER = 10;

/** The power of ten that a scale register holds; `undefined` if it was not read, or holds none. */
export function powerIn(word: number | undefined): number | undefined {
  const power = word === undefined ? undefined : (word << 16) >> 16;
  return power !== undefined && Math.abs(power) <= MOST_POWER ? power : undefined;
}

/**
 * What a raw number of a line stands for, exactly, with the power of ten that its scale register holds. Throws a `RangeError`
 * for NaN and infinities, and for a power beyond ±10.
 */
export function exactlyInUnits(raw: number | bigint, register: Register, exponent = 0): Fraction {
  demandWhole('exponent', exponent, -MOST_POWER, MOST_POWER);
  const { factor, offset } = scaleOf(register);
  const number = typeof raw === 'bigint' ? fraction(raw) : exactFraction(raw);
  const power = fraction(10n ** BigInt(Math.abs(exponent)));
  const times = exponent < 0 ? divide(number, power) : multiply(number, power);
  if (same(factor, ONE) && same(offset, ZERO)) return times;
  return add(multiply(times, factor), offset);
}
