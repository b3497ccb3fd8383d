import { type EntityTable, isBitTable, type Profile, placesNamed, type Register } from '../../devices/index.ts';
import { LAST_ADDRESS, type SerialLine, type Table } from '../../modbus/index.ts';
import {
  type AddressConvention,
  type AddressMeaning,
  addressMeant,
  clearAddress,
  clearProtocolAddress,
  type PlcCode,
  plainAddress,
  plcMeanings,
  readAddress,
  readNumber,
  type UnitScale,
  wholeNumber,
  zeroBasedAddress,
} from '../../notation/index.ts';
import { type AddressContext, addressInFrame, addressRange } from '../frame/address-typed.ts';
import { registerNamesOf } from '../frame/device-names.ts';
import type { Draft } from '../frame/draft.ts';

/** What a text means beside the frame that is there, and with the devices that are known. */
export interface InputContext {
  readonly draft: Draft;
  readonly convention: AddressConvention;
  /** The device that is chosen. */
  readonly device: Profile | undefined;
  /** All devices; the names of the chosen one come first. */
  readonly devices: readonly Profile[];
  /** A person's own scale. */
  readonly own: UnitScale | undefined;
  /** The line that is set. */
  readonly line: SerialLine;
}

/** An element that a text names by itself: with its table, by the number that manuals print, or by the name that a device has. */
export interface InputPlace {
  /** As typed. */
  readonly typed: string;
  readonly table: EntityTable;
  /** Counted from 0. */
  readonly address: number;
  /** The bit of the register that is meant, from 0. */
  readonly bit?: number;
  /** How many registers it has, where its name says so. */
  readonly size?: number;
  /** It is a name in the program of a controller, and this its place if the controller is of this family. */
  readonly plc?: PlcCode;
  readonly named?: { readonly profile: Profile; readonly register: Register; readonly name: string };
}

/** The number of a coil as manuals print it. A field takes it for an address with zeros in front. */
const COIL = /^0\d{4}\b/;

/** What gives a place's address its meaning in a field. */
export const addressingOf = ({ typed, named }: InputPlace, { convention, device }: InputContext): AddressContext => {
  const profile = named?.profile ?? device;
  const isNumber = named === undefined && convention === 'protocol' && COIL.test(typed);
  return { convention: isNumber ? 'digits' : convention, names: profile && registerNamesOf(profile) };
};

/**
 * Every place that a text names: one that the chosen device has, else what the text says by itself, else those of other devices.
 * Numbers are names of the chosen device only.
 */
export function placesOf(text: string, context: InputContext): readonly InputPlace[] {
  const typed = text.trim();
  const bare = typed.split(/\s+/).every((word) => BARE.test(word));
  if (bare && !PRINTED.test(typed)) return [];
  const { device, devices } = context;
  const chosen = device ? namedBy(device, typed) : [];
  if (chosen.length > 0) return chosen;
  const own = placeOfText(typed, context);
  if (own) return [own, ...controllerPlaces(typed)];
  if (bare) return [];
  const named = devices.flatMap((profile) => namedBy(profile, typed));
  if (named.length > 0) return named;
  const [, base = '', bit] = NAME_AND_BIT.exec(typed) ?? [];
  const withBit = base === '' ? [] : bitOf(placesOf(base, context), Number(bit));
  return withBit.length > 0 ? withBit : controllerPlaces(typed);
}

/** A bit of each place that is a register. */
export const bitOf = (places: readonly InputPlace[], bit: number): readonly InputPlace[] =>
  places.flatMap((place) => (isBitTable(place.table) ? [] : [{ ...place, bit }]));

/** A name with a bit of its register: `P0683.5`. */
const NAME_AND_BIT = /^([a-z]\w*\d)(?:\.|:X?|\s+bit\s+|\[)(\d|1[0-5])\]?$/i;

/** The places that a name in the program of a controller may have: `D100`, `DB1.DBW4`. They are written so that nothing else is read. */
export const controllerPlaces = (typed: string): readonly InputPlace[] =>
  plcMeanings(typed).flatMap(({ plc, table, address }) =>
    isEntity(table)
      ? [{ typed: clearAddress(table, address), table, address, plc, ...(DOUBLE.test(typed) && { size: 2 }) }]
      : [],
  );

const namedBy = (profile: Profile, typed: string): readonly InputPlace[] =>
  placesNamed(profile, typed).map(({ register, name, table, address }) => ({
    typed,
    table,
    address,
    named: { profile, register, name },
  }));

/** Double words of Siemens. */
const DOUBLE = /^(?:DB\d+\.DB|%?M)D\d+$/i;

/** A number in decimal or hexadecimal. */
const BARE = /^(?:0x)?[\da-f]+h?$/i;
/** A number says its table only in five or six digits; six with a 0 or 1 in front are rather bytes. */
const PRINTED = /^(?:[0134]\d{4}|[34]\d{5})$/;

function placeOfText(typed: string, context: InputContext): InputPlace | undefined {
  const { convention } = context;
  // A slash stands between unit, address and quantity here.
  if (typed.includes('/')) return undefined;
  const digits = convention === 'digit-from-zero' ? convention : 'digits';
  const meanings = readAddress(typed, PRINTED.test(typed) ? digits : 'protocol');
  // H1000 is a number in hexadecimal before it is anything else, as the field reads it.
  const meaning = meanings[0]?.notation === 'hex' ? undefined : meanings.find(isNamed);
  if (meaning === undefined) return undefined;
  const { table, address, bit } = meaning;
  const beside = bit === undefined || isBitTable(table) ? {} : { bit };
  const place: InputPlace = { typed, table, address, ...beside };
  // The field of an address reads less than the input: what it does not know is written clearly.
  const inField = zeroBasedAddress(addressInFrame(typed, table, addressingOf(place, context)));
  return inField === address ? place : { ...place, typed: clearAddress(table, address) };
}

const isNamed = (meaning: AddressMeaning): meaning is AddressMeaning & { readonly table: EntityTable } =>
  meaning.table !== undefined && meaning.notation !== 'plc' && isEntity(meaning.table);

const isEntity = (table: Table): table is EntityTable => table !== 'file-record';

/** An address that is said in two bases, `4096 (0x1000)`, in hexadecimal; any other text stays as it is. */
export function inOneBase(text: string): string {
  const plain = text.includes('(') ? plainAddress(text) : text;
  const number = plain === text ? undefined : readNumber(plain);
  return number === undefined ? text : clearProtocolAddress(undefined, number);
}

/** What stands between the ends of a range. */
const BETWEEN = /\s*(?:\.{2,3}|…|[-–—~～〜]|\bto\b|\bbis\b|至)\s*/i;

/** The place at which a range begins: `401000–401003`, `P0681–P0683`. */
export function rangePlace(text: string, context: InputContext): InputPlace | undefined {
  const [first = ''] = text.split(BETWEEN);
  const [place] = placesOf(first, context);
  if (place === undefined || addressRange(text, place.table, addressingOf(place, context)) === undefined)
    return undefined;
  return { ...place, typed: text.trim() };
}

/** How a plain number is counted: from 0, as an address; from 1, as the number of a register or coil. */
export type Counted = 'address' | 'number';

/**
 * What a plain number, or a range of them, may be in a table: the address, and the number that a manual counts from 1; `first`
 * says which is likelier. Where the manual's way is chosen there is one.
 */
export function numberPlaces(
  text: string,
  table: EntityTable,
  context: InputContext,
  first: Counted,
): readonly InputPlace[] {
  const ends = text.trim().split(BETWEEN);
  const numbers = ends.flatMap((end) => (DIGITS.test(end) ? [wholeNumber(0, LAST_ADDRESS)(end)] : []));
  const [from, to] = numbers;
  if (from === undefined || numbers.length !== ends.length || ends.length > 2) return [];
  if (ends.length === 2 && (to === undefined || to < from)) return [];
  if (context.convention !== 'protocol') {
    const meant = addressMeant(ends[0] ?? '', context.convention, table);
    return meant ? [{ typed: text.trim(), table, address: meant.address }] : [];
  }
  const written = (write: (end: string, number: number) => string) =>
    ends.map((end, index) => write(end, numbers[index] ?? 0)).join('–');
  // Five digits would be read as a manual's number.
  const plain = (end: string, address: number) => (address < 10_000 ? end : clearProtocolAddress(table, address));
  const address: InputPlace = { typed: written(plain), table, address: from };
  if (from === 0 || ends.some((end) => !/^\d+$/.test(end))) return [address];
  const number: InputPlace = {
    typed: written((_, end) => clearAddress(table, end - 1)),
    table,
    address: from - 1,
  };
  return first === 'address' ? [address, number] : [number, address];
}

/** A plain number in decimal, or in hexadecimal that says so. */
const DIGITS = /^(?:\d{1,5}|0x[\da-f]{1,4}|[\da-f]{1,4}h)$/i;
