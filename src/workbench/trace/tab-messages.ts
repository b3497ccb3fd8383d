import type { KnownTable, KnownValue, Tallied, Tally } from '../../trace/index.ts';
import type { FilterKnown } from './filter-completions.ts';
import type { SeenFault } from './seen-fault.ts';
import type { TallySort } from './tallies.ts';

/** What a tab beside the list asks of what holds the trace. */
export type TabTask =
  /** The exchanges of the list over time, in at most so many columns. */
  | { readonly kind: 'timeline'; readonly columns: number }
  /** Those that come first in an order, at most `MOST_TALLIES`; without `sort`, in their own. */
  | { readonly kind: 'statistics'; readonly by: Tallied; readonly sort?: TallySort | undefined }
  | { readonly kind: 'values' }
  /** What a filter can be completed with. */
  | { readonly kind: 'occurring' };

/** Faults of one kind in a column of a timeline, and the row of the first of them. */
export interface BinFault {
  readonly kind: SeenFault;
  readonly count: number;
  readonly row: number;
}

/** A column of a timeline that has exchanges. Times are microseconds. */
export interface TimelineBin {
  /** When the first and the last of its exchanges began. */
  readonly from: number;
  readonly to: number;
  readonly exchanges: number;
  /** The shortest and the longest time to a reply; `undefined` if no reply of its exchanges has a time. */
  readonly minimum: number | undefined;
  readonly maximum: number | undefined;
  /** The row of the exchange with the longest time; of the first one, if none has a time. */
  readonly row: number;
  /** In the order of the kinds. */
  readonly faults: readonly BinFault[];
}

/** The exchanges of a list over time. */
export interface Timeline {
  /** When the first and the last of its exchanges began, in microseconds; both 0 if none has a time. */
  readonly from: number;
  readonly to: number;
  /** The time of the first record of the trace, from which a filter counts. */
  readonly origin: number;
  /** Only those with exchanges, in the order of time. */
  readonly bins: readonly TimelineBin[];
  /** Exchanges whose records have no time. */
  readonly untimed: number;
}

/** The registers and bits that are known, in columns: by unit, table and address. */
export interface KnownColumns {
  readonly count: number;
  /** The time of the first record of the trace, in microseconds. */
  readonly origin: number;
  readonly unit: Uint8Array;
  /** By their places in `knownTables`. */
  readonly table: Uint8Array;
  readonly address: Uint16Array;
  readonly value: Uint16Array;
  /** Microseconds; NaN if the records have no times. */
  readonly time: Float64Array;
  readonly record: Int32Array;
  readonly reads: Uint32Array;
  readonly writes: Uint32Array;
  readonly changes: Uint32Array;
}

export const knownTables: readonly KnownTable[] = ['coil', 'discrete-input', 'input-register', 'holding-register'];

/** What a tab is answered. */
export type TabAnswer =
  /** `list` is the number of the list. */
  | { readonly kind: 'timeline'; readonly list: number; readonly timeline: Timeline }
  /** `count` is how many there are in all. */
  | { readonly kind: 'tallies'; readonly by: Tallied; readonly tallies: readonly Tally[]; readonly count: number }
  | { readonly kind: 'values'; readonly known: KnownColumns }
  | { readonly kind: 'occurring'; readonly known: FilterKnown };

/** The columns of what is known. */
export function knownColumns(values: readonly KnownValue[], origin = 0): KnownColumns {
  const { length: count } = values;
  const of = <T extends { [at: number]: number }>(column: T, value: (one: KnownValue) => number): T => {
    values.forEach((one, at) => {
      column[at] = value(one);
    });
    return column;
  };
  return {
    count,
    origin,
    unit: of(new Uint8Array(count), ({ unit }) => unit),
    table: of(new Uint8Array(count), ({ table }) => knownTables.indexOf(table)),
    address: of(new Uint16Array(count), ({ address }) => address),
    value: of(new Uint16Array(count), ({ value }) => value),
    time: of(new Float64Array(count), ({ time }) => time ?? Number.NaN),
    record: of(new Int32Array(count), ({ record }) => record),
    reads: of(new Uint32Array(count), ({ reads }) => reads),
    writes: of(new Uint32Array(count), ({ writes }) => writes),
    changes: of(new Uint32Array(count), ({ changes }) => changes),
  };
}

/** One of them. Throws a `RangeError` for a place that is not there. */
export function knownAt(known: KnownColumns, at: number): KnownValue {
  const { count, unit, table, address, value, time, record, reads, writes, changes } = known;
  if (!Number.isInteger(at) || at < 0 || at >= count) throw new RangeError(`at: ${at} is not below ${count}`);
  const number = (column: { readonly [at: number]: number }) => column[at] as number;
  const when = number(time);
  return {
    unit: number(unit),
    table: knownTables[number(table)] as KnownTable,
    address: number(address),
    value: number(value),
    time: Number.isNaN(when) ? undefined : when,
    record: number(record),
    reads: number(reads),
    writes: number(writes),
    changes: number(changes),
  };
}
