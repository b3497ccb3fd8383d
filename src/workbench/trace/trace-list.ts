import { type Column, countsColumn, indexColumn, type Trace } from '../../trace/index.ts';
import { type DescribeOptions, Describer } from './describe.ts';
import type { ReadFilter } from './filter.ts';
import type { RowUnit, TraceMark } from './messages.ts';
import { traceSeverity } from './seen-fault.ts';

/** Rows before the last that are looked at again at most when a trace has grown, however old what has changed is. */
const MOST_AGAIN = 4096;
const MOST_MARKS = 2000;
/** How many rows are described in the time in which one is decoded. */
const DECODED = 20;
const SEVERITIES: readonly TraceMark['severity'][] = ['error', 'warning'];

/** The frames or exchanges of a trace that a filter keeps, and which of them have faults. It is gone on with when the trace has grown. */
export class TraceList {
  readonly by: RowUnit;
  readonly #trace: Trace;
  readonly #filter: ReadFilter;
  readonly #describer: Describer;
  /** The frames or exchanges kept, and of the rows those with faults, each with how grave they are. */
  #kept: Column = indexColumn();
  #faulty: Column = indexColumn();
  #severity: Column = countsColumn();
  /** The rows of pieces in no frame. */
  #pieces: Column = indexColumn();
  #next = 0;
  #changed = 0;

  constructor(trace: Trace, filter: ReadFilter, by: RowUnit, options: DescribeOptions = {}) {
    this.#trace = trace;
    this.#filter = filter;
    this.by = by;
    this.#describer = new Describer(trace, by, options);
  }

  /** How many rows there are so far. */
  get count(): number {
    return this.#kept.length;
  }

  /** How many of them are pieces in no frame. */
  get pieces(): number {
    return this.#pieces.length;
  }

  get done(): boolean {
    return this.#next >= this.#size;
  }

  /** Which part has been looked at, from 0 to 1. */
  get looked(): number {
    return this.#size === 0 ? 1 : this.#next / this.#size;
  }

  get #size(): number {
    return this.by === 'frame' ? this.#trace.size : this.#trace.exchangeCount;
  }

  /** The frame or exchange of a row; `undefined` if there is no such row. */
  at(row: number): number | undefined {
    return row >= 0 && row < this.count ? this.#kept.at(row) : undefined;
  }

  /** The row of a record, or of its exchange; `undefined` if the filter leaves it out. */
  rowOf(record: number): number | undefined {
    const wanted = this.by === 'frame' ? record : this.#trace.exchangeOf(record);
    const row = firstAtLeast(this.#kept, wanted);
    return this.at(row) === wanted ? row : undefined;
  }

  /** The records of all rows, in their order. */
  records(): Int32Array {
    const rows = Int32Array.from({ length: this.count }, (_, row) => this.#kept.at(row));
    if (this.by === 'frame') return rows;
    const found: number[] = [];
    for (const exchange of rows) {
      const [{ request, replies } = { request: undefined, replies: [] }] = this.#trace.exchanges(
        exchange,
        exchange + 1,
      );
      if (request !== undefined) found.push(request);
      for (const reply of replies) found.push(reply);
    }
    return Int32Array.from(found).sort();
  }

  /** Looks at so many more of the trace, at fewer if each has to be decoded. */
  go(most: number): void {
    const step = this.#filter.decodes ? Math.ceil(most / DECODED) : most;
    const end = Math.min(this.#size, this.#next + step);
    for (; this.#next < end; this.#next++) {
      const described = this.#describer.at(this.#next);
      if (!this.#filter.isAll && !this.#filter.test(described)) continue;
      const { faults } = described;
      if (!described.isFrame) this.#pieces.push(this.#kept.length);
      if (faults.length > 0) {
        this.#faulty.push(this.#kept.length);
        this.#severity.push(faults.some((kind) => traceSeverity(kind) === 'error') ? 0 : 1);
      }
      this.#kept.push(this.#next);
    }
  }

  /** The trace has grown: rows from the first on that has become another are looked at again. */
  again(): void {
    const changed = this.#trace.takeChanged();
    const first = this.by === 'exchange' ? changed : this.#firstRecord(changed);
    this.#changed = Math.min(this.#changed, firstAtLeast(this.#kept, first));
    this.#next = Math.max(0, this.#next - MOST_AGAIN, Math.min(this.#next, first));
    this.#kept.cut(firstAtLeast(this.#kept, this.#next));
    this.#faulty.cut(firstAtLeast(this.#faulty, this.#kept.length));
    this.#severity.cut(this.#faulty.length);
    this.#pieces.cut(firstAtLeast(this.#pieces, this.#kept.length));
  }

  /** The first row that may have become another one since this was asked before; `count` if none has. */
  takeChanged(): number {
    const changed = this.#changed;
    this.#changed = this.count;
    return changed;
  }

  #firstRecord(exchange: number): number {
    if (exchange === this.#trace.exchangeCount) return this.#trace.size;
    return this.#trace.requestOf(exchange) ?? this.#trace.replyOf(exchange) ?? 0;
  }

  /** The next row with a fault behind a row, or the one before it; `undefined` if there is none. */
  fault(from: number, by: 1 | -1): number | undefined {
    const at = by === 1 ? firstAtLeast(this.#faulty, from + 1) : firstAtLeast(this.#faulty, from) - 1;
    return at >= 0 && at < this.#faulty.length ? this.#faulty.at(at) : undefined;
  }

  /** Where the faults are: one for all that would stand at the same place of a strip. */
  get marks(): readonly TraceMark[] {
    const marks: { row: number; severity: TraceMark['severity'] }[] = [];
    const { length } = this.#faulty;
    const each = Math.max(1, this.count / MOST_MARKS);
    let place = -1;
    for (let at = 0; at < length; at++) {
      const row = this.#faulty.at(at);
      const severity = SEVERITIES[this.#severity.at(at)] ?? 'error';
      const last = marks.at(-1);
      if (last && Math.floor(row / each) === place) {
        if (severity === 'error') last.severity = severity;
        continue;
      }
      place = Math.floor(row / each);
      marks.push({ row, severity });
    }
    return marks;
  }
}

/** The first place of a column in ascending order whose value is at least this. */
function firstAtLeast(column: Column, value: number): number {
  let [low, high] = [0, column.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (column.at(middle) < value) low = middle + 1;
    else high = middle;
  }
  return low;
}
