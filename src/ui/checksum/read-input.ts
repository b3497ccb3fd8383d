import { type ByteNotation, readBytes, type TextProblem } from '../../notation/index.ts';

/** What the input is: bytes in any notation, or characters that are to be taken as they are. */
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
  if (kind === 'text') return { bytes: new TextEncoder().encode(text), problems: [] };
  const { bytes, reading, problems } = readBytes(text);
  return { bytes, notation: reading, problems: problems.slice(0, PROBLEMS_KEPT) };
}
