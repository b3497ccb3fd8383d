import { type LogLine, logAsJson, logFromJson } from '../bus/index.ts';
import type { TextStorage } from '../workbench/index.ts';
import type { BusLog } from './bus-log.ts';

/** Lines that are kept of a log at most. */
export const MOST_KEPT = 20_000;
/** Characters that are kept at most: browsers give a page some five million for each tab. */
const MOST_CHARACTERS = 4_000_000;
const KEY = 'framewright.bus-log';

/** Keeps the end of a log while its tab is open, so that it is there again when the page is loaded again. */
export class KeptLog {
  readonly #log: BusLog;
  readonly #texts: () => TextStorage;
  #kept: readonly LogLine[] = [];

  /**
   * Brings back what was kept.
   * @param texts storage of the tab; it is asked each time, and may throw where it is forbidden
   */
  constructor(log: BusLog, texts: () => TextStorage) {
    this.#log = log;
    this.#texts = texts;
    try {
      const lines = logFromJson(texts().getItem(KEY) ?? '') ?? [];
      if (lines.length > 0) log.restore(lines);
    } catch {
      // What cannot be read is not brought back.
    }
    this.#kept = log.lines;
  }

  /** Keeps the log as it is now: its last lines, as many as the browser takes. */
  readonly keep = (): void => {
    const { lines } = this.#log;
    if (lines === this.#kept) return;
    this.#kept = lines;
    for (let some = lastLines(lines); ; some = some.slice(Math.ceil(some.length / 2))) {
      try {
        this.#texts().setItem(KEY, logAsJson(some, 0));
        return;
      } catch {
        if (some.length === 0) return;
      }
    }
  };
}

/** What a line takes as JSON beside its bytes, at most. */
const BESIDE = 180;

function lastLines(lines: readonly LogLine[]): readonly LogLine[] {
  let from = lines.length;
  let size = 0;
  while (from > 0 && lines.length - from < MOST_KEPT) {
    size += BESIDE + (lines[from - 1]?.hex.length ?? 0);
    if (size > MOST_CHARACTERS) break;
    from--;
  }
  return lines.slice(from);
}
