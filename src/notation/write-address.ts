import { type Table, tableDigits } from '../modbus/index.ts';
import type { AddressConvention, AddressNotation } from './address-meanings.ts';
import { clearAddress } from './clear-address.ts';
import { formatHex } from './number.ts';

/** An address as it is written in one notation. */
export interface WrittenAddress {
  readonly notation: AddressNotation;
  readonly text: string;
}

/** Beyond it a number with the table's digit has six digits: 9999 counted as the number, or from 0. */
const MOST_OF_FIVE = 9999;

/** Outputs are `%QX`, as bits of bytes; registers that are read and written are memory words. */
function iecText(table: Exclude<Table, 'file-record'>, address: number): string {
  const bit = `${address >> 3}.${address & 7}`;
  switch (table) {
    case 'coil':
      return `%QX${bit}`;
    case 'discrete-input':
      return `%IX${bit}`;
    case 'input-register':
      return `%IW${address}`;
    case 'holding-register':
      return `%MW${address}`;
  }
}

/**
 * All the ways to write a zero-based address of a table, each with its name: `107`, `0x006B`, `108`, `40108`, `400108`,
 * `4x108`, `HR108`, `%MW107`, and `40107` for manuals that put the digit before addresses from 0. Five digits reach up to
 * number 9999. Records of extended memory are counted from 0, so that for them number and address are one (PI fn 20).
 */
export function writeAddress(table: Table, address: number): readonly WrittenAddress[] {
  const digit = tableDigits[table];
  const number = table === 'file-record' ? address : address + 1;
  const digits = (count: number, width: number) => digit + String(count).padStart(width, '0');
  const written: WrittenAddress[] = [
    { notation: 'decimal', text: String(address) },
    { notation: 'hex', text: formatHex(address, 4) },
  ];
  if (table !== 'file-record') written.push({ notation: 'number', text: String(number) });
  if (number <= MOST_OF_FIVE) written.push({ notation: 'five-digit', text: digits(number, 4) });
  written.push({ notation: 'six-digit', text: digits(number, 5) }, { notation: 'prefix', text: `${digit}x${number}` });
  if (table === 'file-record') return written;
  written.push(
    { notation: 'letters', text: clearAddress(table, address) },
    { notation: 'iec', text: iecText(table, address) },
    { notation: 'digit-from-zero', text: digits(address, address <= MOST_OF_FIVE ? 4 : 5) },
  );
  return written;
}

const PRINTS: Readonly<Record<AddressConvention, readonly AddressNotation[]>> = {
  protocol: ['decimal'],
  'one-based': ['number'],
  digits: ['five-digit', 'six-digit'],
  'digit-from-zero': ['digit-from-zero'],
};

/** How a manual of a convention prints an address: as one text, or as one of two. */
export function printedAddress(convention: AddressConvention, table: Table, address: number): readonly string[] {
  const printed = writeAddress(table, address).filter(({ notation }) => PRINTS[convention].includes(notation));
  // Records are counted from 0 in every manual.
  return printed.length > 0 ? printed.map(({ text }) => text) : [String(address)];
}
