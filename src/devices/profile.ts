import type { Order, SerialLine, Table, ValueType } from '../modbus/index.ts';
import type { Trait } from './traits.ts';

/** The tables whose elements have addresses of their own. */
export type EntityTable = Exclude<Table, 'file-record'>;
export const entityTables: readonly EntityTable[] = ['coil', 'discrete-input', 'input-register', 'holding-register'];

export type Access = (typeof accesses)[number];
export const accesses = ['r', 'w', 'rw'] as const;

/** How a manual prints addresses: as sent, counted from one, or with the table's digit in five or six digits. */
export type Convention = (typeof conventions)[number];
export const conventions = ['zero-based', 'one-based', 'five-digit', 'six-digit'] as const;

/** A name for a bit (of type `bits`) or for a value. */
export interface NamedNumber {
  readonly number: number;
  readonly name: string;
}

/** One line of a device's table. */
export interface Register {
  /** As the manual has it. `{800+2n}` in it numbers the values of a long line: 800, 802, …; `{0000h+1n}` in hexadecimal. */
  readonly name: string;
  readonly table: EntityTable;
  /** As sent, counted from 0. */
  readonly address: number;
  readonly type: ValueType;
  readonly order: Order;
  /** How many such values follow each other; of text, how many registers it has. */
  readonly count: number;
  /** The number in the registers is value × factor + offset. */
  readonly factor: number;
  readonly offset: number;
  readonly unit: string;
  /** Decimals a value is shown with; if absent, as many as it has. */
  readonly decimals?: number | undefined;
  readonly access: Access;
  readonly names: readonly NamedNumber[];
  readonly description: string;
}

/** How the serial line is set, and who is on it. */
export interface SerialSettings extends SerialLine {
  /** The unit identifier the device has when it is new. */
  readonly unit?: number | undefined;
}

/** What a manual says of a device, as data. */
export interface Profile {
  readonly id: string;
  readonly name: string;
  readonly source: string;
  readonly convention: Convention;
  readonly serial?: SerialSettings | undefined;
  readonly traits: readonly Trait[];
  readonly registers: readonly Register[];
  /** What in its source is wrong or odd. */
  readonly notes: readonly string[];
}

/** The default of a line: one unsigned register, not scaled. */
export const plainRegister = {
  type: 'u16',
  order: 'ABCD',
  count: 1,
  factor: 1,
  offset: 0,
  unit: '',
  access: 'rw',
  names: [],
  description: '',
} as const satisfies Partial<Register>;

export const isBitTable = (table: EntityTable): boolean => table === 'coil' || table === 'discrete-input';
export const isReadOnly = (table: EntityTable): boolean => table === 'discrete-input' || table === 'input-register';
