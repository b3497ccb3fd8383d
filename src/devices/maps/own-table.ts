import { unguardedCell } from '../../notation/index.ts';
import { notices as noticeCodes } from '../fault.ts';
import type { Profile } from '../profile.ts';
import { readTable } from '../table.ts';
import type { MapFault, MapFaultCode, MapNotice, MapNoticeCode } from './codes.ts';
import { type MapColumn, type Meaning, meanings } from './meaning.ts';
import type { Sheet } from './sheet.ts';
import { Tally } from './tally.ts';

export interface OwnTable {
  readonly profile: Profile;
  readonly columns: readonly MapColumn[];
  readonly faults: readonly MapFault[];
  readonly notices: readonly MapNotice[];
}

const isSetting = (cells: readonly string[]): boolean => cells[0]?.trim().startsWith('#') ?? false;

/**
 * Reads a table that was written here, by its own rules and without a question; `undefined` if it was not. Such a table has both an
 * `#id` and a `#convention`.
 */
export function readOwnTable(sheet: Sheet, name: string): OwnTable | undefined {
  const settings = new Set(
    sheet.rows.map(({ cells }) => cells[0]?.trim().toLowerCase()).filter((cell) => cell?.startsWith('#')),
  );
  if (!settings.has('#id') || !settings.has('#convention')) return undefined;
  const rows = sheet.rows.map((row) => ({ ...row, cells: row.cells.map(unguardedCell) }));
  const { profile, faults: told } = readTable(sheet.kind === 'delimited' ? rows : sheet.rows, name);
  if (told.some(({ code }) => code === 'header-missing')) return undefined;
  const faults = new Tally<MapFaultCode>();
  const notices = new Tally<MapNoticeCode>();
  for (const { line, ...fault } of told) {
    // It says how its numbers count.
    if (fault.code === 'addresses-like-numbers') continue;
    if (noticeCodes.has(fault.code)) notices.add('own-table', [line], { fault });
    else faults.add('own-table', [line], { fault });
  }
  const header = sheet.rows.find(({ cells }) => !isSetting(cells))?.cells ?? [];
  return { profile, columns: header.map(columnOf), faults: faults.list(), notices: notices.list() };
}

const OWN_WORDS: ReadonlyMap<string, Meaning> = new Map([
  ['scaleRegister', 'scale-register'],
  ['models', 'model'],
]);

function columnOf(header: string): MapColumn {
  const word = header.trim();
  return {
    header,
    meaning: OWN_WORDS.get(word) ?? meanings.find((each) => each === word.toLowerCase()) ?? 'other',
    why: 'header',
  };
}
