import type { Token } from './items.ts';
import type { Section } from './sections.ts';

/** Fewest lines that are a table. */
const LINES = 3;
/** Where a frame begins that is written field by field, one a line. */
const UNIT = /^\W*(?:slave|unit|station|node|device)\b/i;
const FUNCTION = /^\W*(?:function|func|fc)\b/i;
const FIELDS = 4;
/** The most bytes in one line of such a table. */
const FIELD = 4;

/**
 * Sections with what a table says in place of what its lines say: of lines that number their bytes (`3-4 | 80 00`, `02 12`)
 * without the numbers, and of the lines of a frame that is written field by field only the value of each. A table is one section.
 */
export function withTables(plain: string, sections: readonly Section[]): readonly Section[] {
  if (sections.length < LINES) return sections;
  const all: Section[] = [];
  for (let at = 0; at < sections.length; ) {
    const rows = numberedRows(plain, sections, at) ?? fieldRows(plain, sections, at);
    if (rows === undefined) {
      all.push(sections[at++] as Section);
      continue;
    }
    const section = sections[at] as Section;
    all.push({ ...section, tokens: rows.flat(), certainty: 3, continued: false, first: undefined, hint: 'again' });
    at += rows.length;
  }
  return all;
}

type Rows = readonly (readonly Token[])[];

/** The bytes of the lines from `at` on that number them one after the other, from 0 or 1 on. */
function numberedRows(plain: string, sections: readonly Section[], at: number): Rows | undefined {
  for (const base of [10, 16]) {
    const rows: (readonly Token[])[] = [];
    let next: number | undefined;
    for (let index = at; index < sections.length; index++) {
      const row = numberedRow(plain, sections[index] as Section, base);
      if (row === undefined || (next === undefined ? row.from > 1 : row.from !== next)) break;
      rows.push(row.tokens);
      next = row.to + 1;
    }
    if (rows.length >= LINES) return rows;
  }
  return undefined;
}

/** A line that begins with the place of its bytes, one number or a range of two, and has as many bytes as that. */
function numberedRow(plain: string, { runs, first, line }: Section, base: number) {
  const [run] = runs;
  if (
    first === undefined ||
    run === undefined ||
    run.tokens[0] !== first ||
    first.base !== 0 ||
    !/^[\s|]*$/.test(plain.slice(line.start, first.start))
  )
    return undefined;
  const numberOf = ({ from, to }: Token) =>
    to - from <= 3 ? Number.parseInt(plain.slice(from, to), base) : Number.NaN;
  const second = run.tokens[1];
  const between = second === undefined ? '' : plain.slice(first.end, second.start);
  const isRange = second !== undefined && /^(?:-|\.\.|~)$/.test(between);
  const from = numberOf(first);
  const to = isRange ? numberOf(second) : from;
  const size = to - from + 1;
  if (!(size >= 1 && size <= FIELD * 2)) return undefined;
  const rest = run.tokens.slice(isRange ? 2 : 1);
  const tokens = [rest, ...runs.slice(1).map((other) => other.tokens)].find(
    (some) => some.length > 0 && sizeOf(some) === size,
  );
  return tokens === undefined || (rest.length > 0 && tokens !== rest) ? undefined : { from, to, tokens };
}

const sizeOf = (tokens: readonly Token[]): number =>
  tokens.reduce((sum, { kind, from, to }) => sum + (kind === 'number' ? (to - from + 1) >> 1 : 0), 0);

/** The values of the lines from `at` on that are a frame field by field: `Slave Address 11`, `Function 03` and so on. */
function fieldRows(plain: string, sections: readonly Section[], at: number): Rows | undefined {
  const nameOf = ({ line, tokens }: Section) => plain.slice(line.start, Math.max(line.start, tokens[0]?.start ?? 0));
  const second = sections[at + 1];
  if (sections[at]?.alone === true) return undefined;
  if (second === undefined || !UNIT.test(nameOf(sections[at] as Section)) || !FUNCTION.test(nameOf(second)))
    return undefined;
  const rows: (readonly Token[])[] = [];
  let before: Section | undefined;
  for (let index = at; index < sections.length; index++) {
    const section = sections[index] as Section;
    const isNext = before === undefined || (section.line.start === before.line.after && section.line !== before.line);
    const value = fieldOf(section);
    if (!isNext || value === undefined || !/[a-z]/i.test(plain.slice(section.line.start, value[0]?.start))) break;
    rows.push(value);
    before = section;
  }
  return rows.length >= FIELDS ? rows : undefined;
}

/** The value of a field: the first run outside parentheses, of up to four bytes in pairs of digits. */
function fieldOf({ runs }: Section): readonly Token[] | undefined {
  const run = runs.find(({ inParentheses }) => !inParentheses);
  if (run === undefined || run.isName || run.bytes > FIELD) return undefined;
  return run.tokens.every(({ from, to }) => to - from === 2 || to - from === 4) ? run.tokens : undefined;
}
