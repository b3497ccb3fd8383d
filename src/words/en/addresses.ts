import type { Table } from '../../modbus/index.ts';
import { numbered } from './address.ts';
import { word } from './numbers.ts';

/** What is said where an address is typed. */
export const addresses = {
  ways: 'All ways to write it',
  waysOf: (label: string) => `All ways to write it: ${label}`,
  notHere: (typed: string) => `It was typed as “${typed}”, a name of a device that is not chosen here.`,
  /** What an address is, below its field. */
  is: (table: Table, address: number, sixDigits?: boolean) =>
    `${address} = ${word(address)} = ${numbered(table, address, sixDigits)}`,
  twoReadings: (typed: string) => `${typed} may be either:`,
  asNumber: (table: Table, address: number) => `${numbered(table, address)} = address ${address}`,
  asAddress: (address: number) => `address ${address}`,
};

export type AddressWords = typeof addresses;
