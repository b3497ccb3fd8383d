import type { Token } from './items.ts';
import type { Section } from './sections.ts';

/** A line of a dump. */
export interface DumpLine {
  /** Without the offset that it begins with. */
  readonly tokens: readonly Token[];
  /** It goes on where the line before ended. */
  readonly follows: boolean;
}

/** Fewest digits of an offset. */
const OFFSET_DIGITS = 4;
/** The bases in which dumps count. */
const BASES = [16, 10, 8] as const;
/** Bytes of a full line; a shorter one ends what was sent together, where each direction counts on. */
const FULL = 16;

interface Candidate {
  readonly section: Section;
  readonly offset: string;
  readonly tokens: readonly Token[];
  readonly size: number;
  /** How far it is indented: the directions of a stream differ in that. */
  readonly indent: number;
  /** Its place among all sections. */
  readonly index: number;
}

/**
 * The lines of dumps, by their sections: those that begin with a number that grows from line to line by as many as the line
 * has bytes. Lines that are indented differently count each by themselves. A single line must begin with zeros, in digits
 * unlike those of its bytes.
 */
export function dumpLines(text: string, sections: readonly Section[]): ReadonlyMap<Section, DumpLine> {
  const candidates = sections.flatMap((section, index) => candidate(text, section, index));
  const before = new Map<number, Candidate>();
  const goesOnFrom = candidates.map((line) => {
    const last = before.get(line.indent);
    before.set(line.indent, line);
    return last !== undefined && goesOn(last, line) ? last : undefined;
  });
  const isGoneOn = new Set(goesOnFrom);
  const isStream =
    new Set(candidates.filter((line) => isGoneOn.has(line) || isZero(line)).map(({ indent }) => indent)).size > 1;
  const lines = new Map<Section, DumpLine>();
  for (const [index, line] of candidates.entries()) {
    const last = goesOnFrom[index];
    if (last === undefined && !isGoneOn.has(line) && !beginsDump(text, line)) continue;
    const isNext = last !== undefined && last.index === line.index - 1 && !(isStream && last.size < FULL);
    lines.set(line.section, { tokens: line.tokens, follows: isNext });
  }
  return lines;
}

function candidate(text: string, section: Section, index: number): Candidate[] {
  const { first, tokens, line } = section;
  if (first === undefined || first.to - first.from < OFFSET_DIGITS) return [];
  const rest = tokens[0]?.start === first.start ? tokens.slice(1) : tokens;
  const size = rest.reduce((sum, { from, to }) => sum + ((to - from + 1) >> 1), 0);
  const offset = text.slice(first.from, first.to);
  return [{ section, offset, tokens: rest, size, indent: first.start - line.start, index }];
}

const isZero = ({ offset }: Candidate) => /^0+$/.test(offset);

/** Whether the offset of a line is that of the line before and its bytes. */
const goesOn = ({ size, offset: before }: Candidate, { offset }: Candidate): boolean =>
  size > 0 &&
  offset.length === before.length &&
  BASES.some((base) => Number.parseInt(offset, base) - Number.parseInt(before, base) === size);

function beginsDump(text: string, line: Candidate): boolean {
  const [next] = line.tokens;
  const { first } = line.section;
  if (!isZero(line) || next === undefined || first === undefined) return false;
  return next.to - next.from !== line.offset.length || /^\s*:/.test(text.slice(first.end, first.end + 2));
}
