import type { Table } from '../../modbus/index.ts';
import { entityNumber } from '../../notation/index.ts';
import { en as fields } from './fields.ts';
import { word } from './numbers.ts';

/** An address from 0, in both ways of writing it: `107 (0x006B)`. */
export const addressIn = (address: number): string => `${address} (${word(address)})`;

/** An element of a table by its address and the number that manuals print: `holding register 107 (40108)`. */
export function elementIn(table: Table | undefined, address: number): string {
  return table ? `${fields.tables[table].one} ${address} (${entityNumber(table, address)})` : `register ${address}`;
}

/** An address in a sentence of its own: the table, the address in a frame, and the number that manuals print. */
export function addressSentence(table: Table | undefined, address: number): string {
  if (table === undefined) return `Address ${addressIn(address)}.`;
  const where = table === 'file-record' ? 'as extended memory' : 'in manuals that count from 1';
  return `${capital(fields.tables[table].one)} ${addressIn(address)} counted from 0: ${entityNumber(table, address)} ${where}.`;
}

/** The last of several from an address on. */
export const lastAddress = (address: number, quantity: number): string => addressIn(address + quantity - 1);

/** A text as the beginning of a sentence. */
export const capital = (text: string): string => text.charAt(0).toUpperCase() + text.slice(1);
