import { demandWhole } from '../demand.ts';

/** An exact number: `numerator / denominator`, the denominator above 0. It is not always in lowest terms. */
export interface Fraction {
  readonly numerator: bigint;
  readonly denominator: bigint;
}

/** Throws a `RangeError` for a denominator of 0 and for numbers that are not whole. */
export function fraction(numerator: bigint | number, denominator: bigint | number = 1n): Fraction {
  const [above, below] = [wholeOf(numerator), wholeOf(denominator)];
  if (below === 0n) throw new RangeError('denominator 0');
  const divisor = (below < 0n ? -1n : 1n) * greatestCommonDivisor(above, below);
  return { numerator: above / divisor, denominator: below / divisor };
}

function wholeOf(value: bigint | number): bigint {
  if (typeof value === 'bigint') return value;
  if (!Number.isInteger(value)) throw new RangeError(`no whole number: ${String(value)}`);
  return BigInt(value);
}

function greatestCommonDivisor(a: bigint, b: bigint): bigint {
  let [x, y] = [a < 0n ? -a : a, b < 0n ? -b : b];
  while (y > 0n) [x, y] = [y, x % y];
  return x;
}

export const add = (a: Fraction, b: Fraction): Fraction =>
  fraction(a.numerator * b.denominator + b.numerator * a.denominator, a.denominator * b.denominator);

export const subtract = (a: Fraction, b: Fraction): Fraction => add(a, { ...b, numerator: -b.numerator });

export const multiply = (a: Fraction, b: Fraction): Fraction =>
  fraction(a.numerator * b.numerator, a.denominator * b.denominator);

/** Throws a `RangeError` for division by 0. */
export const divide = (a: Fraction, b: Fraction): Fraction =>
  fraction(a.numerator * b.denominator, a.denominator * b.numerator);

/** Below 0, 0, or above 0, as `a` is less than, equal to or more than `b`. */
export const compare = (a: Fraction, b: Fraction): number => Number(sign(subtract(a, b).numerator));

/**
 * The simplest fraction that is this number as a double: 1/10 for 0.1, 2048/15 for 8192/60. Throws a `RangeError` for NaN
 * and infinities.
 */
export function simplestFraction(value: number): Fraction {
  const exactly = exactFraction(value);
  // The convergents of the continued fraction, until one is the number.
  let [before, last] = [fraction(0), { numerator: 1n, denominator: 0n }];
  let { numerator, denominator } = exactly;
  while (denominator !== 0n) {
    const whole = numerator / denominator;
    [numerator, denominator] = [denominator, numerator % denominator];
    const next = {
      numerator: whole * last.numerator + before.numerator,
      denominator: whole * last.denominator + before.denominator,
    };
    [before, last] = [last, next];
    if (toNumber(next) === value) return fraction(next.numerator, next.denominator);
  }
  return exactly;
}

/** A double exactly: it is a whole number of powers of two. Throws a `RangeError` for NaN and infinities. */
export function exactFraction(value: number): Fraction {
  if (!Number.isFinite(value)) throw new RangeError(`no fraction: ${value}`);
  let [whole, shift] = [value, 0];
  while (!Number.isInteger(whole)) {
    whole *= 2;
    shift += 1;
  }
  return fraction(BigInt(whole), 1n << BigInt(shift));
}

/** Decimal digits that decide a double, and some more. */
const DOUBLE_DIGITS = 40;

/** The double nearest to a fraction; an infinity if it is too large for a double. */
export function toNumber({ numerator, denominator }: Fraction): number {
  const size = numerator < 0n ? -numerator : numerator;
  const shift = DOUBLE_DIGITS + String(denominator).length - String(size).length;
  const digits = shift < 0 ? size / (denominator * 10n ** BigInt(-shift)) : (size * 10n ** BigInt(shift)) / denominator;
  return Number(`${numerator < 0n ? '-' : ''}${digits}e${-shift}`);
}

const sign = (value: bigint): bigint => (value < 0n ? -1n : value > 0n ? 1n : 0n);

/** The nearest whole number; halves are rounded away from 0. */
export function round({ numerator, denominator }: Fraction): bigint {
  const size = numerator < 0n ? -numerator : numerator;
  return sign(numerator) * ((2n * size + denominator) / (2n * denominator));
}

/** Most digits after the point. */
const MOST_DECIMALS = 100;

function powerOfTen(decimals: number): bigint {
  demandWhole('decimals', decimals, 0, MOST_DECIMALS);
  return 10n ** BigInt(decimals);
}

/** The nearest multiple of a power of ten, with 0 to 100 digits after the point. Throws a `RangeError` for more. */
export function roundTo(value: Fraction, decimals: number): Fraction {
  const power = powerOfTen(decimals);
  return fraction(round(multiply(value, fraction(power))), power);
}

/** A fraction as a decimal, rounded to 0 to 100 digits after the point: `-0.05`. Throws a `RangeError` for more. */
export function formatFraction(value: Fraction, decimals: number): string {
  const whole = round(multiply(value, fraction(powerOfTen(decimals))));
  const digits = String(whole < 0n ? -whole : whole).padStart(decimals + 1, '0');
  const point = digits.length - decimals;
  return `${whole < 0n ? '-' : ''}${digits.slice(0, point)}${decimals > 0 ? `.${digits.slice(point)}` : ''}`;
}

/** A fraction as a decimal with all its digits (`0.125`); `undefined` if it has no end (1/3) or more than `most` digits behind the point. */
export function decimalOf(value: Fraction, most = MOST_DECIMALS): string | undefined {
  for (let decimals = 0; decimals <= most; decimals++) {
    if ((value.numerator * powerOfTen(decimals)) % value.denominator === 0n) return formatFraction(value, decimals);
  }
  return undefined;
}
