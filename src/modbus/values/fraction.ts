/** An exact number: `numerator / denominator`, the denominator above 0. It is not always in lowest terms. */
export interface Fraction {
  readonly numerator: bigint;
  readonly denominator: bigint;
}

/** Throws a `RangeError` for a denominator of 0. */
export function fraction(numerator: bigint | number, denominator: bigint | number = 1n): Fraction {
  const [above, below] = [BigInt(numerator), BigInt(denominator)];
  if (below === 0n) throw new RangeError('denominator 0');
  const divisor = (below < 0n ? -1n : 1n) * greatestCommonDivisor(above, below);
  return { numerator: above / divisor, denominator: below / divisor };
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

const sign = (value: bigint): bigint => (value < 0n ? -1n : value > 0n ? 1n : 0n);

/** The nearest whole number; halves are rounded away from 0. */
export function round({ numerator, denominator }: Fraction): bigint {
  const size = numerator < 0n ? -numerator : numerator;
  return sign(numerator) * ((2n * size + denominator) / (2n * denominator));
}

/** The nearest multiple of a power of ten, with so many digits behind the point. */
export const roundTo = (value: Fraction, decimals: number): Fraction =>
  fraction(round(multiply(value, fraction(10n ** BigInt(decimals)))), 10n ** BigInt(decimals));

/** A fraction as a decimal, rounded to so many digits behind the point: `-0.05`. */
export function formatFraction(value: Fraction, decimals: number): string {
  const whole = round(multiply(value, fraction(10n ** BigInt(decimals))));
  const digits = String(whole < 0n ? -whole : whole).padStart(decimals + 1, '0');
  const point = digits.length - decimals;
  return `${whole < 0n ? '-' : ''}${digits.slice(0, point)}${decimals > 0 ? `.${digits.slice(point)}` : ''}`;
}
