import { type ByteNotation, readBytes, type TextProblem } from '../../notation/index.ts';

/** What the input is: bytes in any notation, or characters that are taken as they are. */
export const inputKinds = ['bytes', 'text'] as const;
export type InputKind = (typeof inputKinds)[number];

/** The bytes of an input, and how they were read. */
export interface InputReading {
  readonly bytes: Uint8Array;
  /** Absent for text. */
  readonly notation?: ByteNotation;
  readonly problems: readonly TextProblem[];
}

/** More problems than this are not carried along. */
const PROBLEMS_KEPT = 20;

/** Reads what was typed. */
export function readInput(text: string, kind: InputKind): InputReading {
  if (kind === 'text') return { bytes: utf8(text), problems: [] };
  const { bytes, reading, problems } = readBytes(text);
  return { bytes, notation: reading, problems: problems.slice(0, PROBLEMS_KEPT) };
}

/** Half a surrogate pair, which UTF-8 cannot carry, becomes U+FFFD. */
function utf8(text: string): Uint8Array {
  const bytes = new Uint8Array(3 * text.length);
  let size = 0;
  for (const character of text) {
    const code = character.codePointAt(0) ?? 0;
    const point = code >= 0xd800 && code <= 0xdfff ? 0xfffd : code;
    const following = point < 0x80 ? 0 : point < 0x800 ? 1 : point < 0x10000 ? 2 : 3;
    bytes[size++] = following === 0 ? point : ((0xff00 >> (following + 1)) & 0xff) | (point >> (6 * following));
    for (let rest = following - 1; rest >= 0; rest--) bytes[size++] = 0x80 | ((point >> (6 * rest)) & 0x3f);
  }
  return bytes.slice(0, size);
}
