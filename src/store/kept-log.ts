import { readTraceJson, writeTraceJson } from '../captures/index.ts';
import type { TraceInput } from '../trace/index.ts';
import type { TextStorage } from '../workbench/index.ts';
import type { BusLog } from './bus-log.ts';

/** Records that are kept of a log at most. */
export const MOST_KEPT = 20_000;
/** Characters that are kept at most: browsers give a page some five million for each tab. */
const MOST_CHARACTERS = 4_000_000;
const KEY = 'framewright.bus-log';

/** Keeps the end of a log while its tab is open, so that it is there again when the page is loaded again. */
export class KeptLog {
  readonly #log: BusLog;
  readonly #texts: () => TextStorage;
  /** The changes of the log when it was kept. */
  #kept: number;

  /**
   * Brings back what was kept.
   * @param texts storage of the tab; it is asked each time, and may throw where it is forbidden
   */
  constructor(log: BusLog, texts: () => TextStorage) {
    this.#log = log;
    this.#texts = texts;
    try {
      const { records } = readTraceJson(texts().getItem(KEY) ?? '') ?? { records: [] };
      // They were heard, though they come out of a text.
      if (records.length > 0) log.restore(records.map(({ place: _, ...record }) => record));
    } catch {
      // What cannot be read is not brought back.
    }
    this.#kept = log.changes;
  }

  /** Keeps the log as it is now: its last records, as many as the browser takes. */
  readonly keep = (): void => {
    const { records, changes } = this.#log;
    if (changes === this.#kept) return;
    this.#kept = changes;
    for (let some = lastOf(records); ; some = some.slice(Math.ceil(some.length / 2))) {
      try {
        this.#texts().setItem(KEY, writeTraceJson(some));
        return;
      } catch {
        if (some.length === 0) return;
      }
    }
  };
}

/** What a record takes as JSON beside its bytes, at most. */
const BESIDE = 120;
const DIGITS = 2;

function lastOf(records: readonly TraceInput[]): readonly TraceInput[] {
  let from = records.length;
  let size = 0;
  while (from > 0 && records.length - from < MOST_KEPT) {
    size += BESIDE + DIGITS * (records[from - 1]?.bytes.length ?? 0);
    if (size > MOST_CHARACTERS) break;
    from--;
  }
  return records.slice(from);
}
