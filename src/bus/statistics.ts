/** Statistics of a value that is read many times; the readings themselves are not kept. */
export class Statistics {
  /** Readings that failed. */
  errors = 0;
  /** Readings that may have been those of another request: they are not counted as values. */
  doubtful = 0;
  /** Whether the last reading was such a one. */
  isDoubtful = false;
  /** Readings, with those that failed or were doubtful. */
  tries = 0;
  /** When it was read last: milliseconds since 1970. */
  lastAt: number | undefined;
  least: number | bigint | undefined;
  most: number | bigint | undefined;
  #count = 0;
  #sum = 0;
  /** What the sum has lost by rounding (Neumaier): millions of readings are added as exactly as ten. */
  #lost = 0;

  /** The mean of all finite numbers. NaN and infinities count as readings, but not here. */
  get mean(): number | undefined {
    return this.#count === 0 ? undefined : (this.#sum + this.#lost) / this.#count;
  }

  /** `number` is absent for texts. */
  read(at: number, number?: number | bigint): void {
    this.tries++;
    this.isDoubtful = false;
    this.lastAt = at;
    if (number === undefined || (typeof number === 'number' && !Number.isFinite(number))) return;
    if (this.least === undefined || number < this.least) this.least = number;
    if (this.most === undefined || number > this.most) this.most = number;
    this.#count++;
    const one = Number(number);
    const sum = this.#sum + one;
    this.#lost += Math.abs(this.#sum) >= Math.abs(one) ? this.#sum - sum + one : one - sum + this.#sum;
    this.#sum = sum;
  }

  failed(): void {
    this.tries++;
    this.isDoubtful = false;
    this.errors++;
  }

  doubted(): void {
    this.tries++;
    this.isDoubtful = true;
    this.doubtful++;
  }
}
