import { type Fraction, fraction, multiply } from '../../modbus/index.ts';

/** Ways to write whole numbers, beside decimal. */
const FORMS: readonly { readonly pattern: RegExp; readonly prefix: string }[] = [
  { pattern: /^0x([0-9a-f]+)$/i, prefix: '0x' },
  { pattern: /^(?:16#|\$)([0-9a-f]+)$/i, prefix: '0x' },
  { pattern: /^([0-9a-f]+)h$/i, prefix: '0x' },
  { pattern: /^(?:0b|2#)([01]+)$/i, prefix: '0b' },
];

const DECIMAL = /^(\d+)(?:\.(\d+))?(?:e([-+]?\d{1,4}))?$/i;
/** Longer texts are no values of any type here. */
const LONGEST = 400;

/** A number as typed: exactly, and whether it was written in hexadecimal or binary. */
export interface TypedNumber {
  readonly exactly: Fraction;
  readonly based: boolean;
}

/**
 * The exact number that a text says: decimal with a point and an exponent, or whole in hexadecimal or binary; digits may
 * be grouped with `_`. `undefined` for what is no number.
 */
export function readExact(text: string): TypedNumber | undefined {
  const trimmed = text.trim();
  if (trimmed.length > LONGEST) return undefined;
  const sign = /^[-−]/.test(trimmed) ? -1n : 1n;
  const body = trimmed.replace(/^[-−+]\s*/, '').replace(/(?<=[0-9a-f])_(?=[0-9a-f])/gi, '');
  for (const { pattern, prefix } of FORMS) {
    const digits = pattern.exec(body)?.[1];
    if (digits !== undefined) return { exactly: fraction(sign * BigInt(prefix + digits)), based: true };
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
