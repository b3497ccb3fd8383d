import type { EntityTable } from '../profile.ts';
import { type AddressStyle, readAddressCell } from './address-cell.ts';
import { isFilled } from './cell-kinds.ts';
import { cellReaders } from './cell-readers.ts';
import { saysNothing, tableSpokenOf } from './cell-words.ts';
import type { Block } from './header-rows.ts';
import { type MapPart, MapRow, type Places, textAt } from './map-row.ts';
import type { MapColumn, Meaning } from './meaning.ts';
import { readNamesCell } from './names-cell.ts';
import type { SheetRow } from './sheet.ts';

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
  /** Of the column of addresses, and of the column of numbers beside it. */
  [style, numberStyle]: readonly [AddressStyle, AddressStyle],
  about: { readonly group: string; readonly table?: EntityTable },
): BlockRows {
  const rows: MapRow[] = [];
  const headings: SheetRow[] = [];
  const faults: RowFault[] = [];
  const places = new Map<Meaning, number[]>();
  columns.forEach(({ meaning }, at) => {
    places.set(meaning, [...(places.get(meaning) ?? []), at]);
  });
  const scales = [...(places.get('factor') ?? []), ...(places.get('divisor') ?? [])];
  const readers = cellReaders({
    groupedScales: !block.rows.some(({ cells }) => scales.some((at) => /,(?!000\b)\d/.test(cells[at] ?? ''))),
  });
  const groups = places.get('group')?.[0] ?? -1;
  const isSparse = block.rows.filter(({ cells }) => isFilled(cells[groups] ?? '')).length < block.rows.length * SPARSE;
  /** Of a cell that was merged over several rows, only the first is filled. */
  let above = '';
  const marks = (places.get('model') ?? []).filter((at) =>
    block.rows.every(({ cells }) => !isFilled(cells[at] ?? '') || isMark(cells[at] ?? '')),
  );
  const [addressAt] = places.get('address') ?? places.get('number') ?? [];
  const numberAt = places.has('address') ? places.get('number')?.[0] : undefined;
  const named = new Map<string, MapRow>();
  let { group, table } = about;
  /** The register that a heading names, or the last one. */
  let last: MapRow | undefined;
  /** A heading has named it: rows with hardly anything in them are its values. */
  let isAppendix = false;
  let fewest = Number.MAX_SAFE_INTEGER;
  for (const row of block.rows) {
    const own = addressAt === undefined ? '' : (row.cells[addressAt]?.trim() ?? '');
    const printed = numberAt === undefined ? '' : (row.cells[numberAt]?.trim() ?? '');
    const number = printed === '' ? undefined : readAddressCell(printed, numberStyle);
    const address = readAddressCell(own, style) ?? (saysNothing(own) ? number : undefined);
    const filled = row.cells.filter(isFilled);
    if (isSparse && isFilled(row.cells[groups] ?? '')) above = row.cells[groups]?.trim() ?? '';
    const isComment = filled.length < 3 && /^\s*#\s*\p{L}/u.test(row.cells[0] ?? '');
    const isValue = isAppendix && filled.length === 2 && filled.length < fewest;
    if (address && !isComment && !isValue && !(filled.length === 1 && columns.length > 3 && rows.length > 0)) {
      const models = modelsOf(row, marks, columns, places);
      last = new MapRow(
        row,
        places,
        address,
        number,
        textAt(row, places, 'group') || above || group,
        table,
        models,
        readers,
      );
      rows.push(last);
      isAppendix = false;
      fewest = Math.min(fewest, filled.length);
      named.set(last.text('name'), last).set(own, last);
      continue;
    }
    const parts = last && partsOf(row, filled, places, isValue || saysNothing(own));
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
      last = namedIn(said, named);
      isAppendix = last !== undefined;
      if (!spoken || said.length > 24) group = said.slice(0, 80);
      continue;
    }
    faults.push({ code: saysNothing(own) ? 'address-missing' : 'address-unreadable', line: row.line, got: own });
  }
  return { rows, headings, faults };
}

/** The models that have a register: those whose columns are marked, or those that a column lists. */
const modelsOf = (row: SheetRow, marks: readonly number[], columns: readonly MapColumn[], places: Places) =>
  marks.length > 0
    ? marks.filter((at) => isMark(row.cells[at] ?? '')).map((at) => columns[at]?.header ?? '')
    : (places.get('model') ?? [])
        .flatMap((at) => (row.cells[at] ?? '').split(/[,;/\n]/))
        .map((model) => model.trim())
        .filter(isFilled);

/** The register whose names an appendix lists below a heading: `Status`, `Status (40005)`, `40005: Status`. */
function namedIn(heading: string, named: ReadonlyMap<string, MapRow>): MapRow | undefined {
  const parts = [heading, ...heading.split(/[()[\]:,;–—]|\s-\s/)].map((part) => part.trim());
  const found = parts.map((part) => (part === '' ? undefined : named.get(part))).find((row) => row !== undefined);
  return found ?? named.get(/\b(?:0x[\da-f]+|\d{2,6})\b/i.exec(heading)?.[0] ?? '');
}

const MOST_IN_HEADING = 2;
/** A column of groups with fewer filled cells has merged ones. */
const SPARSE = 0.7;

/** A row with little in it and no address; a merged cell repeats its text. */
const isHeading = (row: SheetRow, filled: readonly string[], own: string): boolean =>
  (new Set(filled).size <= MOST_IN_HEADING && (saysNothing(own) || filled[0]?.trim() === own)) ||
  filled.length === 0 ||
  row.cells.length === 1;

/** The numbers with names that a row without an address has: `1 = Heat`, a number beside a text, a bit with its name. */
function partsOf(row: SheetRow, filled: readonly string[], places: Places, noAddress: boolean): MapPart[] {
  if (!noAddress && filled.length > 1) return [];
  const bit = /^(?:bit|b)?\s*(\d{1,2})$/i.exec(textAt(row, places, 'bit'))?.[1];
  const name = textAt(row, places, 'name') || textAt(row, places, 'description') || textAt(row, places, 'names');
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
