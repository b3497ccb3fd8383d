import { demandWhole, hexDigits } from '../modbus/index.ts';

/** The ways a whole number is written with its base: `0x2AB`, `2ABh`, `16#2AB`, `$2AB`, `0b1010`, `2#1010`. */
const FORMS: readonly { readonly pattern: RegExp; readonly base: 2 | 16 }[] = [
  { pattern: /^0x([0-9a-f]+)$/i, base: 16 },
  { pattern: /^(?:16#|\$)([0-9a-f]+)$/i, base: 16 },
  { pattern: /^([0-9a-f]+)h$/i, base: 16 },
  { pattern: /^(?:0b|2#)([01]+)$/i, base: 2 },
];

/** A number's sign, and the rest of it without the `_` that group its digits. */
export function splitSign(text: string): { readonly negative: boolean; readonly body: string } {
  const trimmed = text.trim();
  const body = trimmed.replace(/^[-−+]\s*/, '').replace(/(?<=[0-9a-f])_(?=[0-9a-f])/gi, '');
  return { negative: /^[-−]/.test(trimmed), body };
}

/** The digits of a whole number without its sign that is written with its base; `undefined` for anything else. */
export function basedDigits(body: string): { readonly digits: string; readonly base: 2 | 16 } | undefined {
  for (const { pattern, base } of FORMS) {
    const digits = pattern.exec(body)?.[1];
    if (digits !== undefined) return { digits, base };
  }
  return undefined;
}

const PLAIN = /^\d+$/;

/**
 * The number a person typed, in decimal or any of the field's ways to write hexadecimal and binary; digits may be grouped
 * with `_`. A sign and a decimal fraction are read too, so that the answer can say what is wrong with them. `undefined`
 * if the text is not a number.
 */
export function readNumber(text: string): number | undefined {
  // Most numbers, and all of a long list: the other forms cost five times as much.
  if (PLAIN.test(text)) return Number(text);
  const { negative, body } = splitSign(text);
  const based = basedDigits(body);
  if (based) return (negative ? -1 : 1) * Number.parseInt(based.digits, based.base);
  return /^\d+(\.\d+)?$/.test(body) ? (negative ? -1 : 1) * Number(body) : undefined;
}

/** Reads whole numbers as `readNumber` does; `undefined` for anything that is not one from `least` to `most`. */
export const wholeNumber =
  (least: number, most: number) =>
  (text: string): number | undefined => {
    const value = readNumber(text);
    return value !== undefined && Number.isInteger(value) && value >= least && value <= most ? value : undefined;
  };

/** A number as hexadecimal with `0x` and at least `digits` digits. */
export const formatHex = (value: number, digits: number): string => `0x${hexDigits(value, digits)}`;

/** Digits of the widest number. */
const MOST_BITS = 64;

/** A number as binary digits in groups of four: `0000 0110`. Throws a `RangeError` for more than 64 bits. */
export function formatBinary(value: number, bits: number): string {
  demandWhole('bits', bits, 0, MOST_BITS);
  return value
    .toString(2)
    .padStart(bits, '0')
    .replace(/\B(?=(?:\d{4})+$)/g, ' ');
}
