/** Times in microseconds, of those that are known. */
export interface Spread {
  readonly minimum: number;
  readonly median: number;
  readonly p95: number;
  readonly maximum: number;
}

/**
 * Numbers that become more, and their spread at any time, exactly. What is new is sorted when the spread is asked for, and
 * joined with what was sorted before it once it is no longer much less, so that asking often costs no more than sorting all once.
 */
export class Distribution {
  #fresh: number[] = [];
  /** Sorted, each at least twice as long as the next. */
  readonly #runs: Float64Array[] = [];

  /** Takes a number; `NaN` does not count. */
  add(number: number): void {
    if (!Number.isNaN(number)) this.#fresh.push(number);
  }

  /** The least, the middle, that of 95 of 100, and the most; `undefined` if there are no numbers. */
  get spread(): Spread | undefined {
    this.#settle();
    const length = this.#runs.reduce((sum, run) => sum + run.length, 0);
    if (length === 0) return undefined;
    const half = length >> 1;
    const middle = this.#at(half);
    return {
      minimum: this.#at(0),
      median: length % 2 === 1 ? middle : (this.#at(half - 1) + middle) / 2,
      p95: this.#at(Math.ceil(0.95 * length) - 1),
      maximum: this.#at(length - 1),
    };
  }

  #settle(): void {
    if (this.#fresh.length === 0) return;
    let run = Float64Array.from(this.#fresh).sort();
    this.#fresh = [];
    for (let last = this.#runs.at(-1); last && last.length < 2 * run.length; last = this.#runs.at(-1)) {
      this.#runs.pop();
      run = merged(last, run);
    }
    this.#runs.push(run);
  }

  /** The number at a place of all of them in ascending order, which is below how many there are. */
  #at(place: number): number {
    const parts = this.#runs.map((run) => ({ run, from: 0, to: run.length }));
    for (;;) {
      const { run, from, to } = parts.reduce((one, other) =>
        one.to - one.from >= other.to - other.from ? one : other,
      );
      const guess = run[(from + to) >> 1] as number;
      const below = parts.map((part) => firstPlace(part, (number) => number >= guess));
      const through = parts.map((part) => firstPlace(part, (number) => number > guess));
      const isBelow = place < sum(below);
      if (!isBelow && place < sum(through)) return guess;
      for (const [index, part] of parts.entries()) {
        if (isBelow) part.to = below[index] as number;
        else part.from = through[index] as number;
      }
    }
  }
}

const sum = (numbers: readonly number[]): number => numbers.reduce((all, one) => all + one, 0);

/** The first place of a part whose number is such, or its end, where all behind one that is such are such too. */
function firstPlace(
  { run, from, to }: { readonly run: Float64Array; readonly from: number; readonly to: number },
  isSuch: (number: number) => boolean,
): number {
  let [low, high] = [from, to];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (isSuch(run[middle] as number)) high = middle;
    else low = middle + 1;
  }
  return low;
}

function merged(one: Float64Array, other: Float64Array): Float64Array<ArrayBuffer> {
  const all = new Float64Array(one.length + other.length);
  for (let at = 0, first = 0, second = 0; at < all.length; at++) {
    const takesFirst =
      second === other.length || (first < one.length && (one[first] as number) <= (other[second] as number));
    all[at] = (takesFirst ? one[first++] : other[second++]) as number;
  }
  return all;
}
