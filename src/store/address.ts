import { type Signal, signal } from '@preact/signals-core';
import type { HistoryAct } from '../workbench/index.ts';

/** The address of the window behind `#` and its history, as the browser has them. */
export interface AddressBar {
  /** What stands behind the page's own address, with `#`; empty if nothing does. */
  hash(): string;
  replace(hash: string): void;
  push(hash: string): void;
}

/** Calls `act` after some milliseconds. Answers how to prevent that. */
export type After = (milliseconds: number, act: () => void) => () => void;

/** Browsers limit how often the address may change, so that it follows typing after a pause of so many milliseconds. */
const DELAY = 250;

/** Everything that reads and writes the address: the frame's draft, and the views beside it. */
export class Address {
  /** The address that the page was given last: at the start, by Back and Forward, or by hand. A new object each time. */
  readonly given: Signal<{ readonly hash: string }>;
  readonly #bar: AddressBar;
  readonly #after: After;
  /** The address at the last step, to which Back returns from what is being typed. */
  #stepped: string;
  #pending: { readonly hash: () => string; readonly settles: boolean; readonly stop: () => void } | undefined;

  constructor(bar: AddressBar, after: After) {
    this.#bar = bar;
    this.#after = after;
    this.#stepped = bar.hash();
    this.given = signal({ hash: this.#stepped });
  }

  /** The address at the last step. */
  get stepped(): string {
    return this.#stepped;
  }

  /** Takes the address that the window has now. */
  take(): void {
    this.drop();
    this.#stepped = this.#bar.hash();
    this.given.value = { hash: this.#stepped };
  }

  /** Goes to another address, as a link to it does. */
  go(hash: string): void {
    this.now();
    this.#bar.push(hash);
    this.take();
  }

  /**
   * Lets the address follow what is typed, in place and at a pause; `hash` is asked then.
   *
   * @param settles whether Back returns to the address as it is then, not as it was at the last step
   */
  later(hash: () => string, settles: boolean): void {
    this.drop();
    this.#pending = { hash, settles, stop: this.#after(DELAY, () => this.now()) };
  }

  /** Brings the address up to what is typed at once. */
  now(): void {
    const pending = this.#pending;
    if (pending === undefined) return;
    this.drop();
    const hash = pending.hash();
    this.#bar.replace(hash);
    if (pending.settles) this.#stepped = hash;
  }

  /** Gives up what was to follow. */
  drop(): void {
    this.#pending?.stop();
    this.#pending = undefined;
  }

  /** Carries out a plan that ends in the address `hash`, as a step. Without a plan the address is brought up to what is typed. */
  step(plan: readonly HistoryAct[], hash: string): void {
    if (plan.length === 0) {
      this.now();
      return;
    }
    this.drop();
    for (const act of plan) this.#bar[act.kind](act.hash);
    this.#stepped = hash;
  }
}
