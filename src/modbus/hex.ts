import { demandPart, demandWhole } from './demand.ts';

/** Most digits that a number is given. */
const MOST_DIGITS = 64;

/**
 * A whole number from 0 in upper-case hexadecimal digits, with zeros in front up to `width`, 0 to 64. Throws a `RangeError` for
 * any other.
 */
export function hexDigits(value: number, width: number): string {
  demandWhole('number', value, 0, Number.MAX_SAFE_INTEGER);
  demandWhole('width', width, 0, MOST_DIGITS);
  return value.toString(16).toUpperCase().padStart(width, '0');
}

const PAIRS = Array.from({ length: 256 }, (_, byte) => hexDigits(byte, 2));

/**
 * The bytes `bytes[from, to)` as upper-case hexadecimal pairs without separators, as `fields.data` holds them. Throws a
 * `RangeError` for bytes that are not there.
 */
export function toHex(bytes: Uint8Array, from = 0, to = bytes.length): string {
  demandPart(bytes, from, to);
  let text = '';
  for (let i = from; i < to; i++) text += PAIRS[bytes[i] as number];
  return text;
}

/** Hexadecimal pairs with a blank between each two, for people. */
export const spacedHex = (pairs: string): string => pairs.replace(/..(?=.)/g, '$& ');

/** The value of the hexadecimal digit with this character code, of either case, or −1. */
export function hexDigit(character: number): number {
  if (character >= 0x30 && character <= 0x39) return character - 0x30;
  const upper = character & 0xdf;
  return upper >= 0x41 && upper <= 0x46 ? upper - 0x37 : -1;
}

/** Reads hexadecimal pairs, with or without blanks between them, of either case; `undefined` for anything else. */
export function fromHex(text: string): Uint8Array | undefined {
  const digits = text.replace(/\s+/g, '');
  if (digits.length % 2 !== 0) return undefined;
  const bytes = new Uint8Array(digits.length / 2);
  for (let i = 0; i < bytes.length; i++) {
    const high = hexDigit(digits.charCodeAt(2 * i));
    const low = hexDigit(digits.charCodeAt(2 * i + 1));
    if (high < 0 || low < 0) return undefined;
    bytes[i] = 16 * high + low;
  }
  return bytes;
}

/** Whether two runs of bytes are the same. */
export const sameBytes = (one: Uint8Array, other: Uint8Array): boolean =>
  one.length === other.length && one.every((byte, at) => byte === other[at]);
