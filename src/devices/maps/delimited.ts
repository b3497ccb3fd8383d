import type { Sheet, SheetRow } from './sheet.ts';

/** What divides the cells of a line; `blanks` are two or more of them, as in a text copied from a document. */
type Delimiter = ',' | ';' | '\t' | '|' | 'blanks';

const DELIMITERS: readonly Delimiter[] = ['\t', ';', ',', '|', 'blanks'];
const SAMPLE_ROWS = 200;
const SAMPLE_CHARACTERS = 65_536;
const BLANKS = / {2,}/;
/** Weight of a delimiter below which blanks are tried: half of the rows have two cells. */
const DOUBTFUL = 0.5 * Math.log2(3);

/** A first line by which a spreadsheet is told the delimiter. */
const SAID = /^(?:"sep=(.)"|sep=(.))[ \t]*(?:\r\n|\r|\n|$)/i;

/**
 * Reads lines of cells between delimiters (RFC 4180, and what spreadsheets and people make of it): the delimiter is the one by
 * which most rows have as many cells as the others. A quoted cell may hold line breaks; where a quote has no partner, the cell is
 * the text without it, the row ends with its line, and is marked `open`.
 */
export function readDelimited(text: string): Sheet {
  const said = SAID.exec(text);
  const body = said ? said[0].length : 0;
  const delimiter = (said && DELIMITERS.find((each) => each === (said[1] ?? said[2]))) ?? evidentDelimiter(text, body);
  return { kind: 'delimited', rows: [...rowsOf(text, body, delimiter, said ? 2 : 1)].filter(isFilled) };
}

function evidentDelimiter(text: string, from: number): Delimiter {
  const sample = text.length - from > SAMPLE_CHARACTERS ? text.slice(from, from + SAMPLE_CHARACTERS) : text.slice(from);
  let best: Delimiter = ',';
  let most = 0;
  for (const delimiter of DELIMITERS) {
    if (delimiter === 'blanks' && most >= DOUBTFUL) break;
    const counts = new Map<number, number>();
    let rows = 0;
    for (const row of rowsOf(sample, 0, delimiter, 1)) {
      const { cells } = row;
      if (!isFilled(row)) continue;
      counts.set(cells.length, (counts.get(cells.length) ?? 0) + 1);
      if (++rows === SAMPLE_ROWS) break;
    }
    for (const [cells, alike] of counts) {
      const weight = cells < 2 ? 0 : (alike / rows) * Math.log2(1 + cells);
      if (weight > most) [best, most] = [delimiter, weight];
    }
  }
  return best;
}

const isFilled = ({ cells }: SheetRow): boolean => cells.some((cell) => cell.trim() !== '');

function* rowsOf(text: string, from: number, delimiter: Delimiter, first: number): Generator<SheetRow> {
  let line = first;
  let at = from;
  while (at < text.length) {
    const end = endOf(text, at);
    const plain = text.slice(at, end);
    if (delimiter === 'blanks' || !plain.includes('"')) {
      const cells = delimiter === 'blanks' ? plain.trim().split(BLANKS) : plain.split(delimiter);
      yield { line, cells };
      at = next(text, end);
      line++;
      continue;
    }
    const row = quotedRow(text, at, delimiter);
    yield { line, cells: row.cells, ...(row.open ? { open: true } : {}) };
    line += row.lines;
    at = row.next;
  }
}

/** Where the cell or the line ends that goes on here; without a delimiter, the line. */
function endOf(text: string, from: number, delimiter?: string): number {
  let at = from;
  while (at < text.length && text[at] !== '\n' && text[at] !== '\r' && text[at] !== delimiter) at++;
  return at;
}

const next = (text: string, end: number): number => (text[end] === '\r' && text[end + 1] === '\n' ? end + 2 : end + 1);

interface QuotedRow {
  readonly cells: readonly string[];
  readonly open: boolean;
  /** Where the next row begins, and how many lines this one has. */
  readonly next: number;
  readonly lines: number;
}

function quotedRow(text: string, from: number, delimiter: string): QuotedRow {
  const cells: string[] = [];
  let open = false;
  let lines = 1;
  let at = from;
  for (;;) {
    const quoted = quotedCell(text, at, delimiter);
    if (quoted) {
      cells.push(quoted.text);
      lines += quoted.breaks;
      at = quoted.end;
    } else {
      const end = endOf(text, at, delimiter);
      const cell = text.slice(at, end);
      const broken = cell.trimStart().startsWith('"');
      if (broken) open = true;
      cells.push(broken ? withoutQuotes(cell) : cell);
      at = end;
    }
    if (text[at] !== delimiter) return { cells, open, next: next(text, at), lines };
    at++;
  }
}

/** A cell with a quote that has no partner: without it, or without those around the whole. */
function withoutQuotes(cell: string): string {
  const text = cell.trim();
  if (!text.includes('"', 1)) return text.slice(1);
  return text.endsWith('"') && text.indexOf('"', 1) < text.length - 1 ? text.slice(1, -1) : cell;
}

interface QuotedCell {
  readonly text: string;
  readonly end: number;
  readonly breaks: number;
}

/** The quoted cell here, if its closing quote is followed by a delimiter or the end of a line, perhaps after blanks. */
function quotedCell(text: string, from: number, delimiter: string): QuotedCell | undefined {
  let start = from;
  while (text[start] === ' ') start++;
  if (text[start] !== '"') return undefined;
  let close = start;
  do close = text.indexOf('"', close + (close === start ? 1 : 2));
  while (close >= 0 && text[close + 1] === '"');
  if (close < 0) return undefined;
  let end = close + 1;
  while (text[end] === ' ') end++;
  if (end < text.length && text[end] !== delimiter && text[end] !== '\n' && text[end] !== '\r') return undefined;
  const inner = text.slice(start + 1, close);
  return { text: inner.replaceAll('""', '"'), end, breaks: inner.split(/\r\n|\r|\n/).length - 1 };
}
