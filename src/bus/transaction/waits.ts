import type { Clock } from '../clock.ts';

/** A timer that comes later than this, in milliseconds, says that the page was held up. */
const HELD_UP = 20;

/** What a transaction waits for, each under its name. Setting one takes the place of the one before. */
export class Waits<Name extends string> {
  readonly #clock: Clock;
  readonly #offs = new Map<Name, () => void>();

  constructor(clock: Clock) {
    this.#clock = clock;
  }

  has(name: Name): boolean {
    return this.#offs.has(name);
  }

  /** Calls `then` in `delay` milliseconds. */
  set(name: Name, delay: number, then: () => void): void {
    this.#offs.get(name)?.();
    this.#offs.set(name, this.#clock.after(delay, then));
  }

  /** The same, but when the page was held up meanwhile, bytes that nobody could hand over are given a moment to come. */
  setPatiently(name: Name, delay: number, then: () => void): void {
    const due = this.#clock.now() + delay;
    this.set(name, delay, () => {
      if (this.#clock.now() - due > HELD_UP) this.set(name, HELD_UP, then);
      else then();
    });
  }

  off(name: Name): void {
    this.#offs.get(name)?.();
    this.#offs.delete(name);
  }

  clear(): void {
    for (const off of this.#offs.values()) off();
    this.#offs.clear();
  }
}
