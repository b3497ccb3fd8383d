import { hasAsciiFrames, readAsciiFrames } from './ascii-frames.ts';
import { hasEscapes, readEscapes } from './escapes.ts';
import { likelyBase, type NumberReader, readBinary, readDecimal, readHex, readSwapped } from './numbers.ts';
import type { Output } from './output.ts';
import type { Section } from './sections.ts';
import type { Source } from './source.ts';
import type { Token } from './token.ts';
import type { ByteNotation } from './types.ts';

/** A way to write bytes. */
export interface Notation {
  readonly name: ByteNotation;
  /** How well the text has its shape: 0 for not at all, more is better. */
  suits(source: Source): number;
  read(source: Source, out: Output): void;
}

/** Those whose shape nothing else has; then what numbers look like; then what they may be. */
export const OWN = 4;
const DUMP = 3;
const LIKELY = 2;
const POSSIBLE = 1;

export const notations: readonly Notation[] = [
  {
    name: 'ascii-frame',
    suits: ({ plain }) => (hasAsciiFrames(plain) ? OWN : 0),
    read: ({ plain }, out) => readAsciiFrames(plain, out),
  },
  {
    name: 'escapes',
    suits: ({ plain }) => (hasEscapes(plain) ? OWN : 0),
    read: ({ plain }, out) => readEscapes(plain, out),
  },
  {
    name: 'hexdump',
    suits: (source) => (isDump(source) ? DUMP : 0),
    read: (source, out) => readSections(source, readHex, out, true),
  },
  {
    name: 'hexdump-words',
    suits: (source) => (hasWords(source) ? POSSIBLE : 0),
    read: (source, out) => readSections(source, readSwapped, out, true),
  },
  {
    name: 'hex',
    suits: (source) => base(source, 16, () => true),
    read: (source, out) => readSections(source, readHex, out),
  },
  {
    name: 'decimal',
    suits: (source) => base(source, 10, (digits) => digits.length <= 3 && /^\d+$/.test(digits)),
    read: (source, out) => readSections(source, readDecimal, out),
  },
  {
    name: 'binary',
    suits: (source) => base(source, 2, (digits) => digits.length % 8 === 0 && /^[01]+$/.test(digits)),
    read: (source, out) => readSections(source, readBinary, out),
  },
];

/** Whether most lines are a dump's: among many, one may look so by chance. */
const isDump = ({ dump, sections }: Source): boolean => dump.size > 0 && 2 * dump.size >= sections.length;

const bareOf = ({ sections }: Source): readonly Token[] =>
  sections.flatMap(({ tokens }) => tokens.filter(({ kind, base }) => kind === 'number' && base === 0));

function hasWords(source: Source): boolean {
  const lines = [...source.dump.values()];
  return isDump(source) && lines.every(({ tokens }) => tokens.every(({ from, to }) => to - from === 4));
}

function base(source: Source, value: 2 | 10 | 16, isPossible: (digits: string) => boolean): number {
  const { sections, plain } = source;
  if (sections.length === 0) return 0;
  const bare = bareOf(source);
  if (value !== 16 && bare.length === 0) return 0;
  if (
    likelyBase(
      plain,
      sections.flatMap(({ tokens }) => tokens),
    ) === value
  )
    return LIKELY;
  return bare.every(({ from, to }) => isPossible(plain.slice(from, to))) ? POSSIBLE : 0;
}

function readSections(source: Source, read: NumberReader, out: Output, hasOffsets = false): void {
  let single: Section | undefined;
  for (const section of source.sections) {
    const line = hasOffsets ? source.dump.get(section) : undefined;
    const from = out.length;
    read(source.plain, line?.tokens ?? section.tokens, out);
    const size = out.length - from;
    if (size === 0) continue;
    // Bytes one by one are a frame together, if one direction has them all.
    const isNext = size === 1 && single !== undefined && single.label.direction === section.label.direction;
    if (section.continued || line?.follows === true || isNext) out.extendChunk(from);
    else out.chunk(from, section.label);
    single = size === 1 ? section : undefined;
  }
}
