import { type Signal, signal } from '@preact/signals-core';
import type { HistoryAct, HistoryEntry } from '../workbench/index.ts';

/** The address of the window behind `#` and its history, as the browser has them. */
export interface AddressBar {
  /** What stands behind the page's own address, with `#`; empty if nothing does. */
  hash(): string;
  /** The text of the input that the present entry was given; `undefined` if it was given none, as the entry of a link. */
  input(): string | undefined;
  replace(entry: HistoryEntry): void;
  push(entry: HistoryEntry): void;
}

/** What the page was given: an address, and the text of the input where the history has it. */
export interface GivenEntry {
  readonly hash: string;
  readonly input: string | undefined;
}

/** Calls `act` after some milliseconds. Answers how to prevent that. */
export type After = (milliseconds: number, act: () => void) => () => void;

/** Browsers limit how often the address may change, so that it follows typing after a pause of so many milliseconds. */
const DELAY = 250;

/** Everything that reads and writes the address: the frame's draft, and the views beside it. */
export class Address {
  /** The address that the page was given last: at the start, by Back and Forward, or by hand. A new object each time. */
  readonly given: Signal<GivenEntry>;
  readonly #bar: AddressBar;
  readonly #after: After;
  /** The entry at the last step, to which Back returns from what is being typed. */
  #stepped: HistoryEntry;
  #pending: { readonly entry: () => HistoryEntry; readonly settles: boolean; readonly stop: () => void } | undefined;

  constructor(bar: AddressBar, after: After) {
    this.#bar = bar;
    this.#after = after;
    const given = { hash: bar.hash(), input: bar.input() };
    this.#stepped = { ...given, input: given.input ?? '' };
    this.given = signal(given);
  }

  /** The entry at the last step. */
  get stepped(): HistoryEntry {
    return this.#stepped;
  }

  /** Takes the address that the window has now. */
  take(): void {
    this.drop();
    const given = { hash: this.#bar.hash(), input: this.#bar.input() };
    this.#stepped = { ...given, input: given.input ?? '' };
    this.given.value = given;
  }

  /** Goes to another address, as a link to it does. */
  go(entry: HistoryEntry): void {
    this.now();
    this.#bar.push(entry);
    this.take();
  }

  /**
   * Lets the address follow what is typed, in place and at a pause; `entry` is asked then.
   *
   * @param settles whether Back returns to the address as it is then, not as it was at the last step
   */
  later(entry: () => HistoryEntry, settles: boolean): void {
    this.drop();
    this.#pending = { entry, settles, stop: this.#after(DELAY, () => this.now()) };
  }

  /** Brings the address up to what is typed at once. */
  now(): void {
    const pending = this.#pending;
    if (pending === undefined) return;
    this.drop();
    const entry = pending.entry();
    this.#bar.replace(entry);
    if (pending.settles) this.#stepped = entry;
  }

  /** Gives up what was to follow. */
  drop(): void {
    this.#pending?.stop();
    this.#pending = undefined;
  }

  /** Carries out a plan that ends in `entry`, as a step. Without a plan the address is brought up to what is typed. */
  step(plan: readonly HistoryAct[], entry: HistoryEntry): void {
    if (plan.length === 0) {
      this.now();
      return;
    }
    this.drop();
    for (const act of plan) this.#bar[act.kind](act.entry);
    this.#stepped = entry;
  }
}
