import type { Trace } from '../../trace/index.ts';
import { type SeenFault, seenFault, seenFaults } from './seen-fault.ts';
import type { BinFault, Timeline, TimelineBin } from './tab-messages.ts';
import type { TraceList } from './trace-list.ts';

/** Columns that a timeline has at most: each gives two points, its shortest and its longest time. */
export const MOST_COLUMNS = 1000;

interface Bin {
  from: number;
  to: number;
  exchanges: number;
  minimum: number | undefined;
  maximum: number | undefined;
  row: number;
  faults: Map<SeenFault, { count: number; row: number }> | undefined;
}

/** Makes the timeline of a list, so many rows at a time. Each exchange counts once, also if the list has several of its frames. */
export class TimelineMaker {
  readonly #trace: Trace;
  readonly #list: TraceList;
  readonly #columns: number;
  readonly #bins: (Bin | undefined)[];
  readonly #seen: Uint8Array;
  #from = Number.POSITIVE_INFINITY;
  #to = Number.NEGATIVE_INFINITY;
  #untimed = 0;
  #ranged = 0;
  #next = 0;

  constructor(trace: Trace, list: TraceList, columns: number) {
    this.#trace = trace;
    this.#list = list;
    this.#columns = Math.max(1, Math.min(MOST_COLUMNS, Math.floor(columns)));
    this.#bins = Array.from({ length: this.#columns });
    this.#seen = new Uint8Array(trace.exchangeCount);
  }

  /** Looks at so many more rows; answers whether all have been looked at. */
  go(most: number): boolean {
    const { count } = this.#list;
    if (this.#ranged < count) {
      const end = Math.min(count, this.#ranged + most);
      for (; this.#ranged < end; this.#ranged++) this.#range(this.#ranged);
      return false;
    }
    const end = Math.min(count, this.#next + most);
    for (; this.#next < end; this.#next++) this.#count(this.#next);
    return this.#next >= count;
  }

  #exchangeAt(row: number): number {
    const index = this.#list.at(row) as number;
    return this.#list.by === 'frame' ? this.#trace.exchangeOf(index) : index;
  }

  #range(row: number): void {
    const time = this.#trace.began(this.#exchangeAt(row));
    if (time === undefined) return;
    if (time < this.#from) this.#from = time;
    if (time > this.#to) this.#to = time;
  }

  #count(row: number): void {
    const exchange = this.#exchangeAt(row);
    if (this.#seen[exchange]) return;
    this.#seen[exchange] = 1;
    const time = this.#trace.began(exchange);
    const isPiece = this.#trace.isPiece(exchange);
    if (time === undefined) {
      if (!isPiece) this.#untimed++;
      return;
    }
    const bin = this.#bin(time, row);
    if (!isPiece) bin.exchanges++;
    if (time < bin.from) bin.from = time;
    if (time > bin.to) bin.to = time;
    const after = this.#trace.after(exchange);
    if (after !== undefined) {
      if (bin.minimum === undefined || after < bin.minimum) bin.minimum = after;
      if (bin.maximum === undefined || after > bin.maximum) {
        bin.maximum = after;
        bin.row = row;
      }
    }
    for (const fault of this.#trace.faults(exchange)) {
      const { records } = fault;
      const kind = seenFault(fault);
      bin.faults ??= new Map();
      const found = bin.faults.get(kind);
      if (found) found.count++;
      else bin.faults.set(kind, { count: 1, row: this.#list.rowOf(records.at(-1) ?? 0) ?? row });
    }
  }

  #bin(time: number, row: number): Bin {
    const width = this.#to - this.#from || 1;
    const at = Math.min(this.#columns - 1, Math.floor(((time - this.#from) / width) * this.#columns));
    let bin = this.#bins[at];
    if (bin === undefined) {
      bin = { from: time, to: time, exchanges: 0, minimum: undefined, maximum: undefined, row, faults: undefined };
      this.#bins[at] = bin;
    }
    return bin;
  }

  get timeline(): Timeline {
    const known = this.#from <= this.#to;
    return {
      from: known ? this.#from : 0,
      to: known ? this.#to : 0,
      origin: this.#trace.span?.first ?? 0,
      bins: this.#bins.flatMap((bin): TimelineBin[] =>
        bin === undefined ? [] : [{ ...bin, faults: faultsOf(bin.faults) }],
      ),
      untimed: this.#untimed,
    };
  }
}

const faultsOf = (faults: Bin['faults']): readonly BinFault[] =>
  seenFaults.flatMap((kind) => {
    const found = faults?.get(kind);
    return found ? [{ kind, ...found }] : [];
  });

/** The bin that is nearest to a time; `undefined` if there is no bin. */
export function binNear({ bins }: Pick<Timeline, 'bins'>, time: number): number | undefined {
  let best: number | undefined;
  let least = Number.POSITIVE_INFINITY;
  for (const [at, { from, to }] of bins.entries()) {
    const away = time < from ? from - time : time > to ? time - to : 0;
    if (away < least) [best, least] = [at, away];
  }
  return best;
}
