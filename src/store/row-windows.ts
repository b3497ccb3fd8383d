import type { TraceRow } from '../workbench/index.ts';

/** Rows that are asked for at a time, at most. */
const WINDOW = 32;
/** Windows of rows that are kept. */
const MOST = 256;

interface Window {
  readonly rows: readonly TraceRow[];
  /** How many of them, from the first on, are as the list has them. The others are shown until those of now have come. */
  fresh: number;
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
    const first = at * WINDOW;
    const window = this.#windows.get(at);
    const fresh = window?.fresh ?? 0;
    if (row - first >= fresh && !this.#asked.has(at) && row < count) {
      this.#asked.add(at);
      this.#ask(first + fresh, first + WINDOW);
    }
    return window?.rows[row - first];
  }

  /** Takes rows that were asked for. */
  keep(from: number, rows: readonly TraceRow[]): void {
    const at = Math.floor(from / WINDOW);
    const into = from - at * WINDOW;
    const { rows: before = [], fresh = 0 } = this.#windows.get(at) ?? {};
    this.#asked.delete(at);
    // The map keeps its order: the window that came first goes first.
    this.#windows.delete(at);
    // Rows before them may have changed since they were asked for.
    const isJoined = into <= fresh;
    this.#windows.set(at, {
      rows: [...before.slice(0, into), ...rows],
      fresh: isJoined ? into + rows.length : fresh,
    });
    for (const oldest of this.#windows.keys()) {
      if (this.#windows.size <= MOST) break;
      this.#windows.delete(oldest);
    }
  }

  /** The list has changed from a row on: those rows are asked for again, and shown as they were until then. */
  change(from: number): void {
    for (const [at, window] of this.#windows) window.fresh = Math.max(0, Math.min(window.fresh, from - at * WINDOW));
  }

  /** The list is another one. */
  clear(): void {
    this.#windows.clear();
    this.#asked.clear();
  }
}
