import { LAST_ADDRESS, type Table } from '../modbus/index.ts';
import { readNamedAddress, zeroBasedAddress } from './address.ts';
import { plainAddress } from './address-forms.ts';
import { readNumber } from './number.ts';
import type { PlcCode } from './plc-devices.ts';

/**
 * How an address is written: from 0 in decimal, or in hexadecimal or binary; the number counted from 1; that number with
 * the table's digit in front, in five or six digits; with a prefix (`4x108`, `4:108`); with letters (`HR108`); in the way
 * of IEC 61131 (`%MW107`); as some manuals print it, with the table's digit but counted from 0 (`40107`); and as the program of a
 * controller names it (`V2000`), whose address depends on the controller.
 */
export type AddressNotation =
  | 'decimal'
  | 'hex'
  | 'number'
  | 'five-digit'
  | 'six-digit'
  | 'prefix'
  | 'letters'
  | 'iec'
  | 'digit-from-zero'
  | 'plc';

/** What a text may say: a zero-based address, and its table where the text or the place it stands in names one. */
export interface AddressMeaning {
  readonly table: Table | undefined;
  readonly address: number;
  readonly notation: AddressNotation;
  /** The bit of the register that is meant, from 0. */
  readonly bit?: number;
  /** How many there are, if the text says it. */
  readonly quantity?: number;
  /** The text in these registers has its first character in the low byte of each. */
  readonly lowByteFirst?: true;
  /** The controllers in which it is so. */
  readonly plc?: PlcCode;
}

/** The notations that each convention takes a text for, the likeliest first. */
const TAKES = {
  protocol: ['hex', 'decimal', 'prefix', 'letters', 'iec', 'six-digit'],
  'one-based': ['number', 'hex', 'prefix', 'letters', 'iec', 'six-digit'],
  digits: ['five-digit', 'six-digit', 'number', 'prefix', 'letters', 'iec', 'hex'],
  'digit-from-zero': ['digit-from-zero', 'decimal', 'hex', 'prefix', 'letters', 'iec'],
} as const satisfies Readonly<Record<string, readonly AddressNotation[]>>;

/** What plain numbers mean in a manual: addresses from 0, numbers from 1, or the table's digit and either of the two. */
export type AddressConvention = keyof typeof TAKES;

/** Every convention, that of the frames themselves first. */
export const addressConventions = Object.keys(TAKES) as readonly AddressConvention[];

/** The tables by what stands for them: digit, letters, place and size of IEC 61131. */
const NAMES = [
  ['coil', '0 CO Q M QX MX'],
  ['discrete-input', '1 DI I IX'],
  ['input-register', '3 IR IW'],
  ['holding-register', '4 HR MW QW'],
  ['file-record', '6'],
] as const satisfies readonly (readonly [Table, string])[];

const TABLES: ReadonlyMap<string, Table> = new Map(
  NAMES.flatMap(([table, names]) => names.split(' ').map((name) => [name, table] as const)),
);

/**
 * The meanings of an address by itself, the likeliest under a convention first, but not those that depend on a controller. `table`
 * is that of the function it is typed for: plain numbers are of it, and only for coils leading zeros and `0x` may be the digit of
 * the coils.
 */
export function plainMeanings(text: string, convention: AddressConvention, table: Table | undefined): AddressMeaning[] {
  const typed = text.trim();
  const meanings: AddressMeaning[] = [];
  const add = (notation: AddressNotation, address: number, of = table) => {
    if (Number.isInteger(address) && address >= 0 && address <= LAST_ADDRESS)
      meanings.push({ table: of, address, notation });
  };
  const coils = table === undefined || table === 'coil';
  const value = readNumber(typed);
  if (value !== undefined) {
    const based = /[a-z#$]/i.test(typed);
    add(based ? 'hex' : 'decimal', value);
    // Records of extended memory are counted from 0 (PI fn 20).
    if (!based && table !== 'file-record') add('number', value - 1);
  }
  const [, digit = '', rest = ''] = /^([01346])(\d{4,5})$/.exec(typed) ?? [];
  const numbered = coils || digit !== '0' ? TABLES.get(digit) : undefined;
  if (numbered) {
    const notation = rest.length === 4 ? 'five-digit' : 'six-digit';
    add(notation, Number(rest) - (digit === '6' ? 0 : 1), numbered);
    if (digit !== '6') add('digit-from-zero', Number(rest), numbered);
  }
  const [, coil] = coils ? (/^0x(\d+)$/i.exec(typed) ?? []) : [];
  if (coil) add('prefix', Number(coil) - 1, 'coil');
  const named = readNamedAddress(typed);
  if (named && named.notation !== 'six-digit') add(named.notation, named.address, TABLES.get(named.name.toUpperCase()));
  const order: readonly AddressNotation[] = TAKES[convention];
  const rank = ({ notation }: AddressMeaning) => (order.includes(notation) ? order.indexOf(notation) : order.length);
  return meanings.sort((one, other) => rank(one) - rank(other));
}

/** The meaning that a text has under a convention, or `undefined` if it has none under it. A frame's fields have `protocol`. */
export function addressMeant(
  text: string,
  convention: AddressConvention = 'protocol',
  table?: Table,
): AddressMeaning | undefined {
  const [first] = plainMeanings(plainAddress(text), convention, table);
  const taken: readonly AddressNotation[] = TAKES[convention];
  if (first === undefined || !taken.includes(first.notation)) return undefined;
  // A number counted from 0 that is too large is not an address in a frame, though it may be a coil's number.
  return convention !== 'protocol' || first.address === zeroBasedAddress(text) ? first : undefined;
}
