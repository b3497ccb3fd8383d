import type { Value } from '../modbus/index.ts';
import { Statistics } from './statistics.ts';

/** Values that are kept in all, however many a round has: about 20 MB. */
export const MOST_CELLS = 1_000_000;
/** The most rounds that are kept: at ten a second, almost three hours. */
export const MOST_ROUNDS = 100_000;

/** What a poll has read: statistics of all of it, and the last rounds. Its size is bounded. */
export class Samples {
  readonly statistics: readonly Statistics[];
  /** The last reading of each value; `undefined` until there is one. */
  readonly last: (Value | undefined)[];
  /** How many rounds are kept. */
  readonly most: number;
  #rounds = 0;
  readonly #times: number[] = [];
  readonly #columns: readonly (Value | undefined)[][];

  /** `values`: how many there are in a round. */
  constructor(values: number) {
    this.statistics = Array.from({ length: values }, () => new Statistics());
    this.last = new Array<Value | undefined>(values).fill(undefined);
    this.most = Math.max(2, Math.min(MOST_ROUNDS, Math.floor(MOST_CELLS / (values + 1))));
    this.#columns = Array.from({ length: values }, () => []);
  }

  /** Rounds that have begun, with those that are no longer kept. */
  get rounds(): number {
    return this.#rounds;
  }

  /** Rounds that are kept. */
  get length(): number {
    return this.#times.length;
  }

  /** Begins a round, in which nothing has been read yet. `at` is in milliseconds since 1970. */
  begin(at: number): void {
    const place = this.#rounds % this.most;
    this.#rounds++;
    this.#times[place] = at;
    for (const column of this.#columns) column[place] = undefined;
  }

  /** Takes a reading of a value in this round; `number` is the reading in its unit, absent for texts and what is no number of it. */
  read(value: number, at: number, reading: Value, number?: number | bigint): void {
    this.statistics[value]?.read(at, number);
    this.last[value] = reading;
    const column = this.#columns[value];
    const kept = number ?? (typeof reading === 'string' ? reading : undefined);
    if (column && this.#rounds > 0) column[(this.#rounds - 1) % this.most] = kept;
  }

  failed(value: number): void {
    this.statistics[value]?.failed();
  }

  /** A value came that may be that of another request: it is not kept. */
  doubted(value: number): void {
    this.statistics[value]?.doubted();
  }

  /** When a kept round began; kept rounds are counted from 0, the oldest first. */
  timeOf(round: number): number {
    return this.#times[this.#place(round)] ?? Number.NaN;
  }

  /** A reading of a value in a kept round: its number or its text; `undefined` if it has neither, or if the reading failed. */
  valueOf(value: number, round: number): Value | undefined {
    return this.#columns[value]?.[this.#place(round)];
  }

  /** The first kept round that began at this time or later; the number of kept rounds if there is no such round. */
  firstSince(time: number): number {
    let [low, high] = [0, this.length];
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.timeOf(middle) < time) low = middle + 1;
      else high = middle;
    }
    return low;
  }

  #place(round: number): number {
    return this.#rounds <= this.most ? round : (this.#rounds + round) % this.most;
  }
}
