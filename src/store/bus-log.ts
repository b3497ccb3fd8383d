import { batch, type Signal, signal } from '@preact/signals-core';
import { type LogLine, MOST_LINES } from '../bus/index.ts';
import type { After } from './address.ts';

/** `revision` is raised so often at most, in milliseconds. */
const EACH = 60;

/** What was sent and received. It is not a signal itself, because it is long: whoever shows it reads `revision` too. */
export class BusLog {
  /** Raised when there is something new in the log, every 60 ms at most. */
  readonly revision = signal(0);
  /** Lines that were cleared, until others come. */
  readonly cleared: Signal<readonly LogLine[] | undefined> = signal(undefined);
  /** How many of the lines were there before the page was loaded again. */
  readonly restored = signal(0);
  #lines: readonly LogLine[] = [];
  /** What the number of a line is raised by: each session counts its lines from 1. */
  #raise = 0;
  /** The number of the last line that the session of now has not told. */
  #foreign = 0;
  /** Whether `revision` was raised just now, and whether the log has changed since. */
  #rests: 'no' | 'fresh' | 'stale' = 'no';
  readonly #after: After;

  constructor(after: After) {
    this.#after = after;
  }

  /** The last lines: a new list whenever some are added. */
  get lines(): readonly LogLine[] {
    return this.#lines;
  }

  clear(): void {
    this.open([]);
  }

  /** Shows a log that was saved in place of this one. */
  open(lines: readonly LogLine[]): void {
    this.#replace(lines, this.#lines);
    this.#foreign = lines.at(-1)?.number ?? 0;
  }

  /** Shows the lines that were there before the page was loaded again. */
  restore(lines: readonly LogLine[]): void {
    this.#replace(lines, undefined);
    this.#foreign = lines.at(-1)?.number ?? 0;
    this.restored.value = lines.length;
  }

  bringBack(): void {
    this.#replace(this.cleared.peek() ?? [], undefined);
  }

  add(told: readonly LogLine[]): void {
    const lines = this.#numbered(told);
    const over = this.#lines.length + lines.length - MOST_LINES;
    this.#lines = over > 0 ? this.#lines.slice(over).concat(lines.slice(-MOST_LINES)) : this.#lines.concat(lines);
    this.cleared.value = undefined;
    this.#revise();
  }

  #replace(lines: readonly LogLine[], cleared: readonly LogLine[] | undefined): void {
    this.#lines = lines;
    batch(() => {
      this.cleared.value = cleared;
      this.restored.value = 0;
      this.revision.value++;
    });
  }

  /** Lines go on behind those that are there, and answer none that another session, or a file, has told. */
  #numbered(lines: readonly LogLine[]): readonly LogLine[] {
    const [first] = lines;
    const last = this.#lines.at(-1)?.number ?? 0;
    if (first && first.number + this.#raise <= last) {
      this.#raise = last + 1 - first.number;
      this.#foreign = last;
    }
    if (this.#raise === 0) return lines;
    return lines.map(({ answers = 0, ...line }) => ({
      ...line,
      number: line.number + this.#raise,
      ...(answers + this.#raise > this.#foreign && answers > 0 && { answers: answers + this.#raise }),
    }));
  }

  #revise(): void {
    if (this.#rests !== 'no') {
      this.#rests = 'stale';
      return;
    }
    this.#rests = 'fresh';
    this.revision.value++;
    this.#after(EACH, () => {
      const isStale = this.#rests === 'stale';
      this.#rests = 'no';
      if (isStale) this.#revise();
    });
  }
}
