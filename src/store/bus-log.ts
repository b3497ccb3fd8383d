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
  #lines: readonly LogLine[] = [];
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
  }

  bringBack(): void {
    this.#replace(this.cleared.peek() ?? [], undefined);
  }

  add(lines: readonly LogLine[]): void {
    const over = this.#lines.length + lines.length - MOST_LINES;
    this.#lines = over > 0 ? this.#lines.slice(over).concat(lines.slice(-MOST_LINES)) : this.#lines.concat(lines);
    this.cleared.value = undefined;
    this.#revise();
  }

  #replace(lines: readonly LogLine[], cleared: readonly LogLine[] | undefined): void {
    this.#lines = lines;
    batch(() => {
      this.cleared.value = cleared;
      this.revision.value++;
    });
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
