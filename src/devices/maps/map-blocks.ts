import { type EntityTable, entityTables } from '../profile.ts';
import { type StyleReading, styleOf } from './address-style.ts';
import { tableNamed, tableSpokenOf } from './cell-words.ts';
import { columnsOf } from './columns.ts';
import type { Answers } from './decisions.ts';
import { type Block, blocksOf } from './header-rows.ts';
import { withJoinedColumns } from './joined-columns.ts';
import { type BlockRows, rowsOf } from './map-rows.ts';
import type { MapColumn } from './meaning.ts';
import { namedMeanings } from './named/index.ts';
import { type SheetSettings, settingsOf } from './settings-rows.ts';
import type { Sheet, SheetRow } from './sheet.ts';

/** A table of a file with its columns understood and its rows told apart. */
export interface MapBlock {
  readonly sheet: Sheet;
  readonly settings: SheetSettings;
  readonly block: Block;
  readonly columns: readonly MapColumn[];
  readonly style: StyleReading;
  readonly read: BlockRows;
  /** It has a column of addresses. */
  readonly hasAddresses: boolean;
  /** That column is called a column of printed numbers. */
  readonly printed: boolean;
}

/** The tables of all sheets. Tables with the same header have the same answers for their columns, which are numbered from 1. */
export function mapBlocks(sheets: readonly Sheet[], answers: Answers): readonly MapBlock[] {
  const firstColumn = new Map<string, number>();
  let columnCount = 0;
  const names = sheets.map(({ name = '' }) => name);
  return sheets.flatMap((sheet) => {
    const settings = settingsOf(sheet.rows);
    return blocksOf(settings.others, sheet.headed === true).map((found): MapBlock => {
      const block = withJoinedColumns(found);
      const key = block.headers.join('\t');
      const width = block.rows.reduce((most, { cells }) => Math.max(most, cells.length), block.headers.length);
      const first = (key === '' ? undefined : firstColumn.get(key)) ?? columnCount;
      if (first === columnCount) columnCount += width;
      firstColumn.set(key, first);
      const columns = columnsOf(
        block,
        sheet.headed === true,
        (at) => answers[`column-${first + at + 1}`],
        sheet.kind === 'named' ? namedMeanings : undefined,
      );
      const at = columns.findIndex(({ meaning }) => meaning === 'address');
      const own = at >= 0 ? at : columns.findIndex(({ meaning }) => meaning === 'number');
      const style = styleOf(
        block.rows.map(({ cells }) => cells[own] ?? ''),
        columns[own]?.header ?? '',
        answers['base'],
      );
      const table = tableNamed(columns[own]?.header ?? '') ?? tableOf(sheet, settings, block.above, names);
      const group = ['workbook', 'markdown', 'html'].includes(sheet.kind) ? (sheet.name ?? '') : '';
      const second = columns.findIndex(({ meaning }, place) => meaning === 'number' && place !== own);
      const secondStyle = styleOf(
        block.rows.map(({ cells }) => cells[second] ?? ''),
        columns[second]?.header ?? '',
      );
      const read = rowsOf(block, columns, [style.style, secondStyle.style], { group, ...(table ? { table } : {}) });
      return { sheet, settings, block, columns, style, read, hasAddresses: own >= 0, printed: at < 0 && own >= 0 };
    });
  });
}

/** The table that the file, its headings or the name of a sheet give all rows of a table. */
function tableOf(
  sheet: Sheet,
  settings: SheetSettings,
  above: readonly SheetRow[],
  names: readonly string[],
): EntityTable | undefined {
  const said = settings.facts.table ?? sheet.facts?.table ?? '';
  const own = entityTables.find((table) => table === said) ?? tableNamed(said);
  if (own) return own;
  const key =
    (sheet.name ?? '')
      .split(/[.[\]]/)
      .filter((part) => part !== '')
      .at(-1) ?? '';
  const heading = above.map(({ cells }) => cells.join(' ')).findLast((text) => tableSpokenOf(text));
  const named =
    tableNamed(key) ?? tableSpokenOf(sheet.name ?? '') ?? (heading === undefined ? undefined : tableSpokenOf(heading));
  // A list to be read beside one of holding registers.
  return named ?? (/^read$/i.test(key) && names.some((name) => /hold/i.test(name)) ? 'input-register' : undefined);
}
