/** Times in microseconds, of those that are known. */
export interface Spread {
  readonly minimum: number;
  readonly median: number;
  readonly p95: number;
  readonly maximum: number;
}

/** The least, the middle, that of 95 of 100, and the most of some numbers; `undefined` if there are none. */
export function spreadOf(numbers: ArrayLike<number>): Spread | undefined {
  const { length } = numbers;
  if (length === 0) return undefined;
  const sorted = Float64Array.from(numbers).sort();
  const at = (index: number) => sorted[index] as number;
  const half = length >> 1;
  return {
    minimum: at(0),
    median: length % 2 === 1 ? at(half) : (at(half - 1) + at(half)) / 2,
    p95: at(Math.ceil(0.95 * length) - 1),
    maximum: at(length - 1),
  };
}
