import type { PrintedClock } from '../../captures/index.ts';
import {
  isReadOnly,
  linesAt,
  type NamedValue,
  nameAt,
  namedValues,
  type Profile,
  plainRegister,
  type Register,
} from '../../devices/index.ts';
import { entityNumber, writeCsvFile } from '../../notation/index.ts';
import type { KnownTable, KnownValue } from '../../trace/index.ts';
import { type KnownColumns, knownAt, knownTables } from './tab-messages.ts';
import { timeCell } from './trace-csv.ts';

/** Which of the known values are shown: those of one unit, and only those that changed. */
export interface KnownChoice {
  readonly unit: number | undefined;
  readonly changed: boolean;
}

/** The units of which something is known, in ascending order. */
export function knownUnits({ count, unit }: KnownColumns): readonly number[] {
  return [...new Set(unit.subarray(0, count))];
}

/** The places of the known values that are shown. */
export function knownShown(known: KnownColumns, { unit, changed }: KnownChoice): Int32Array {
  const places = new Int32Array(known.count);
  let length = 0;
  for (let at = 0; at < known.count; at++) {
    if (unit !== undefined && known.unit[at] !== unit) continue;
    if (changed && known.changes[at] === 0) continue;
    places[length++] = at;
  }
  return places.subarray(0, length);
}

/** Registers that a value is looked for in: a text may have as many as a reply holds. */
const MOST_REGISTERS = 125;

/** What a device calls a known value, and makes of it with those behind it; inside a longer value, its name alone. */
export interface KnownName {
  readonly name: string;
  readonly value: NamedValue | undefined;
}

/** What the device says of a known value; `undefined` if it knows nothing of that address. */
export function knownName(known: KnownColumns, at: number, profile: Profile | undefined): KnownName | undefined {
  if (profile === undefined) return undefined;
  const { table, address } = knownAt(known, at);
  const name = nameAt(profile, table, address);
  if (name === undefined) return undefined;
  const registers = linesAt(profile, table, address).flatMap(({ register, begins }) => (begins ? [register] : []));
  if (registers.length === 0) return { name, value: undefined };
  const [value] = namedValues({ ...profile, registers }, table, address, listFrom(known, at));
  return { name, value };
}

/** The known values from a place on that stand one behind another. */
function listFrom({ count, unit, table, address, value }: KnownColumns, at: number): readonly number[] {
  const list: number[] = [];
  for (let next = at; next < count && list.length < MOST_REGISTERS; next++) {
    const follows = unit[next] === unit[at] && table[next] === table[at];
    if (!follows || address[next] !== (address[at] ?? 0) + list.length) break;
    list.push(value[next] ?? 0);
  }
  return list;
}

/** Columns of the table of what is known. `address` is as sent, `number` that of manuals. */
export const knownColumnNames = [
  'unit',
  'table',
  'address',
  'number',
  'name',
  'value',
  'means',
  'when',
  'reads',
  'writes',
  'changes',
] as const;
export type KnownColumn = (typeof knownColumnNames)[number];

/** What the table of what is known says, in words. */
export interface KnownWords {
  readonly columns: Readonly<Record<KnownColumn, string>>;
  readonly table: (table: KnownTable) => string;
  /** What a value is in the unit of its line, or by its names; empty if its number says all. */
  readonly inUnits: (value: NamedValue) => string;
}

/** Known values as a file for spreadsheets (RFC 4180); `clock` prints their times. */
export function knownCsv(
  known: KnownColumns,
  places: Int32Array,
  profile: Profile | undefined,
  words: KnownWords,
  clock?: PrintedClock,
): string {
  const rows = Array.from(places, (at) => {
    const { unit, table, address, value, time, reads, writes, changes } = knownAt(known, at);
    const named = knownName(known, at, profile);
    const cells: Readonly<Record<KnownColumn, string | number>> = {
      unit,
      table: words.table(table),
      address,
      number: entityNumber(table, address),
      name: named?.name ?? '',
      value,
      means: named?.value ? words.inUnits(named.value) : '',
      when: timeCell(time, clock),
      reads,
      writes,
      changes,
    };
    return knownColumnNames.map((column) => String(cells[column]));
  });
  return writeCsvFile([knownColumnNames.map((column) => words.columns[column]), ...rows], 'marked');
}

/** The last address that has a number of five digits. */
const LAST_OF_FIVE = 9998;

/**
 * What is known of a unit as the profile of a device: each line that the chosen device has for it, and for what it has none, a plain register
 * by its number. What was never written can be read only.
 */
export function profileOfKnown(
  known: KnownColumns,
  unit: number,
  device: Profile | undefined,
  { name, source }: Pick<Profile, 'name' | 'source'>,
): Profile {
  const places = knownShown(known, { unit, changed: false });
  const registers = new Set<Register>();
  let last = 0;
  for (const at of places) {
    const one = knownAt(known, at);
    last = Math.max(last, one.address);
    const lines = device ? linesAt(device, one.table, one.address) : [];
    for (const { register } of lines) registers.add(register);
    if (lines.length === 0) registers.add(registerOf(one));
  }
  const { convention, serial, traits = [] } = device ?? {};
  return {
    id: '',
    name,
    source,
    convention: convention ?? (last > LAST_OF_FIVE ? 'six-digit' : 'five-digit'),
    ...(serial ? { serial: { ...serial, unit } } : { unit }),
    traits,
    registers: [...registers].sort(
      (one, other) => knownTables.indexOf(one.table) - knownTables.indexOf(other.table) || one.address - other.address,
    ),
    notes: [],
  };
}

const registerOf = ({ table, address, writes }: KnownValue): Register => ({
  ...plainRegister,
  name: entityNumber(table, address),
  table,
  address,
  access: isReadOnly(table) || writes === 0 ? 'r' : 'rw',
});
