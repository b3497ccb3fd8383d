import type { Section } from './sections.ts';
import type { Token } from './token.ts';

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

interface Candidate extends DumpLine {
  readonly section: Section;
  readonly offset: string;
}

/**
 * The lines of a dump, by their sections: those that begin with a number that grows from line to line by as many as the
 * line has bytes. A single line must begin with zeros, in digits unlike those of its bytes.
 */
export function dumpLines(text: string, sections: readonly Section[]): ReadonlyMap<Section, DumpLine> {
  const candidates = sections.flatMap((section) => candidate(text, section));
  const follow = candidates.map((line, index) => goesOn(candidates[index - 1], line));
  const lines = new Map<Section, DumpLine>();
  for (const [index, line] of candidates.entries()) {
    const follows = follow[index] === true;
    if (follows || follow[index + 1] === true || beginsDump(line))
      lines.set(line.section, { tokens: line.tokens, follows });
  }
  return lines;
}

function candidate(text: string, section: Section): Candidate[] {
  const { first, tokens } = section;
  if (first === undefined || first.to - first.from < OFFSET_DIGITS) return [];
  const isAmong = tokens[0]?.start === first.start;
  return [
    { section, offset: text.slice(first.from, first.to), tokens: isAmong ? tokens.slice(1) : tokens, follows: false },
  ];
}

/** Whether the offset of a line is that of the line before and its bytes. */
function goesOn(before: Candidate | undefined, { offset }: Candidate): boolean {
  if (before === undefined || offset.length !== before.offset.length) return false;
  const size = before.tokens.reduce((sum, { from, to }) => sum + ((to - from + 1) >> 1), 0);
  return (
    size > 0 && BASES.some((base) => Number.parseInt(offset, base) - Number.parseInt(before.offset, base) === size)
  );
}

function beginsDump({ offset, tokens: [next] }: Candidate): boolean {
  return /^0+$/.test(offset) && next !== undefined && next.to - next.from !== offset.length;
}
