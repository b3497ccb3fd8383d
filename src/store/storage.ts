import { type Signal, signal } from '@preact/signals-core';
import type { Decoder, TextStorage } from '../workbench/index.ts';

/** What the page keeps in the browser. What other tabs store under the same keys is followed. */
export class PageStorage {
  readonly texts: () => TextStorage;
  readonly #followers = new Map<string, (() => void)[]>();

  /**
   * @param texts is asked each time and may throw, as `localStorage` does where it is forbidden
   * @param listen tells the key of each text that another tab has changed; `null` if it may be any
   */
  constructor(texts: () => TextStorage, listen: (told: (key: string | null) => void) => void) {
    this.texts = texts;
    listen((key) => {
      const followers = key === null ? [...this.#followers.values()].flat() : this.#followers.get(key);
      for (const follow of followers ?? []) follow();
    });
  }

  /** Calls `onChange` whenever another tab has changed the text of a key. */
  follow(key: string, onChange: () => void): void {
    this.#followers.set(key, [...(this.#followers.get(key) ?? []), onChange]);
  }
}

/** A choice kept under a key of its own, as JSON. Where storage is refused, it holds until the page is closed. */
export class KeptChoice<T> {
  readonly #key: string;
  readonly #storage: PageStorage;
  readonly #held: Signal<T>;

  /**
   * `initial` stands for what is missing or not legal. What a tab works on is its own (`tab`): another tab's choice holds
   * there only after the page is loaded again.
   */
  constructor(storage: PageStorage, name: string, initial: T, read: Decoder<T>, of: 'browser' | 'tab' = 'browser') {
    this.#key = `framewright.${name}`;
    this.#storage = storage;
    this.#held = signal(initial);
    const load = () => {
      try {
        this.#held.value = read(JSON.parse(storage.texts().getItem(this.#key) ?? 'null')) ?? initial;
      } catch {
        // What cannot be read changes nothing.
      }
    };
    load();
    if (of === 'browser') storage.follow(this.#key, load);
  }

  get value(): T {
    return this.#held.value;
  }

  set value(value: T) {
    this.#held.value = value;
    try {
      this.#storage.texts().setItem(this.#key, JSON.stringify(value));
    } catch {
      // Held in memory all the same.
    }
  }
}
