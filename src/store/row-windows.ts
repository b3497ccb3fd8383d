import type { TraceRow } from '../workbench/index.ts';

/** Rows that are asked for at a time. */
const WINDOW = 128;
/** Windows of rows that are kept. */
const MOST = 64;

interface Window {
  readonly rows: readonly TraceRow[];
  /** Whether the trace or the list has changed since. */
  stale: boolean;
}

/** The rows of a list that were looked at last, by windows: those that are missing are asked for, once. */
export class RowWindows {
  readonly #ask: (from: number, to: number) => void;
  readonly #windows = new Map<number, Window>();
  readonly #asked = new Set<number>();

  constructor(ask: (from: number, to: number) => void) {
    this.#ask = ask;
  }

  /** A row of a list of so many; `undefined` until it has come. */
  at(row: number, count: number): TraceRow | undefined {
    const at = Math.floor(row / WINDOW);
    const window = this.#windows.get(at);
    if ((window === undefined || window.stale) && !this.#asked.has(at) && row < count) {
      this.#asked.add(at);
      this.#ask(at * WINDOW, (at + 1) * WINDOW);
    }
    return window?.rows[row - at * WINDOW];
  }

  /** Takes rows that were asked for. */
  keep(from: number, rows: readonly TraceRow[]): void {
    const at = from / WINDOW;
    this.#asked.delete(at);
    // The map keeps its order: the window that came first goes first.
    this.#windows.delete(at);
    this.#windows.set(at, { rows, stale: false });
    for (const oldest of this.#windows.keys()) {
      if (this.#windows.size <= MOST) break;
      this.#windows.delete(oldest);
    }
  }

  /** The list has changed: its rows are asked for again, and shown as they were until then. */
  change(): void {
    for (const window of this.#windows.values()) window.stale = true;
  }

  /** The list is another one. */
  clear(): void {
    this.#windows.clear();
    this.#asked.clear();
  }
}
