import type { Table } from '../modbus/index.ts';
import { formatHex } from './number.ts';

// The page has this from the start, and all other ways to write an address when they are asked for.

const LETTERS = { coil: 'CO', 'discrete-input': 'DI', 'input-register': 'IR', 'holding-register': 'HR' } as const;

/** The way to write an address that no convention reads otherwise: `HR108`, and `6x107` for records. */
export const clearAddress = (table: Table, address: number): string =>
  table === 'file-record' ? `6x${address}` : `${LETTERS[table]}${address + 1}`;

/** An address from 0 that is not taken for a number: hexadecimal, for coils without the `0x` that is also their prefix. */
export const clearProtocolAddress = (table: Table | undefined, address: number): string =>
  table === 'coil' ? `16#${formatHex(address, 4).slice(2)}` : formatHex(address, 4);
