import { attributeNamed, scanMarkup } from './markup.ts';
import { type Merge, type RawRow, withMerges } from './merged.ts';
import type { Sheet, SheetProblem } from './sheet.ts';

const WIDEST = 1000;
const columnsOf = attributeNamed('colspan');
const rowsOf = attributeNamed('rowspan');
const BREAKS: ReadonlySet<string> = new Set(['br', 'p', 'div', 'li', 'tr']);

interface Table {
  name: string;
  readonly rows: RawRow[];
  readonly merges: Merge[];
  /** For each column, how many rows below the present one a cell still covers. */
  readonly covered: number[];
  cell: string | undefined;
  span: { readonly columns: number; readonly rows: number };
}

/** The tables of an HTML text, those inside cells too, with the heading or the caption above each. */
export function readHtml(source: string, problems: SheetProblem[], most: number): readonly Sheet[] {
  const sheets: Sheet[] = [];
  const open: Table[] = [];
  let heading: string | undefined;
  let caption = false;
  let last = '';
  let left = most;
  scanMarkup(source, { open: opened, close: closed, text }, 'html');
  while (open.length > 0) endTable();
  if (left < 0) problems.push({ code: 'too-many-cells', most });
  return sheets;

  function opened(name: string, attributes: string): void {
    const table = open.at(-1);
    if (name === 'table') {
      open.push({ name: last, rows: [], merges: [], covered: [], cell: undefined, span: { columns: 1, rows: 1 } });
      last = '';
    } else if (/^h[1-6]$/.test(name)) heading = '';
    else if (name === 'caption' && table) {
      caption = true;
      table.name = '';
    } else if (name === 'tr' && table) {
      endCell(table);
      newRow(table);
    } else if ((name === 'td' || name === 'th') && table) {
      endCell(table);
      if (table.rows.length === 0) newRow(table);
      const span = (text: string) => Math.min(WIDEST, Math.max(1, Math.floor(Number(text)) || 1));
      table.cell = '';
      table.span = { columns: span(columnsOf(attributes)), rows: span(rowsOf(attributes)) };
    } else if (BREAKS.has(name) && table?.cell !== undefined) table.cell += '\n';
  }

  function closed(name: string): void {
    const table = open.at(-1);
    if (heading !== undefined && /^h[1-6]$/.test(name)) {
      last = heading.trim();
      heading = undefined;
    }
    if (name === 'caption') caption = false;
    if (!table) return;
    if (name === 'td' || name === 'th' || name === 'tr') endCell(table);
    else if (name === 'table') endTable();
    else if (name === 'p' && table.cell !== undefined) table.cell += '\n';
  }

  function text(each: string): void {
    const flat = each.replace(/[ \t\r\n\u00a0]+/g, ' ');
    const table = open.at(-1);
    if (caption && table) table.name += flat;
    else if (heading !== undefined) heading += flat;
    else if (table?.cell !== undefined) table.cell += flat;
  }

  function newRow({ rows, covered }: Table): void {
    left -= 1 + covered.length;
    if (left < 0) return;
    rows.push({ line: rows.length + 1, cells: [] });
    for (let column = 0; column < covered.length; column++) covered[column] = Math.max(0, (covered[column] ?? 0) - 1);
  }

  function endCell(table: Table): void {
    const row = table.rows.at(-1);
    if (table.cell === undefined || !row) return;
    let column = row.cells.length;
    while ((table.covered[column] ?? 0) > 0) column++;
    while (row.cells.length < column) row.cells.push('');
    const { columns, rows } = table.span;
    left -= columns;
    if (left < 0) return;
    row.cells.push(tidy(table.cell));
    for (let each = column; each < column + columns; each++) {
      if (each > column) row.cells.push('');
      while (table.covered.length <= each) table.covered.push(0);
      table.covered[each] = rows;
    }
    if (columns * rows > 1) table.merges.push({ line: row.line, lastLine: row.line + rows - 1, column, columns });
    table.cell = undefined;
  }

  function endTable(): void {
    const table = open.pop();
    if (!table) return;
    endCell(table);
    const rows = withMerges(table.rows, table.merges, problems, most);
    const name = table.name.trim();
    if (rows.length > 0) sheets.push({ ...(name === '' ? {} : { name }), kind: 'html', rows });
  }
}

const tidy = (text: string): string =>
  text
    .split('\n')
    .map((line) => line.trim())
    .join('\n')
    .replace(/\n{2,}/g, '\n')
    .trim();
