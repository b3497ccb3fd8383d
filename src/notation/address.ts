import { LAST_ADDRESS, type Table, tableDigits } from '../modbus/index.ts';
import { plainAddress } from './address-forms.ts';
import { readNumber } from './number.ts';

/**
 * The number that manuals print for a zero-based address of a table: the table's digit and the address counted from one,
 * in five digits up to address 9998 and in six beyond (PI ch. 2), or in six for all. Coil 0 is 00001, holding register 107 is 40108. Records
 * of extended memory are counted from 0 and have six digits: record 107 of a file is 600107 (PI fn 20).
 */
export const entityNumber = (table: Table, address: number, inSixDigits = false): string =>
  inSixDigits || table === 'file-record' || address >= END_OF_FIVE
    ? sixDigitNumber(table, address)
    : digits(table, address + 1, 4);

/** The number of an address in six digits, also where five would do. */
export const sixDigitNumber = (table: Table, address: number): string =>
  digits(table, table === 'file-record' ? address : address + 1, 5);

/** Five digits name addresses below it. */
const END_OF_FIVE = 9999;

const digits = (table: Table, number: number, width: number) =>
  tableDigits[table] + String(number).padStart(width, '0');

/** Not `0x108` and `000108`: these are numbers of their own. */
const NAMED = /^(?:(0(?=:)|[1346])[x:]|([1346])(?=\d{5}$)|(CO|DI|IR|HR)[ :]?|%([IQM][WX]?))(\d+)(?:\.([0-7]))?$/i;

/** An address written with what names its table: a digit, two letters, or the place and size of IEC 61131. */
export interface NamedAddress {
  readonly name: string;
  readonly notation: 'prefix' | 'six-digit' | 'letters' | 'iec';
  /** Counted from 0; it may be beyond the end. */
  readonly address: number;
}

/** Reads `4x108`, `4:108`, `400108`, `HR108`, `%MW107` and `%QX13.3`, the fourth bit of byte 13; all but the last two count from 1. */
export function readNamedAddress(text: string): NamedAddress | undefined {
  const [, prefix, six, letters, iec, digits, bit] = NAMED.exec(text.trim()) ?? [];
  const name = prefix ?? six ?? letters ?? iec;
  if (name === undefined || (bit && !/^[IQM]X?$/i.test(iec ?? ''))) return undefined;
  const notation = prefix ? 'prefix' : six ? 'six-digit' : letters ? 'letters' : 'iec';
  // Records of extended memory are counted from 0 too (PI fn 20).
  const address = bit ? 8 * Number(digits) + Number(bit) : Number(digits) - (iec || name === '6' ? 0 : 1);
  return { name, notation, address };
}

const fits = (address: number | undefined): address is number =>
  Number.isInteger(address) && (address as number) >= 0 && (address as number) <= LAST_ADDRESS;

/**
 * The zero-based address that a text says by itself: plain numbers count from 0, other texts are read
 * if they name their table. Of `40001.5`, `H1000` and `0x1000 (4096)` the address alone is read. `undefined` for any other text. A number that is not an address is returned as it is.
 */
export function zeroBasedAddress(text: string): number | undefined {
  const value = readNumber(text);
  if (fits(value)) return value;
  const plain = plainAddress(text);
  const named = readNamedAddress(plain)?.address;
  const inside = plain === text ? value : readNumber(plain);
  return fits(named) ? named : fits(inside) ? inside : value;
}
