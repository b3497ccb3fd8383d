import type { EntityTable } from '../profile.ts';
import { type AddressCell, type AddressStyle, readAddressCell } from './address-cell.ts';
import { isFilled } from './cell-kinds.ts';
import { saysNothing, tableSpokenOf } from './cell-words.ts';
import type { Block } from './header-rows.ts';
import type { MapColumn, Meaning } from './meaning.ts';
import { readNamesCell } from './names-cell.ts';
import type { SheetRow } from './sheet.ts';

/** A row of a table as texts by their meaning. */
export interface MapRow {
  readonly line: number;
  readonly text: (meaning: Meaning) => string;
  readonly texts: (meaning: Meaning) => readonly string[];
  readonly address: AddressCell;
  /** Of the column of printed numbers, where the table has addresses too. */
  readonly number?: AddressCell;
  readonly group: string;
  /** What a heading above, or the name of the sheet, says of the table. */
  readonly table?: EntityTable;
  /** Rows below it that say more of it. */
  readonly parts: MapPart[];
  readonly open?: true;
  readonly models: readonly string[];
}

/** A row that belongs to the register above it. */
export interface MapPart {
  readonly line: number;
  readonly number?: number;
  readonly name: string;
  readonly bit?: number;
}

export interface RowFault {
  readonly code: 'address-missing' | 'address-unreadable';
  readonly line: number;
  readonly got: string;
}

export interface BlockRows {
  readonly rows: readonly MapRow[];
  readonly headings: readonly SheetRow[];
  readonly faults: readonly RowFault[];
}

const isMark = (text: string): boolean => /^(?:x|X|✓|✔|●|•|√|yes|y|ja|j|oui|si|s[ií]|o|1|true)$/.test(text.trim());

/** Tells the rows of a block apart: registers, what belongs to the register above, headings, and what is none of these. */
export function rowsOf(
  block: Block,
  columns: readonly MapColumn[],
  style: AddressStyle,
  about: { readonly group: string; readonly table?: EntityTable },
): BlockRows {
  const rows: MapRow[] = [];
  const headings: SheetRow[] = [];
  const faults: RowFault[] = [];
  const places = new Map<Meaning, number[]>();
  columns.forEach(({ meaning }, at) => {
    places.set(meaning, [...(places.get(meaning) ?? []), at]);
  });
  const marks = (places.get('model') ?? []).filter((at) =>
    block.rows.every(({ cells }) => !isFilled(cells[at] ?? '') || isMark(cells[at] ?? '')),
  );
  const [addressAt] = places.get('address') ?? places.get('number') ?? [];
  const numberAt = places.has('address') ? places.get('number')?.[0] : undefined;
  let { group, table } = about;
  let pendingHeading: string | undefined;
  for (const row of block.rows) {
    const text = (meaning: Meaning) => {
      const at = places.get(meaning)?.[0];
      return at === undefined ? '' : (row.cells[at]?.trim() ?? '');
    };
    const own = addressAt === undefined ? '' : (row.cells[addressAt]?.trim() ?? '');
    const printed = numberAt === undefined ? '' : (row.cells[numberAt]?.trim() ?? '');
    const number = printed === '' ? undefined : readAddressCell(printed);
    const address = readAddressCell(own, style) ?? (saysNothing(own) ? number : undefined);
    const filled = row.cells.filter(isFilled);
    const isComment = /^#\s*\p{L}/u.test(row.cells[0]?.trim() ?? '') && filled.length < 3;
    if (address && !isComment && !(filled.length === 1 && columns.length > 3 && rows.length > 0)) {
      pendingHeading = undefined;
      const texts = (meaning: Meaning) =>
        (places.get(meaning) ?? []).map((at) => row.cells[at]?.trim() ?? '').filter((cell) => cell !== '');
      const models =
        marks.length > 0
          ? marks.filter((at) => isMark(row.cells[at] ?? '')).map((at) => columns[at]?.header ?? '')
          : texts('model');
      rows.push({
        line: row.line,
        text,
        texts,
        address,
        ...(number && numberAt !== undefined ? { number } : {}),
        group: text('group') || group,
        ...(table ? { table } : {}),
        parts: [],
        ...(row.open ? { open: true as const } : {}),
        models,
      });
      continue;
    }
    const last =
      pendingHeading === undefined
        ? rows.at(-1)
        : (rows.findLast((one) => one.text('name').length > 3 && pendingHeading?.includes(one.text('name'))) ??
          undefined);
    const parts = last && partsOf(row, filled, text, saysNothing(own));
    if (last && parts && parts.length > 0) {
      last.parts.push(...parts);
      continue;
    }
    if (isComment || isHeading(row, filled, own)) {
      headings.push(row);
      const said = filled
        .join(' ')
        .replace(/^#+\s*/, '')
        .trim();
      const spoken = tableSpokenOf(said);
      if (spoken) table = spoken;
      pendingHeading = said;
      if (!spoken || said.length > 24) group = said.slice(0, 80);
      continue;
    }
    faults.push({ code: saysNothing(own) ? 'address-missing' : 'address-unreadable', line: row.line, got: own });
  }
  return { rows, headings, faults };
}

const MOST_IN_HEADING = 2;

/** A row with little in it and no address; a merged cell repeats its text. */
const isHeading = (row: SheetRow, filled: readonly string[], own: string): boolean =>
  (new Set(filled).size <= MOST_IN_HEADING && (saysNothing(own) || filled[0]?.trim() === own)) ||
  filled.length === 0 ||
  row.cells.length === 1;

/** The numbers with names that a row without an address has: `1 = Heat`, a number beside a text, a bit with its name. */
function partsOf(
  row: SheetRow,
  filled: readonly string[],
  text: (meaning: Meaning) => string,
  noAddress: boolean,
): MapPart[] {
  if (!noAddress && filled.length > 1) return [];
  const bit = /^(?:bit|b)?\s*(\d{1,2})$/i.exec(text('bit'))?.[1];
  const name = text('name') || text('description') || text('names');
  if (bit !== undefined && name !== '') return [{ line: row.line, bit: Number(bit), name }];
  for (const cell of filled) {
    const { names, rest, bits } = readNamesCell(cell);
    if (names.length > 0 && rest === '')
      return names.map((one) => ({
        line: row.line,
        name: one.name,
        ...(bits ? { bit: one.number } : { number: one.number }),
      }));
  }
  const numbers = filled.filter((cell) => /^(?:0x[\da-f]+|\d{1,5})$/i.test(cell.trim()));
  const texts = filled.filter((cell) => /\p{L}{2}/u.test(cell) && !/^0x/i.test(cell));
  const [single = ''] = numbers;
  return numbers.length === 1 && texts.length >= 1 && filled.length <= 3
    ? [{ line: row.line, number: Number(single), name: texts[0]?.trim() ?? '' }]
    : [];
}
