import { isFrame } from './evidence.ts';
import type { Token } from './items.ts';
import { bytesIn, type NumberReader, readDecimal, readHex } from './numbers.ts';
import type { Output } from './output.ts';
import type { Section } from './sections.ts';
import { leadOf, type Source } from './source.ts';
import type { ByteNotation } from './types.ts';

/** A part of the text, as one notation reads it. */
export interface Piece {
  readonly start: number;
  readonly end: number;
  /** Nothing tells it better than this notation, whatever the rest of the text is written in. */
  readonly isSure: boolean;
  read(out: Output): void;
}

/** Fewest numbers of which a checksum or their shape tells the base. */
const LEAST = 3;

/** The sections of a text as pieces to read, each group of sections that go on with one another in its own base. */
export function sectionPieces(
  source: Source,
  name: ByteNotation,
  read: NumberReader,
  isAlone: boolean,
): readonly Piece[] {
  const { plain, sections } = source;
  // A dump's offsets are bytes only where someone wants all to be read as such.
  const dump = isAlone && name !== 'hexdump' && name !== 'hexdump-words' ? undefined : source.dump;
  const pieces: Piece[] = [];
  let single: Section | undefined;
  let own: ByteNotation = name;
  const isOneByOne = oneByOne(plain, sections);
  const isPause = pauses(sections);
  for (const [index, section] of sections.entries()) {
    const line = dump?.get(section);
    const tokens = line?.tokens ?? section.tokens;
    const goesOn = line?.follows ?? section.continued;
    if (!goesOn && !isAlone) own = ownBase(plain, groupAt(sections, index), name);
    const reader = own === name ? read : own === 'decimal' ? readDecimal : readHex;
    const reading = own === name ? undefined : own;
    const size = tokens.length;
    // Bytes one by one are a frame together, if one direction has them all.
    const isNext =
      isSingle(tokens, name) &&
      single !== undefined &&
      single.label.direction === section.label.direction &&
      isOneByOne(section) &&
      !isPause(single, section);
    if (size > 0) single = isSingle(tokens, name) ? section : undefined;
    pieces.push({
      start: tokens[0]?.start ?? section.line.start,
      end: tokens.at(-1)?.end ?? section.line.end,
      get isSure() {
        return isSure(plain, section);
      },
      read: (out) => {
        const from = out.length;
        let read = 0;
        for (const frame of framesIn(plain, tokens, reader)) {
          reader(plain, frame, out);
          out.chunk(from + read, section.label, reading);
          read = out.length - from;
        }
        if (read > 0) return;
        reader(plain, tokens, out);
        if (out.length === from) return;
        if (goesOn || isNext) out.extendChunk(from);
        else out.chunk(from, section.label, reading);
      },
    });
  }
  return pieces;
}

const isSingle = (tokens: readonly Token[], name: ByteNotation): boolean => {
  const [token] = tokens;
  return (
    tokens.length === 1 && token !== undefined && (token.to - token.from <= 3 || token.base === 2 || name === 'binary')
  );
};

/** Whether a line of this form has one byte in all of the text; where others have more, it is a short piece by itself. */
function oneByOne(plain: string, sections: readonly Section[]): (section: Section) => boolean {
  let longer: ReadonlySet<string> | undefined;
  return (section) => {
    if (section.alone) return true;
    longer ??= new Set(sections.filter(({ tokens }) => tokens.length > 1).map((one) => leadOf(plain, one)));
    return !longer.has(leadOf(plain, section));
  };
}

/** How much longer than most times from byte to byte one between two frames is, at least (SL 2.5.1.1). */
const PAUSE = 3;

/** Whether a frame ends between two bytes, by the seconds that a logic analyser says of each. */
function pauses(sections: readonly Section[]): (one: Section, other: Section) => boolean {
  const secondsOf = ({ label: { time = '' } }: Section) => (/^\d+\.\d+$/.test(time) ? Number(time) : Number.NaN);
  let usual: number | undefined;
  return (one, other) => {
    const after = secondsOf(other) - secondsOf(one);
    if (Number.isNaN(after)) return false;
    if (usual === undefined) {
      const steps = sections.flatMap(
        (section, index) => secondsOf(section) - secondsOf(sections[index - 1] ?? section),
      );
      const sorted = steps.filter((step) => step > 0).sort((a, b) => a - b);
      usual = sorted[sorted.length >> 1] ?? 0;
    }
    return after > PAUSE * usual;
  };
}

/** Fewest bytes of a frame among others. */
const FRAME = 4;

/** The frames of a row in which commas or semicolons part frames rather than bytes; none if it is one list. */
function framesIn(plain: string, tokens: readonly Token[], read: NumberReader): readonly (readonly Token[])[] {
  if (!tokens.some(({ parted }, index) => parted && index > 0)) return [];
  const groups: Token[][] = [];
  for (const token of tokens) {
    if (token.parted || groups.length === 0) groups.push([]);
    groups.at(-1)?.push(token);
  }
  const sizeOf = (group: readonly Token[]) => group.reduce((sum, { from, to }) => sum + ((to - from + 1) >> 1), 0);
  if (groups.length < 2 || groups.some((group) => sizeOf(group) < FRAME)) return [];
  return groups.some((group) => isFrame(bytesIn(plain, group, read))) ? groups : [];
}

/** Whether a section is bytes among strings too: a direction says so, or it is a frame. */
function isSure(plain: string, { certainty, label, tokens }: Section): boolean {
  if (certainty < 3 || tokens.length < LEAST) return tokens.length === 1 && isFrame(bytesIn(plain, tokens, readHex));
  return label.direction !== undefined || isFrame(bytesIn(plain, tokens, readHex));
}

function groupAt(sections: readonly Section[], index: number): readonly Token[] {
  const { tokens } = sections[index] as Section;
  if (sections[index + 1]?.continued !== true) return tokens;
  const all = [...tokens];
  for (let at = index + 1; sections[at]?.continued === true; at++)
    for (const token of (sections[at] as Section).tokens) all.push(token);
  return all;
}

/** The base in which numbers are to be read: that of the text, unless their checksum or their shape says another. */
function ownBase(plain: string, tokens: readonly Token[], name: ByteNotation): ByteNotation {
  if (tokens.length < LEAST || (name !== 'hex' && name !== 'hexdump' && name !== 'decimal')) return name;
  if (tokens.some(({ kind, base, negative }) => kind === 'number' && (base !== 0 || negative))) return name;
  const numbers = tokens.filter(({ kind }) => kind === 'number');
  if (name === 'decimal') {
    if (!numbers.every(({ from, to }) => (to - from) % 2 === 0)) return name;
    const isLost = numbers.some((token) => !isDecimalByte(plain, token));
    return isLost || provesOther(plain, tokens, readDecimal, readHex) ? 'hex' : name;
  }
  if (!numbers.every((token) => isDecimalByte(plain, token))) return name;
  const isLost = numbers.some(({ from, to }) => to - from === 3);
  return isLost || provesOther(plain, tokens, readHex, readDecimal) ? 'decimal' : name;
}

const isDecimalByte = (plain: string, { from, to }: Token): boolean => {
  const digits = plain.slice(from, to);
  return digits.length <= 3 && /^\d+$/.test(digits) && Number(digits) <= 0xff;
};

const provesOther = (plain: string, tokens: readonly Token[], one: NumberReader, other: NumberReader): boolean =>
  isFrame(bytesIn(plain, tokens, other)) && !isFrame(bytesIn(plain, tokens, one));
