import { sameBytes } from '../../modbus/index.ts';
import { provedPart } from './evidence.ts';
import { withoutHeaders } from './headers.ts';
import { type Notation, notations, OWN, read } from './notations.ts';
import { Output } from './output.ts';
import { problemsAside } from './set-aside.ts';
import { Source } from './source.ts';
import type { AlternativeReading, ByteNotation, ByteText, TextProblem } from './types.ts';

/** How much of a text's beginning, and as much of its middle, in characters, decides how all of it is read. */
const SAMPLE = 10_000;
/** By how much more of the bytes must stand in frames for the less likely of two readings. */
const CLEARLY = 0.1;

/** Problems with numbers that are dropped, or of which digits are. */
const LOST: ReadonlySet<TextProblem['code']> = new Set(['odd-digits', 'not-of-base', 'value-over-255']);
/** The part of the time that goes into the sections of a long text. */
const SECTIONS = 0.65;
/** What being proved counts more than any shape. */
const PROVED = 100;

interface Candidate {
  readonly notation: Notation;
  readonly suits: number;
  readonly output: Output;
  readonly proved: number;
  /** Numbers that are not read, or only in part. */
  readonly lost: number;
}

/**
 * Reads the bytes that a text says, however it says them: in a log, a program, a dump, or alone. Where it could be read
 * in several ways, the one decides that gives frames whose checksum and fields hold, and where none does, the shape of
 * the numbers: pairs of digits are hexadecimal, a list with commas and without zeros in front decimal, and a lone number of
 * two digits, of which nothing tells, hexadecimal. `as` says the way instead. What cannot be read is a problem at its place,
 * and the rest is read. Never throws; takes time linear in the length of the text. `tell` hears how much is done, 0 to 1, line by
 * line.
 */
export function readBytes(text: string, as?: ByteNotation, tell?: (done: number) => void): ByteText {
  const source = new Source(text, tell && ((done) => tell(done * SECTIONS)));
  const candidates = candidatesFor(text, source);
  const reading = as ?? candidates[0]?.notation.name ?? 'hex';
  const output = readAs(source, reading, as !== undefined, tell && ((done) => tell(SECTIONS + done * (1 - SECTIONS))));
  const { bytes, origin, chunks, problems } = withoutHeaders({
    bytes: output.bytes,
    origin: output.origin,
    chunks: output.chunks,
    problems: output.length === 0 ? output.problems : withAside(source, output),
  });
  const sample = candidates.find(({ notation }) => notation.name === reading)?.output.bytes;
  return {
    bytes,
    origin,
    reading,
    alternatives: candidates
      .filter(({ notation, output: other }) => notation.name !== reading && !(sample && sameBytes(other.bytes, sample)))
      .map(({ notation }) => alternative(source, notation.name)),
    problems: bytes.length === 0 ? [...problems, ...nothing(text)] : problems,
    chunks,
  };
}

function readAs(source: Source, reading: ByteNotation, isAlone: boolean, tell?: (done: number) => void): Output {
  const output = new Output();
  read(source, reading, isAlone, output, tell);
  return output;
}

/** All problems by their place. */
function withAside(source: Source, output: Output): readonly TextProblem[] {
  const aside = problemsAside(source, output);
  return aside.length === 0
    ? output.problems
    : [...output.problems, ...aside].sort((one, other) => one.start - other.start);
}

/** The readings that give any bytes, best first. */
function candidatesFor(text: string, whole: Source): readonly Candidate[] {
  if (text.length <= 2 * SAMPLE) return candidatesOf(whole);
  // A log may begin with something other than bytes.
  const sample = `${linesFrom(text, 0)}\n${linesFrom(text, text.length >> 1)}`;
  const candidates = candidatesOf(new Source(sample));
  return candidates.length > 0 ? candidates : candidatesOf(whole);
}

/** A part of a text, of whole lines where they are not too long. */
function linesFrom(text: string, at: number): string {
  const part = text.slice(at, at + SAMPLE);
  const from = at === 0 ? 0 : part.indexOf('\n') + 1;
  const to = part.lastIndexOf('\n');
  return part.slice(from, to > from ? to : SAMPLE);
}

function candidatesOf(source: Source): readonly Candidate[] {
  const candidates: Candidate[] = [];
  for (const notation of notations) {
    const suits = notation.suits(source);
    if (suits === 0) continue;
    const output = readAs(source, notation.name, true);
    const lost = output.problems.filter(({ code }) => LOST.has(code)).length;
    if (output.length > 0)
      candidates.push({ notation, suits, output, proved: provedPart(withoutHeaders(output)), lost });
  }
  const best = Math.max(...candidates.map(({ proved }) => proved));
  const most = Math.max(...candidates.map(({ output }) => output.length));
  const isWhole = candidates.some(({ lost, suits }) => lost === 0 && suits < OWN);
  const rank = ({ suits, proved, output, lost }: Candidate) => {
    // A path with backslashes makes no string of a log.
    const isAside = suits === OWN && 2 * output.length < most;
    // What drops digits loses to what reads all.
    const isLost = isWhole && lost > 0 && suits < OWN;
    return (proved > best - CLEARLY && !isLost ? PROVED : 0) + (isAside ? 0 : suits) - (isLost ? OWN : 0);
  };
  return candidates.sort((one, other) => rank(other) - rank(one));
}

function alternative(source: Source, reading: ByteNotation): AlternativeReading {
  let bytes: Uint8Array | undefined;
  return {
    reading,
    get bytes() {
      bytes ??= withoutHeaders(readAs(source, reading, true)).bytes;
      return bytes;
    },
  };
}

function nothing(text: string): readonly TextProblem[] {
  const start = text.length - text.trimStart().length;
  const end = text.trimEnd().length;
  return end > start ? [{ code: 'no-bytes', start, end }] : [];
}
