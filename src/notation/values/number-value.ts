import { type Fraction, fraction, multiply } from '../../modbus/index.ts';
import { basedDigits, splitSign } from '../number.ts';

const DECIMAL = /^(\d+)(?:\.(\d+))?(?:e([-+]?\d{1,4}))?$/i;
/** Longer texts are not values of any type. */
const LONGEST = 400;

/** A number as typed: exactly, and whether it was written in hexadecimal or binary. */
export interface TypedNumber {
  readonly exactly: Fraction;
  readonly based: boolean;
}

/**
 * The exact number that a text says: decimal with a point and an exponent, or whole in hexadecimal or binary; digits may
 * be grouped with `_`. `undefined` if the text is not a number.
 */
export function readExact(text: string): TypedNumber | undefined {
  if (text.trim().length > LONGEST) return undefined;
  const { negative, body } = splitSign(text);
  const sign = negative ? -1n : 1n;
  const based = basedDigits(body);
  if (based) {
    const size = BigInt(`${based.base === 16 ? '0x' : '0b'}${based.digits}`);
    return { exactly: fraction(sign * size), based: true };
  }
  const match = DECIMAL.exec(body);
  if (match === null) return undefined;
  const [, whole = '', behind = '', exponent = '0'] = match;
  const shift = Number(exponent) - behind.length;
  // Far beyond every float, a number is only told to be too large or too small.
  if (Math.abs(shift) > 2 * LONGEST) return undefined;
  const power = fraction(shift < 0 ? 1n : 10n ** BigInt(shift), shift < 0 ? 10n ** BigInt(-shift) : 1n);
  return { exactly: multiply(fraction(sign * BigInt(whole + behind)), power), based: false };
}

/** A fraction as typed: `8192/60`, `0.1`. `undefined` for anything else, and for a denominator of 0. */
export function readFraction(text: string): Fraction | undefined {
  const [above = '', below, ...more] = text.split('/');
  const numerator = readExact(above)?.exactly;
  const denominator = below === undefined ? fraction(1) : readExact(below)?.exactly;
  if (more.length > 0 || numerator === undefined || denominator === undefined || denominator.numerator === 0n) {
    return undefined;
  }
  return multiply(numerator, fraction(denominator.denominator, denominator.numerator));
}
