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

/** A name for a bit (of types of bits) or for a value. */
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
  /** The value is the number in the registers × factor + offset; then it has the unit. */
  readonly factor: number;
  readonly offset: number;
  /** Both as decimals or quotients (`1000/123457`), where a number does not hold them exactly. */
  readonly exact?: { readonly factor: string; readonly offset: string } | undefined;
  /** The register of the same table, an i16, that holds a power of ten by which the value is multiplied too (SunSpec). */
  readonly scaleRegister?: { readonly address: number } | undefined;
  /** The number that says “no value here”, as text: `0x8000` (its bits), `65535`, `NaN`. */
  readonly notImplemented?: string | undefined;
  /** The bits of the number that are its value, moved down to bit 0: 0xFF00 for the high byte. Up to 2^53 − 1. */
  readonly mask?: number | undefined;
  readonly unit: string;
  /** Decimals a value is shown with; if absent, as many as it has. */
  readonly decimals?: number | undefined;
  readonly access: Access;
  readonly names: readonly NamedNumber[];
  readonly description: string;
  /** Under which heading its table has it. */
  readonly group?: string | undefined;
  /** The models that have it; all of them if absent. */
  readonly models?: readonly string[] | undefined;
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
  /** The unit identifier that it has, where its source does not say the line. */
  readonly unit?: number | undefined;
  readonly traits: readonly Trait[];
  readonly registers: readonly Register[];
  /** What in its source is wrong or odd. */
  readonly notes: readonly string[];
  /** What a person answered when its map was imported, by the code of the question. */
  readonly answers?: Readonly<Record<string, string>> | undefined;
}

/** The unit identifier under which a device is asked; `undefined` if its profile does not say it. */
export const deviceUnit = ({ serial, unit }: Pick<Profile, 'serial' | 'unit'>): number | undefined =>
  serial?.unit ?? unit;

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
