/** The ways a table is written: for a spreadsheet, for a forum, for a file. */
export const tableFormats = ['tsv', 'markdown', 'csv'] as const;
export type TableFormat = (typeof tableFormats)[number];

const WRITERS: Readonly<Record<TableFormat, (rows: readonly (readonly string[])[]) => string[]>> = {
  tsv: (rows) => rows.map((cells) => cells.join('\t')),
  markdown: ([head = [], ...body]) => {
    const line = (cells: readonly string[]) => `| ${cells.map((cell) => cell.replaceAll('|', '\\|')).join(' | ')} |`;
    return [line(head), line(head.map(() => '---')), ...body.map(line)];
  },
  csv: (rows) => rows.map((cells) => cells.map(quoted).join(',')),
};

/** Blanks at an end would be lost on some readers, and a mark of UTF-8 looks like the beginning of a file. */
const quoted = (cell: string) => (/[",\r\n\uFEFF]|^ | $/.test(cell) ? `"${cell.replaceAll('"', '""')}"` : cell);

/** What a spreadsheet would run as a formula; a number with a sign is not one. */
const FORMULA = /^'*(?:[=@\t\r]|[-+](?!$|\d+(?:[.,]\d+)?(?:e[-+]?\d+)?$))/i;

/** A cell that a spreadsheet shows and does not run: with an apostrophe before what would be a formula. */
export const guardedCell = (cell: string): string => (FORMULA.test(cell) ? `'${cell}` : cell);

/** The cell that was guarded. */
export const unguardedCell = (cell: string): string =>
  cell.startsWith("'") && FORMULA.test(cell.slice(1)) ? cell.slice(1) : cell;

/** A table as text, its head first. Cells hold no tabs, and but for CSV no line ends. */
export const writeTableText = (rows: readonly (readonly string[])[], format: TableFormat): string =>
  WRITERS[format](rows).join('\n');

/** A table as a file of CSV (RFC 4180), its head first, whose cells no spreadsheet runs (`unguardedCell` reads them back); `marked` has the mark by which spreadsheets know UTF-8. */
export const writeCsvFile = (rows: readonly (readonly string[])[], mark?: 'marked'): string =>
  `${mark ? '\uFEFF' : ''}${WRITERS.csv(rows.map((cells) => cells.map(guardedCell))).join('\r\n')}\r\n`;
