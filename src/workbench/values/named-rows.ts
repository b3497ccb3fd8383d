import { isBitTable, type NamedValue, namedValues, type Profile } from '../../devices/index.ts';
import { fieldByName, firstAddress, partsOf, type Reading, type Span } from '../../modbus/index.ts';

/** A value of the device in a frame, with its bytes. */
export interface NamedRow {
  readonly value: NamedValue;
  readonly from: number;
  readonly to: number;
}

/** The values that a device has names for among the registers and bits of a frame, in the order of its bytes. */
export function namedRows(profile: Profile, reading: Reading, bytes: Uint8Array): NamedRow[] {
  const table = reading.description?.table;
  if (table === undefined || table === 'file-record') return [];
  return reading.spans.flatMap((span) => {
    const list = listOf(reading, bytes, span);
    return list === undefined
      ? []
      : namedValues(profile, table, list.first, list.items).map((value) => ({
          value,
          ...list.place(value.at, value.at + value.size),
        }));
  });
}

interface List {
  readonly first: number;
  readonly items: readonly number[];
  /** The bytes of the items `[from, to)`; of items behind the last, those that there are. */
  readonly place: (from: number, to: number) => { readonly from: number; readonly to: number };
}

/** What a field holds of the device: a list, or the single value beside an address. */
function listOf(reading: Reading, bytes: Uint8Array, span: Span): List | undefined {
  const value: unknown = reading.fields[span.name];
  const { address } = reading.fields;
  if (span.name === 'value' && typeof address === 'number') {
    const item = typeof value === 'boolean' ? Number(value) : value;
    return typeof item === 'number' ? { first: address, items: [item], place: () => span } : undefined;
  }
  const first = firstAddress(reading, span.name);
  const kind = fieldByName(reading, span.name)?.kind;
  if (first === undefined || !Array.isArray(value) || (kind !== 'registers' && kind !== 'bits')) return undefined;
  const parts = partsOf(reading, bytes, span);
  const each = kind === 'bits' ? 8 : 1;
  const partAt = (item: number) => parts[Math.min(Math.floor(item / each), parts.length - 1)]?.span ?? span;
  return {
    first,
    items: value as readonly number[],
    place: (from, to) => ({ from: partAt(from).from, to: partAt(to - 1).to }),
  };
}

/** The number that is sent for a value; `undefined` if the value is that number, or not a number. */
export function rawBeside({ raw, scaled, register }: NamedValue): number | bigint | undefined {
  if (isBitTable(register.table) || typeof raw === 'string' || raw === undefined) return undefined;
  return scaled === undefined || scaled === raw ? undefined : raw;
}
