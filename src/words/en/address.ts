import type { Table } from '../../modbus/index.ts';
import { entityNumber } from '../../notation/index.ts';
import { en as fields } from './fields.ts';
import { word } from './numbers.ts';

/** An address from 0, in both ways of writing it: `107 (0x006B)`. */
export const addressIn = (address: number): string => `${address} (${word(address)})`;

/** An element by the number that manuals print: `register 40108`, `coil 00020`. */
export const numbered = (table: Table, address: number, sixDigits?: boolean): string =>
  `${table === 'holding-register' ? 'register' : fields.tables[table].one} ${entityNumber(table, address, sixDigits)}`;

/** An element of a table by the number that manuals print, and its address: `register 40108 (address 107)`. */
export const elementIn = (table: Table | undefined, address: number, sixDigits?: boolean): string =>
  table ? `${numbered(table, address, sixDigits)} (address ${address})` : `register ${address}`;

/** An address in a sentence of its own, and the number that manuals print for it: `Address 107 (0x006B) = register 40108.` */
export function addressSentence(table: Table | undefined, address: number, sixDigits?: boolean): string {
  const number = table === undefined ? '' : ` = ${numbered(table, address, sixDigits)}`;
  return `Address ${addressIn(address)}${number}${table === 'file-record' ? ' as extended memory' : ''}.`;
}

/** The last of several from an address on. */
export const lastAddress = (address: number, quantity: number): string => addressIn(address + quantity - 1);

/** A text as the beginning of a sentence. */
export const capital = (text: string): string => text.charAt(0).toUpperCase() + text.slice(1);
