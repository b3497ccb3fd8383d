import type { RecordStorage } from '../../../src/store/index.ts';

/** A browser's records and the tabs that share them. */
export class TestRecords {
  readonly records = new Map<string, unknown>();
  /** How many more writes there is room for. */
  room = Number.POSITIVE_INFINITY;
  /** Whether the browser refuses everything. */
  refuses = false;
  /** The keys that were written, in their order. */
  readonly written: string[] = [];
  readonly #tabs = new Set<(key: string) => void>();
  #last: Promise<void> = Promise.resolve();
  #unique = 0;

  /** The storage as another tab has it; what `before` answers comes before each of its calls. */
  tab(before: () => Promise<void> = async () => undefined): RecordStorage {
    let mine: ((key: string) => void) | undefined;
    const call = async <T>(act: () => T): Promise<T> => {
      await before();
      if (this.refuses) throw new Error('refused');
      return act();
    };
    return {
      keys: () => call(() => [...this.records.keys()]),
      get: (key) => call(() => structuredClone(this.records.get(key))),
      set: (key, record) =>
        call(() => {
          if (this.room <= 0) throw Object.assign(new Error('no room'), { name: 'QuotaExceededError' });
          this.room--;
          this.written.push(key);
          this.records.set(key, structuredClone(record));
        }),
      delete: (key) => call(() => void this.records.delete(key)),
      tell: (key) => {
        for (const tab of this.#tabs) if (tab !== mine) tab(key);
      },
      listen: (told) => {
        mine = told;
        this.#tabs.add(told);
      },
      alone: (act) => {
        const done = this.#last.then(act);
        this.#last = done.catch(() => undefined);
        return done;
      },
      unique: () => String(this.#unique++),
    };
  }
}

/** Lets everything happen that waits for nothing but promises. */
export const settle = () => new Promise<void>((done) => setImmediate(done));
