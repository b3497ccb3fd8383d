import {
  countsValues,
  departure,
  type EntityTable,
  isOwnOn,
  type NamedValue,
  nameAt,
  namedValues,
  ownByteCount,
  type Profile,
  type Trait,
  takesAnyOn,
} from '../../devices/index.ts';
import { fieldByName, fieldValue, firstAddress, type Reading } from '../../modbus/index.ts';
import type { FrameNames } from '../frame/device-names.ts';

/** What is said of a device's names. */
export interface FrameNameWords {
  /** A value with its name: `P0681 actual speed = 4096 (30.0 Hz).` */
  readonly named: (value: NamedValue) => string;
  /** The value alone, in its unit or by its name, where that is not the number sent: `30.0 Hz`. */
  readonly inUnits: (value: NamedValue) => string;
  readonly nameOnly: (name: string) => string;
  readonly anyValueIsOn: string;
  /** That the device wants `count` bytes for a quantity of bits. */
  readonly byteCountWanted: (count: number, quantity: number) => string;
  /** That the device with this name departs from a rule. */
  readonly departures: Readonly<Record<Trait, (device: string) => string>>;
}

/** Names what is in a frame as a device's profile has it. */
export const frameNames =
  (profile: Profile, words: FrameNameWords) =>
  (reading: Reading): FrameNames => {
    const table = reading.description?.table;
    if (table === undefined || table === 'file-record') return NO_NAMES;
    const lists = new Map<string, ReadonlyMap<number, readonly NamedValue[]>>();
    const valuesOf = (list: string) => {
      const found = lists.get(list) ?? byPlace(listValues(profile, table, reading, list));
      lists.set(list, found);
      return found;
    };
    return {
      field: (name) => fieldName(profile, words, table, reading, name),
      short: (name) => shortName(profile, words, table, reading, name),
      item: (list, index) => {
        const [from, to] =
          fieldByName(reading, list)?.kind === 'bits' ? [8 * index, 8 * index + 8] : [index, index + 1];
        const values = valuesOf(list);
        return Array.from({ length: to - from }, (_, into) => values.get(from + into) ?? [])
          .flat()
          .map(words.named)
          .join(' ');
      },
      covers: (list, index) => (fieldByName(reading, list)?.kind === 'bits' ? 1 : covered(valuesOf(list), index)),
      addressOf: (list, index) => (countsValues(profile) ? countedAddress(valuesOf(list), index) : undefined),
      departure: (problem) => {
        const trait = departure(profile, reading, problem);
        return trait ? words.departures[trait](profile.name) : '';
      },
    };
  };

const NO_NAMES: FrameNames = {
  field: () => '',
  short: () => '',
  item: () => '',
  covers: () => 1,
  addressOf: () => undefined,
  departure: () => '',
};

/** The items of the widest value that begins at a place and is whole, if no other begins inside it. */
function covered(values: ReadonlyMap<number, readonly NamedValue[]>, index: number): number {
  const size = Math.max(1, ...(values.get(index) ?? []).map((value) => (value.cutOff ? 1 : value.size)));
  for (let at = index + 1; at < index + size; at++) if (values.has(at)) return 1;
  return size;
}

/** The address of an item if each value has one address: that of the value it is in, or as many behind it as items follow. */
function countedAddress(values: ReadonlyMap<number, readonly NamedValue[]>, index: number): number | undefined {
  for (let at = index; at >= 0; at--) {
    const [first, ...others] = values.get(at) ?? [];
    if (first === undefined) continue;
    const widest = Math.max(first.size, ...others.map(({ size }) => size));
    return first.address + Math.max(0, index - at - widest + 1);
  }
  return undefined;
}

/** Values by where they begin in their list, so that each line of an explanation finds its own at once. */
function byPlace(values: readonly NamedValue[]): ReadonlyMap<number, readonly NamedValue[]> {
  const places = new Map<number, NamedValue[]>();
  for (const value of values) {
    const here = places.get(value.at);
    if (here) here.push(value);
    else places.set(value.at, [value]);
  }
  return places;
}

function listValues(profile: Profile, table: EntityTable, reading: Reading, list: string): readonly NamedValue[] {
  const first = firstAddress(reading, list);
  const items = reading.fields[list];
  return first === undefined || !Array.isArray(items) ? [] : namedValues(profile, table, first, items);
}

function fieldName(
  profile: Profile,
  words: FrameNameWords,
  table: EntityTable,
  reading: Reading,
  name: string,
): string {
  if (name === 'value') return singleValue(profile, words, table, reading);
  if (name === 'byteCount') return byteCount(profile, words, reading);
  const found = addressName(profile, table, reading, name);
  return found === undefined ? '' : words.nameOnly(found);
}

function addressName(profile: Profile, table: EntityTable, reading: Reading, name: string): string | undefined {
  const value = fieldValue(reading, name);
  const isAddress = fieldByName(reading, name)?.kind === 'address';
  return isAddress && typeof value === 'number' ? nameAt(profile, table, value) : undefined;
}

/** The maker's number in front of a register's name: `P0683` of `P0683 speed reference`; all of another name. */
export const registerNumber = (name: string): string => /^\S*\d\S*(?= )/.exec(name)?.[0] ?? name;

function shortName(
  profile: Profile,
  words: FrameNameWords,
  table: EntityTable,
  reading: Reading,
  name: string,
): string {
  const { address, value } = reading.fields;
  if (name !== 'value') {
    return registerNumber(addressName(profile, table, reading, name) ?? '');
  }
  if (typeof address !== 'number' || typeof value !== 'number') return '';
  return namedValues(profile, table, address, [value]).map(words.inUnits).join(', ');
}

/** What 05 and 06 write. */
function singleValue(
  profile: Profile,
  words: FrameNameWords,
  table: EntityTable,
  { fields, derived }: Reading,
): string {
  const { address, value } = fields;
  const raw = typeof value === 'boolean' ? Number(derived['rawValue']) : value;
  if (typeof address !== 'number' || typeof raw !== 'number') return '';
  if (typeof value === 'number') return namedValues(profile, table, address, [raw]).map(words.named).join(' ');
  const loose = takesAnyOn(profile);
  const on = loose ? isOwnOn(profile, raw) : value;
  const said = namedValues(profile, table, address, [on ? 1 : 0]).map(words.named);
  return [...said, ...(loose ? [words.anyValueIsOn] : [])].join(' ');
}

function byteCount(profile: Profile, words: FrameNameWords, reading: Reading): string {
  const wanted = ownByteCount(profile, reading);
  const quantity = fieldValue(reading, 'quantity');
  return wanted === undefined ? '' : words.byteCountWanted(wanted, Number(quantity));
}
