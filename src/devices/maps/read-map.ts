import { placeOf } from '../collect.ts';
import { type Convention, conventions, type Register } from '../profile.ts';
import type { AddressCell } from './address-cell.ts';
import type { MapFault, MapNotice, MapQuestion } from './codes.ts';
import type { Answers } from './decisions.ts';
import { draftRows } from './draft-rows.ts';
import { collisions, type JoinedRegister, joinBits, outliers } from './joined.ts';
import { type MapBlock, mapBlocks } from './map-blocks.ts';
import type { MapColumn, Meaning } from './meaning.ts';
import { CONVENTIONS, placeRows } from './place-rows.ts';
import { linesOf, Report } from './report.ts';
import type { SheetSettings } from './settings-rows.ts';
import type { Sheet } from './sheet.ts';

/** What became of a row. */
export type RowFate = 'setting' | 'heading' | 'header' | 'register' | 'fault';

export interface MapReading {
  readonly registers: readonly Register[];
  readonly columns: readonly MapColumn[];
  readonly questions: readonly MapQuestion[];
  readonly faults: readonly MapFault[];
  readonly notices: readonly MapNotice[];
  readonly about: Pick<SheetSettings, 'facts' | 'traits' | 'notes' | 'serial'> & {
    readonly title: string;
    readonly convention: Convention;
  };
  /** Of each row of each sheet that is not blank. */
  readonly fates: readonly ReadonlyMap<number, RowFate>[];
}

/** Reads the registers of all tables of a file, whose name may name their table. */
export function readMap(sheets: readonly Sheet[], answers: Answers, file = ''): MapReading {
  const { blocks: all, ranges } = withoutRanges(mapBlocks(sheets, answers));
  const used = all.filter(({ hasAddresses, read }) => hasAddresses && read.rows.length > 0);
  const report = new Report();
  for (const block of all) tellOfBlock(block, used.length > 0, report);
  const left = listedColumns(used, false).filter(({ meaning, header }) => meaning === 'other' && header !== '');
  if (left.length > 0)
    report.notices.add('columns-left', [], { headers: [...new Set(left.map(({ header }) => header))] });
  const { placed, counting, pair } = placeRows(used, ranges, answers, report, file);
  const joined = joinBits(draftRows(placed, used, answers, report));
  tellOfRegisters(joined, report);
  const first = used[0] ?? all[0];
  // Tables of several units say nothing of one device.
  const units = new Set(used.map(({ sheet }) => sheet.facts?.unit));
  const { traits = [], notes = [], serial, facts } = first?.settings ?? {};
  return {
    registers: toldApart(joined.map(({ register }) => register)),
    columns: listedColumns(used.length > 0 ? used : all, pair),
    questions: report.questions,
    faults: report.faults.list(),
    notices: report.notices.list(),
    about: {
      facts: { ...first?.sheet.facts, ...(units.size > 1 ? { unit: '' } : {}), ...facts },
      traits,
      notes,
      ...(serial ? { serial } : {}),
      title: first?.block.above[0]?.cells.find((cell) => cell.trim() !== '')?.trim() ?? '',
      convention: conventions.find((each) => each === facts?.convention?.toLowerCase()) ?? CONVENTIONS[counting],
    },
    fates: sheets.map((sheet) => fatesOf(sheet, all, joined, used.length > 0)),
  };
}

/**
 * Lists in a file of objects that name nothing, beside one that names registers, say which ranges are read: they hold no registers,
 * and their numbers are evidence of how addresses count.
 */
function withoutRanges(blocks: readonly MapBlock[]): {
  readonly blocks: readonly MapBlock[];
  readonly ranges: readonly AddressCell[];
} {
  const isRange = ({ sheet, columns }: MapBlock) =>
    sheet.kind === 'objects' && !columns.some(({ meaning }) => NAMING.has(meaning));
  if (blocks.every(isRange)) return { blocks, ranges: [] };
  return {
    blocks: blocks.map((block) => (isRange(block) ? { ...block, hasAddresses: false } : block)),
    ranges: blocks.filter(isRange).flatMap(({ read }) => read.rows.map(({ address }) => address)),
  };
}

const NAMING: ReadonlySet<Meaning> = new Set(['name', 'other-name', 'description']);

/** A register that has the name and the address of one before it gets a number behind its name: a profile has no two alike. */
function toldApart(registers: readonly Register[]): readonly Register[] {
  const taken = new Set<string>();
  const numbers = new Map<string, number>();
  return registers.map((register) => {
    const place = placeOf(register);
    let named = register;
    let number = numbers.get(place) ?? 1;
    while (taken.has(placeOf(named))) named = { ...register, name: `${register.name} (${++number})` };
    numbers.set(place, number);
    taken.add(placeOf(named));
    return named;
  });
}

/** Columns of tables with the same header are listed once. */
function listedColumns(blocks: readonly MapBlock[], pair: boolean): readonly MapColumn[] {
  const seen = new Set<string>();
  return blocks.flatMap(({ block, columns }) => {
    const key = block.headers.join('\t');
    if (key !== '' && seen.has(key)) return [];
    seen.add(key);
    const isPair = pair && columns.some(({ meaning }) => meaning === 'number');
    return columns.map((column) =>
      isPair && (column.meaning === 'number' || column.meaning === 'address')
        ? { ...column, why: 'pair' as const }
        : column,
    );
  });
}

/** Says what of a table is no register, and what of it is doubtful as a whole. `some` other table has registers. */
function tellOfBlock(one: MapBlock, some: boolean, { notices, faults }: Report): void {
  const { read, block, sheet, hasAddresses } = one;
  const headings = linesOf([...block.above, ...(hasAddresses ? read.headings : [])]);
  if (headings.length > 0) notices.add('heading', headings);
  if (!hasAddresses && some && block.rows.length > 0)
    notices.add('table-left', linesOf(block.rows), { sheet: sheet.name ?? '' });
  if (!hasAddresses && !some) faults.add('no-address-column', linesOf(block.rows));
  if (!hasAddresses) return;
  for (const { code, line } of read.faults) faults.add(code, [line]);
  const width = block.headers.length;
  const longer = read.rows.filter(
    (row) => width > 0 && row.source.cells.slice(width).some((cell) => cell.trim() !== ''),
  );
  if (longer.length > 0) notices.add('more-cells', linesOf(longer));
}

function tellOfRegisters(joined: readonly JoinedRegister[], { notices }: Report): void {
  for (const { draft } of joined) for (const code of draft.notices) notices.add(code, [draft.row.line]);
  const { twice, overlaps } = collisions(joined);
  if (twice.length > 0) notices.add('address-twice', twice);
  if (overlaps.length > 0) notices.add('overlap', overlaps);
  const far = outliers(joined);
  if (far.length > 0) notices.add('outlier', far);
}

function fatesOf(
  sheet: Sheet,
  blocks: readonly MapBlock[],
  joined: readonly JoinedRegister[],
  some: boolean,
): ReadonlyMap<number, RowFate> {
  const fates = new Map<number, RowFate>();
  const set = (lines: readonly { readonly line: number }[], fate: RowFate) => {
    for (const { line } of lines) if (!fates.has(line)) fates.set(line, fate);
  };
  const own = blocks.filter((block) => block.sheet === sheet);
  const rows = new Set(own.flatMap(({ read }) => read.rows));
  for (const { draft, rows: lines } of joined)
    if (rows.has(draft.row)) for (const line of lines) fates.set(line, 'register');
  for (const { settings, block, read, hasAddresses } of own) {
    set(settings.rows, 'setting');
    set(block.headerRows, 'header');
    set([...block.above, ...(hasAddresses ? read.headings : [])], 'heading');
    set(block.rows, !hasAddresses && some ? 'heading' : 'fault');
  }
  return fates;
}
