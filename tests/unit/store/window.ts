import { signal } from '@preact/signals-core';
import type { SerialLine } from '../../../src/modbus/index.ts';
import type { AddressBar, After, LogTrace } from '../../../src/store/index.ts';
import { KeptChoice, PageStorage } from '../../../src/store/index.ts';
import { text } from '../../../src/workbench/index.ts';

/** A window's history without a window: its entries, the present one, and a clock that is moved by hand. */
export class TestWindow {
  /** The hashes of its entries, and the texts of the input beside them. */
  readonly entries: string[];
  readonly inputs: (string | undefined)[];
  at = 0;
  #waiting: { readonly due: number; readonly act: () => void }[] = [];
  #now = 0;

  constructor(hash = '', input?: string) {
    this.entries = [hash];
    this.inputs = [input];
  }

  /** Goes to an address as a link does. */
  goTo(hash: string): void {
    this.entries.splice(++this.at, Number.POSITIVE_INFINITY, hash);
    this.inputs.splice(this.at, Number.POSITIVE_INFINITY, undefined);
  }

  readonly bar: AddressBar = {
    hash: () => this.entries[this.at]!,
    input: () => this.inputs[this.at],
    replace: ({ hash, input }) => {
      this.entries[this.at] = hash;
      this.inputs[this.at] = input;
    },
    push: ({ hash, input }) => {
      this.goTo(hash);
      this.inputs[this.at] = input;
    },
  };

  readonly after: After = (milliseconds, act) => {
    const one = { due: this.#now + milliseconds, act };
    this.#waiting.push(one);
    return () => {
      this.#waiting = this.#waiting.filter((other) => other !== one);
    };
  };

  /** Lets time pass. */
  wait(milliseconds: number): void {
    this.#now += milliseconds;
    const due = this.#waiting.filter((one) => one.due <= this.#now);
    this.#waiting = this.#waiting.filter((one) => one.due > this.#now);
    for (const { act } of due) act();
  }
}

/** A browser's storage and the tabs that share it. */
export class TestBrowser {
  readonly texts = new Map<string, string>();
  /** Whether the browser refuses everything. */
  refuses = false;
  readonly #tabs: ((key: string | null) => void)[] = [];

  /** The storage as another tab has it. */
  tab(): PageStorage {
    let mine: ((key: string | null) => void) | undefined;
    const tell = (key: string) => {
      for (const tab of this.#tabs) if (tab !== mine) tab(key);
    };
    return new PageStorage(
      () => {
        if (this.refuses) throw new Error('refused');
        return {
          getItem: (key) => this.texts.get(key) ?? null,
          setItem: (key, text) => {
            if (this.texts.get(key) === text) return;
            this.texts.set(key, text);
            tell(key);
          },
          removeItem: (key) => {
            if (this.texts.delete(key)) tell(key);
          },
        };
      },
      (told) => {
        mine = told;
        this.#tabs.push(told);
      },
    );
  }

  /** Another program, or an older page, stores a text. */
  store(key: string, text: string): void {
    this.texts.set(key, text);
    for (const tab of this.#tabs) tab(key);
  }

  /** Somebody clears everything. */
  clear(): void {
    this.texts.clear();
    for (const tab of this.#tabs) tab(null);
  }
}

/** The device that a tab remembers, as the page keeps it. */
export const rememberedIn = (storage: PageStorage) => new KeptChoice(storage, 'device', '', text(), 'tab');

/** A page whose link may name the line. */
export function linePage(named?: SerialLine) {
  const line = signal(named);
  const setLine = (next: SerialLine) => {
    line.value = next;
  };
  return { line, setLine };
}

/** A trace that shows nothing. */
export const noTrace: LogTrace = { state: signal({ kind: 'empty' }), append: () => undefined, clear: () => undefined };
