import { describe, expect, it } from 'vitest';
import { MOST_CELLS, MOST_ROUNDS, Samples, Statistics } from '../../../src/bus/index.ts';

describe('statistics of a value', () => {
  it('has the least, the most and the mean of what was read, and counts what failed', () => {
    const statistics = new Statistics();
    for (const [at, number] of [4, -2, 10].entries()) statistics.read(at, number);
    statistics.failed();
    expect(statistics).toMatchObject({ least: -2, most: 10, mean: 4, tries: 4, errors: 1, lastAt: 2 });
  });

  it('has none of a value that was never read, and of texts', () => {
    const statistics = new Statistics();
    statistics.read(5);
    expect(statistics).toMatchObject({
      least: undefined,
      most: undefined,
      mean: undefined,
      tries: 1,
      errors: 0,
      lastAt: 5,
    });
  });

  it('leaves NaN and infinities out', () => {
    const statistics = new Statistics();
    for (const number of [Number.NaN, 3, Number.POSITIVE_INFINITY]) statistics.read(0, number);
    expect(statistics).toMatchObject({ least: 3, most: 3, mean: 3, tries: 3 });
  });

  it('keeps whole numbers of 64 bits as they are', () => {
    const statistics = new Statistics();
    for (const number of [2n ** 63n, 2n ** 63n + 1n]) statistics.read(0, number);
    expect(statistics).toMatchObject({ least: 9223372036854775808n, most: 9223372036854775809n });
  });

  it('adds millions as exactly as ten', () => {
    const statistics = new Statistics();
    statistics.read(0, 1e15);
    for (let i = 0; i < 1_000_000; i++) statistics.read(0, 0.1);
    statistics.read(0, -1e15);
    expect(statistics.mean).toBeCloseTo(100_000 / 1_000_002, 12);
  });
});

describe('samples of a poll', () => {
  it('has the rounds in their order, with gaps where nothing was read', () => {
    const samples = new Samples(2);
    samples.begin(100);
    samples.read(0, 101, 7, 7);
    samples.failed(1);
    samples.begin(200);
    samples.read(1, 201, 'on');
    expect([samples.rounds, samples.length]).toEqual([2, 2]);
    expect([samples.timeOf(0), samples.timeOf(1)]).toEqual([100, 200]);
    expect([samples.valueOf(0, 0), samples.valueOf(1, 0)]).toEqual([7, undefined]);
    expect([samples.valueOf(0, 1), samples.valueOf(1, 1)]).toEqual([undefined, 'on']);
    expect(samples.last).toEqual([7, 'on']);
  });

  it('stays of one size through a day of ten rounds a second', () => {
    const samples = new Samples(10);
    expect(samples.most).toBe(Math.floor(MOST_CELLS / 11));
    const rounds = 24 * 3600 * 10;
    let longest = 0;
    for (let round = 0; round < rounds; round++) {
      samples.begin(round * 100);
      for (let value = 0; value < 10; value++) {
        if (value === 9 && round % 4 === 0) samples.failed(value);
        else samples.read(value, round * 100, round + value, round + value);
      }
      longest = Math.max(longest, samples.length);
    }
    expect(rounds).toBe(864_000);
    expect(samples.rounds).toBe(rounds);
    expect(longest).toBe(samples.most);
    expect(samples.length * 11).toBeLessThanOrEqual(MOST_CELLS);
    // The statistics are of all of them.
    expect(samples.statistics[0]).toMatchObject({ least: 0, most: rounds - 1, mean: (rounds - 1) / 2, tries: rounds });
    expect(samples.statistics[9]).toMatchObject({ errors: rounds / 4, tries: rounds });
    // What is kept are the last.
    expect(samples.timeOf(0)).toBe((rounds - samples.most) * 100);
    expect(samples.valueOf(3, samples.length - 1)).toBe(rounds - 1 + 3);
    expect(samples.valueOf(3, 0)).toBe(rounds - samples.most + 3);
    expect(samples.firstSince((rounds - 600) * 100)).toBe(samples.length - 600);
  });

  it('keeps fewer rounds of more values, and never more than so many', () => {
    expect(new Samples(1).most).toBe(MOST_ROUNDS);
    expect(new Samples(2000).most).toBe(499);
  });
});
