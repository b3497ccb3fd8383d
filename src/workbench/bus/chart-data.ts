import type { Samples } from '../../bus/index.ts';

/** Points that a value is drawn with at most: more than a screen has columns. */
export const MOST_POINTS = 2000;

/** Times in seconds since 1970, then the numbers of each value; `null` is a gap. */
export type ChartData = [number[], ...(number | null)[][]];

/**
 * What is drawn of some values: their rounds from `since` on (milliseconds since 1970). Of more rounds than points, each two
 * points are the minimum and the maximum of several rounds, in the order they came in, so that no peak is lost.
 */
export function chartData(samples: Samples, values: readonly number[], since: number, points = MOST_POINTS): ChartData {
  const first = samples.firstSince(since);
  const { length, rounds } = samples;
  const each = Math.max(1, Math.ceil((2 * (length - first)) / points));
  const times: number[] = [];
  const columns = values.map((): (number | null)[] => []);
  // Groups begin at the same rounds each time, so that the line does not flicker as it grows.
  const dropped = rounds - length;
  for (let from = first; from < length; ) {
    const to = each <= 2 ? from + 1 : Math.min(length, (Math.floor((from + dropped) / each) + 1) * each - dropped);
    const ends = to - from > 1 ? [from, to - 1] : [from];
    for (const end of ends) times.push(samples.timeOf(end) / 1000);
    for (const [at, value] of values.entries()) {
      const [early, late] = extremes(samples, value, from, to);
      columns[at]?.push(...(ends.length === 1 ? [early] : [early, late]));
    }
    from = to;
  }
  return [times, ...columns];
}

/** The least and the most of some rounds, whichever came first in front. */
function extremes(samples: Samples, value: number, from: number, to: number): [number | null, number | null] {
  let [least, most, leastAt, mostAt] = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY, -1, -1];
  for (let round = from; round < to; round++) {
    const one = Number(samples.valueOf(value, round) ?? Number.NaN);
    if (one < least) [least, leastAt] = [one, round];
    if (one > most) [most, mostAt] = [one, round];
  }
  if (leastAt < 0 || mostAt < 0 || !Number.isFinite(least) || !Number.isFinite(most)) return [null, null];
  return leastAt <= mostAt ? [least, most] : [most, least];
}
