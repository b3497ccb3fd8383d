import { describe, expect, it } from 'vitest';
import { Samples } from '../../../../src/bus/index.ts';
import { chartData } from '../../../../src/workbench/bus/chart-data.ts';

describe('what is drawn', () => {
  const samples = (count: number, number: (round: number) => number | undefined) => {
    const all = new Samples(1);
    for (let round = 0; round < count; round++) {
      all.begin(round * 1000);
      const one = number(round);
      if (one === undefined) all.failed(0);
      else all.read(0, round * 1000, one, one);
    }
    return all;
  };

  it('is each round while they are few, with gaps', () => {
    const all = samples(4, (round) => (round === 2 ? undefined : round));
    expect(chartData(all, [0], 1000)).toEqual([
      [1, 2, 3],
      [1, null, 3],
    ]);
  });

  it('is bounded, and loses no peak', () => {
    const all = samples(50_000, (round) => (round === 33_333 ? 1000 : round === 41_001 ? -1000 : 1));
    const [times, values] = chartData(all, [0], Number.NEGATIVE_INFINITY, 1000);
    expect(times.length).toBeLessThanOrEqual(1010);
    expect(values).toHaveLength(times.length);
    expect(Math.max(...(values as number[]))).toBe(1000);
    expect(Math.min(...(values as number[]))).toBe(-1000);
    expect(times).toEqual(times.toSorted((a, b) => a - b));
    expect([times[0], times.at(-1)]).toEqual([0, 49_999]);
  });

  it('goes on in the same groups as rounds are added', () => {
    const [first] = chartData(
      samples(120_000, () => 1),
      [0],
      Number.NEGATIVE_INFINITY,
    );
    const [second] = chartData(
      samples(120_001, () => 1),
      [0],
      Number.NEGATIVE_INFINITY,
    );
    expect(first.slice(2, 100)).toEqual(second.slice(2, 100));
  });

  it('has the two ends of each group in the order in which they came', () => {
    // Four rounds a point pair: the peak comes first in the first group, and last in the second.
    const numbers = [5, 9, 1, 5, 5, 2, 8, 5];
    const all = samples(numbers.length, (round) => numbers[round]);
    expect(chartData(all, [0], Number.NEGATIVE_INFINITY, 4)).toEqual([
      [0, 3, 4, 7],
      [9, 1, 2, 8],
    ]);
  });
});
