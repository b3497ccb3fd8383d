import { fromHex, MOST_ASCII, toHex } from '../modbus/index.ts';

/** Bytes that are characters of an ASCII frame, and what they say. */
export interface AsciiText {
  /** The bytes that the pairs of digits spell. */
  readonly binary: Uint8Array;
  readonly text: string;
  readonly colon: boolean;
  /** What stands behind the digits, in hexadecimal pairs. */
  readonly end: string;
}

/** Longer than the longest frame written as hexadecimal text of hexadecimal text. */
const LONGEST = 2 * MOST_ASCII;
const SHAPE = /^(:?)((?:[0-9A-Fa-f]{2})+)([\r\n]*)$/;
/** What may stand between the digits of text that is not an ASCII frame. */
const BETWEEN = /0x|[ ,;-]/gi;
const DIGIT_BITS = 3;

/** The bytes as hexadecimal text, with or without the colon in front and a line end behind. */
export function asciiText(bytes: Uint8Array): AsciiText | undefined {
  if (bytes.length > LONGEST) return undefined;
  const text = String.fromCharCode(...bytes);
  const [, colon, digits, end] = SHAPE.exec(text) ?? SHAPE.exec(text.replace(BETWEEN, '')) ?? [];
  const binary = fromHex(digits ?? '');
  if (binary === undefined || binary.length === 0) return undefined;
  const ends = Uint8Array.from(end ?? '', (one) => one.charCodeAt(0));
  return { binary, text, colon: colon === ':', end: toHex(ends) };
}

/** The evidence that the bytes are not all digits by chance. */
export const textBits = ({ text, colon }: AsciiText): number =>
  Math.min(30, DIGIT_BITS * text.length) + (colon ? 5 : 0);
