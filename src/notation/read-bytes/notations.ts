import { readAsciiFrame } from './ascii-frames.ts';
import { numbersOf, readString } from './escapes.ts';
import { likelyBase, type NumberReader, readBinary, readDecimal, readHex, readSwapped } from './numbers.ts';
import type { Output } from './output.ts';
import { type Piece, sectionPieces } from './section-pieces.ts';
import type { Source } from './source.ts';
import type { ByteNotation } from './types.ts';

/** A way to write bytes. */
export interface Notation {
  readonly name: ByteNotation;
  /** How well the text has its shape: 0 for not at all, more is better. */
  suits(source: Source): number;
  /** The parts of the text that it reads, in order. */
  pieces(source: Source, isAlone: boolean): readonly Piece[];
}

/** Those whose shape nothing else has; then what numbers look like; then what they may be. */
export const OWN = 4;
const DUMP = 3;
const LIKELY = 2;
const POSSIBLE = 1;

const numbers = (name: ByteNotation, read: NumberReader, suits: Notation['suits']): Notation => ({
  name,
  suits,
  pieces: (source, isAlone) => sectionPieces(source, name, read, isAlone),
});

export const notations: readonly Notation[] = [
  {
    name: 'ascii-frame',
    suits: ({ frames }) => (frames.length > 0 ? OWN : 0),
    pieces: ({ plain, frames }) =>
      frames.map((frame) => ({
        ...frame,
        read: (out) => {
          const from = out.length;
          readAsciiFrame(plain, frame, out);
          out.chunk(from, frame.label);
        },
      })),
  },
  {
    name: 'escapes',
    suits: ({ strings }) => (strings.length > 0 ? OWN : 0),
    pieces: ({ plain, strings }) => {
      const escapes = numbersOf(plain);
      return strings.map((string) => ({
        ...string,
        read: (out) => {
          const from = out.length;
          readString(plain, string, escapes, out);
          if (string.continued) out.extendChunk(from);
          else out.chunk(from, string.label);
        },
      }));
    },
  },
  numbers('hexdump', readHex, (source) => (isDump(source) ? DUMP : 0)),
  numbers('hexdump-words', readSwapped, (source) => (hasWords(source) ? POSSIBLE : 0)),
  numbers('hex', readHex, (source) => base(source, 16, () => true)),
  numbers('decimal', readDecimal, (source) => base(source, 10, (digits) => digits.length <= 3 && /^\d+$/.test(digits))),
  numbers('binary', readBinary, (source) =>
    base(source, 2, (digits) => digits.length % 8 === 0 && /^[01]+$/.test(digits)),
  ),
];

/** Whether most lines are a dump's: among many, one may look so by chance. */
const isDump = ({ dump, sections }: Source): boolean => dump.size > 0 && 2 * dump.size >= sections.length;

function hasWords(source: Source): boolean {
  const lines = [...source.dump.values()];
  return isDump(source) && lines.every(({ tokens }) => tokens.every(({ from, to }) => to - from === 4));
}

function base({ sections, plain }: Source, value: 2 | 10 | 16, isPossible: (digits: string) => boolean): number {
  if (sections.length === 0) return 0;
  const tokens = sections.flatMap((section) => section.tokens);
  const bare = tokens.filter(({ kind, base: said }) => kind === 'number' && said === 0);
  if (value !== 16 && bare.length === 0) return 0;
  if (likelyBase(plain, tokens) === value) return LIKELY;
  return bare.every(({ from, to }) => isPossible(plain.slice(from, to))) ? POSSIBLE : 0;
}

/**
 * Reads a text in one notation. With `isAlone` that is all; without, the parts that are surely in another are read in that. `tell`
 * hears how much of it is done, 0 to 1.
 */
export function read(
  source: Source,
  reading: ByteNotation,
  isAlone: boolean,
  out: Output,
  tell?: (done: number) => void,
): void {
  const notation = notations.find(({ name }) => name === reading);
  if (notation === undefined) return;
  let pieces = notation.pieces(source, isAlone);
  for (const other of isAlone ? [] : others(notation)) {
    if (isOfNumbers(other) && isFull(pieces, source)) continue;
    pieces = merged(pieces, other.pieces(source, false), source, !isOfNumbers(other));
  }
  pieces.forEach((piece, index) => {
    piece.read(out);
    tell?.(index / pieces.length);
  });
}

const isOfNumbers = ({ name }: Notation) => name !== 'ascii-frame' && name !== 'escapes';

/** Of the other ways to write bytes those that may be mixed with this one. */
function others(notation: Notation): readonly Notation[] {
  const strings = notations.filter((other) => other !== notation && !isOfNumbers(other));
  return isOfNumbers(notation) ? strings : [...strings, ...notations.filter(({ name }) => name === 'hex')];
}

/** Whether pieces stand in all lines that are not empty. */
function isFull(pieces: readonly Piece[], { lines, lineAt }: Source): boolean {
  const taken = new Set(pieces.map(({ start }) => lineAt(start)));
  return lines.every(({ start, end }, index) => start === end || taken.has(index));
}

/** Pieces, and those of another notation that are sure, in lines without; `drivesOut` also in lines with pieces that are not sure. */
function merged(
  pieces: readonly Piece[],
  more: readonly Piece[],
  { lineAt }: Source,
  drivesOut: boolean,
): readonly Piece[] {
  if (more.length === 0) return pieces;
  const own = new Map(pieces.map((piece) => [lineAt(piece.start), piece]));
  const added = more.filter((one) => {
    const piece = own.get(lineAt(one.start));
    if (piece !== undefined && (!drivesOut || piece.isSure)) return false;
    return one.isSure;
  });
  if (added.length === 0) return pieces;
  const taken = new Set(added.map(({ start }) => lineAt(start)));
  return [...pieces.filter(({ start }) => !taken.has(lineAt(start))), ...added].sort(
    (one, other) => one.start - other.start,
  );
}
