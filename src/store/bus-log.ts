import { batch, signal } from '@preact/signals-core';
import type { LogLine } from '../bus/index.ts';
import type { TraceInput } from '../trace/index.ts';
import { recordsOfLines } from '../workbench/index.ts';
import type { TraceView } from './trace-view.ts';

/** Records are kept up to this number; then the oldest go. */
export const MOST_RECORDS = 100_000;
const MOST_HELD = 1.25 * MOST_RECORDS;

/** The trace in which a log is shown. */
export type LogTrace = Pick<TraceView, 'append' | 'clear' | 'state'>;

/**
 * What was sent and received, as records. A trace shows them, which a worker holds; they are here too, because a page that is left
 * has to keep them at once, and because a worker may end.
 */
export class BusLog {
  /** How many records were cleared, which can be brought back until others come. */
  readonly cleared = signal(0);
  /** How many of the records were there before the page was loaded again. */
  readonly restored = signal(0);
  /** Whether the trace stays as it is while others come. */
  readonly paused = signal(false);
  /** How many records it does not have yet. */
  readonly held = signal(0);
  /** Raised whenever there are other records. */
  changes = 0;
  readonly #trace: LogTrace;
  /** The oldest go when there are a quarter more. */
  #records: TraceInput[] = [];
  #cleared: TraceInput[] = [];

  constructor(trace: LogTrace) {
    this.#trace = trace;
  }

  /** The last records. */
  get records(): readonly TraceInput[] {
    return this.#records.slice(-MOST_RECORDS);
  }

  add(lines: readonly LogLine[]): void {
    const added = recordsOfLines(lines);
    for (const record of added) this.#records.push(record);
    if (this.#records.length > MOST_HELD) this.#records = this.#records.slice(-MOST_RECORDS);
    this.changes++;
    this.#cleared = [];
    batch(() => {
      this.cleared.value = 0;
      this.held.value = Math.min(this.held.peek() + added.length, this.#records.length);
      if (!this.paused.peek()) this.#show();
    });
  }

  clear(): void {
    this.#cleared = this.#records;
    this.#records = [];
    this.changes++;
    batch(() => {
      this.cleared.value = this.#cleared.length;
      this.restored.value = 0;
      this.held.value = 0;
      this.#trace.clear();
    });
  }

  bringBack(): void {
    this.#begin(this.#cleared);
  }

  /** Shows the records that were there before the page was loaded again. */
  restore(records: readonly TraceInput[]): void {
    this.restored.value = records.length;
    this.#begin(records);
  }

  /** Holds back what comes from now on, or shows it with all that was held back. */
  pause(on: boolean): void {
    batch(() => {
      this.paused.value = on;
      if (!on) this.#show();
    });
  }

  #begin(records: readonly TraceInput[]): void {
    this.#records = [...records];
    this.#cleared = [];
    this.changes++;
    batch(() => {
      this.cleared.value = 0;
      this.held.value = records.length;
      this.#show();
    });
  }

  /** Gives the trace what it does not have; all, if the worker that had it has ended. */
  #show(): void {
    const isLost = this.#trace.state.peek().kind === 'failed';
    const held = isLost ? this.#records.length : this.held.peek();
    this.held.value = 0;
    if (held > 0) this.#trace.append(this.#records.slice(-held), MOST_RECORDS);
  }
}
