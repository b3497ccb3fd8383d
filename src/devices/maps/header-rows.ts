import { headerMatches } from './header-words.ts';
import type { SheetRow } from './sheet.ts';

/** A header and the rows below it. */
export interface Block {
  /** The texts of the header; those of two rows are joined by a line end. Empty if the table has no header. */
  readonly headers: readonly string[];
  /** Rows above the header: titles and remarks. */
  readonly above: readonly SheetRow[];
  readonly headerRows: readonly SheetRow[];
  readonly rows: readonly SheetRow[];
}

const NUMBER = /^[-+]?(?:0x)?[\d.,]+$/i;
const filledCells = (row: SheetRow) => row.cells.filter((cell) => cell.trim() !== '');

/** Remembers what a header says: headers repeat in every block, and most cells of a file are looked at once. */
const strengthOf = (() => {
  return (cell: string): { readonly strength: number; readonly isAddress: boolean } => {
    const matches = cell.length > 60 ? [] : headerMatches(cell);
    const strength = matches[0]?.strength ?? 0;
    return {
      strength,
      isAddress: matches.some(
        ({ meaning, strength: own }) => (meaning === 'address' || meaning === 'number') && own >= 1.3,
      ),
    };
  };
})();

/** How much a row looks like a header: one for each cell that is a known phrase, less for those that only hold one; 0 for data. */
function headerScore(row: SheetRow): number {
  const cells = filledCells(row).map((cell) => cell.trim());
  if (cells.length < 2 || cells.some((cell) => NUMBER.test(cell))) return 0;
  const found = cells.map(strengthOf);
  const score = found.reduce((sum, { strength }) => sum + (strength >= 2 ? 1 : strength >= 1.3 ? 0.5 : 0), 0);
  return score + (found.some(({ isAddress }) => isAddress) ? 1 : 0);
}

/** Rows among which the first header is looked for. */
const SEARCHED = 60;
const LEAST_FIRST = 2;
/** A header further down begins another table, so that more is asked of it. */
const LEAST_LATER = 4;

/** Cuts rows at their headers. `headed` says that the first row is one. Rows that are blank are in no block. */
export function blocksOf(rows: readonly SheetRow[], headed: boolean): readonly Block[] {
  const filled = rows.filter((row) => row.cells.some((cell) => cell.trim() !== ''));
  const first = headed ? 0 : bestHeader(filled.slice(0, SEARCHED));
  if (first === undefined || filled.length === 0) return [{ headers: [], above: [], headerRows: [], rows: filled }];
  const blocks: Block[] = [];
  let [at, above] = [first, filled.slice(0, first)] as [number, readonly SheetRow[]];
  while (at < filled.length) {
    const { headers, headerRows, above: left } = headerAt(filled, at, above, headed && at === first);
    const begin = at + headerRows.filter(({ line }) => line >= (filled[at] as SheetRow).line).length;
    let next = begin;
    const body: SheetRow[] = [];
    const repeats: SheetRow[] = [];
    for (; next < filled.length; next++) {
      const row = filled[next] as SheetRow;
      if (!looksLikeHeader(row)) body.push(row);
      else if (isSame(row, filled[at] as SheetRow)) repeats.push(row);
      else break;
    }
    // Titles of the next table end this one.
    const own =
      next < filled.length
        ? body.findLastIndex((row) => filledCells(row).length > 1 && /\d/.test(row.cells.join(''))) + 1
        : body.length;
    blocks.push({ headers, above: left, headerRows: [...headerRows, ...repeats], rows: body.slice(0, own) });
    above = body.slice(own);
    at = next;
  }
  return blocks;
}

/** Most rows have a number, and no header has. */
const hasNumber = (row: SheetRow): boolean => row.cells.some((cell) => /^\s*[-+]?\d[\d.,]*\s*$/.test(cell));

const looksLikeHeader = (row: SheetRow): boolean =>
  !hasNumber(row) && filledCells(row).length > 2 && headerScore(row) >= LEAST_LATER;

const isSame = (row: SheetRow, other: SheetRow): boolean =>
  row.cells.join('\t').trim() === other.cells.join('\t').trim();

function bestHeader(rows: readonly SheetRow[]): number | undefined {
  const scores = rows.map((row) => (/^#\w/.test(row.cells[0]?.trim() ?? '') ? 0 : headerScore(row)));
  const best = scores.reduce((most, score) => Math.max(most, score), 0);
  // The first one that is nearly as good: another table may follow, and titles may hold a word of headers.
  const found = scores.findIndex((score) => score >= Math.max(LEAST_FIRST, best * 0.6));
  return found < 0 ? undefined : found;
}

/** The header at a row, with the row above or below that belongs to it. */
function headerAt(rows: readonly SheetRow[], at: number, above: readonly SheetRow[], single: boolean) {
  const row = rows[at] as SheetRow;
  const before = above.at(-1);
  const after = rows[at + 1];
  const alone = { headers: row.cells.map((cell) => cell.trim()), headerRows: [row], above };
  if (single) return alone;
  // Over the cells of this header stand words for several of them.
  const isOver =
    before &&
    before.line >= row.line - 1 &&
    filledCells(before).length > 1 &&
    !filledCells(before).some((cell) => NUMBER.test(cell.trim())) &&
    !/^#/.test(before.cells[0] ?? '') &&
    filledCells(before).some((cell) => strengthOf(cell).strength >= 2);
  if (isOver) return { headers: joined(before.cells, row.cells), headerRows: [before, row], above: above.slice(0, -1) };
  const isUnder =
    after &&
    filledCells(after).length > 1 &&
    !filledCells(after).some((cell) => NUMBER.test(cell.trim())) &&
    after.cells.some(
      (cell, place) =>
        cell.trim() !== '' &&
        ((row.cells[place] ?? '').trim() === '' || row.merged?.includes(place) || after.merged?.includes(place)) &&
        strengthOf(cell).strength >= 2,
    ) &&
    after.cells.every((cell) => cell.trim() === '' || strengthOf(cell).strength >= 1 || cell.length < 12);
  return isUnder ? { headers: joined(row.cells, after.cells), headerRows: [row, after], above } : alone;
}

/** The texts of two rows of a header: a blank cell of the upper row belongs to what stands left of it. */
function joined(upper: readonly string[], lower: readonly string[]): string[] {
  let last = '';
  return Array.from({ length: Math.max(upper.length, lower.length) }, (_, place) => {
    const [over, under] = [upper[place]?.trim() ?? '', lower[place]?.trim() ?? ''];
    if (over !== '') last = over;
    if (under === '' || under === over) return over;
    return over === '' && last === '' ? under : `${over || last}\n${under}`;
  });
}
