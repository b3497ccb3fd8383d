import type { Table } from '../modbus/index.ts';

/** First digit of an entity number, by table (PI ch. 2). File records are numbered within their file instead. */
const PREFIX: Readonly<Partial<Record<Table, string>>> = {
  coil: '0',
  'discrete-input': '1',
  'input-register': '3',
  'holding-register': '4',
};

/**
 * The number that manuals print for a zero-based address of a table: the table's digit and the address counted from one,
 * in five digits up to address 9998 and in six beyond (PI ch. 2). Coil 0 is 00001, holding register 107 is 40108.
 */
export function entityNumber(table: Table, address: number): string | undefined {
  const prefix = PREFIX[table];
  if (prefix === undefined) return undefined;
  const number = String(address + 1);
  return prefix + number.padStart(address < 9999 ? 4 : 5, '0');
}
