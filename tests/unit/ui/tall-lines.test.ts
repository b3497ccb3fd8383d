import fc from 'fast-check';
import { expect, test } from 'vitest';
import { lineAt, topOf } from '../../../src/ui/kit/tall-lines.ts';

const lines = (count: number, below: readonly (readonly [number, number])[]) => ({
  count,
  line: 50,
  below: new Map(below),
});

test('lines stand below each other, and further down behind one that has something below it', () => {
  const all = lines(10, [
    [2, 100],
    [5, 30],
  ]);
  expect([0, 1, 2, 3, 5, 6, 10].map((index) => topOf(all, index))).toEqual([0, 50, 100, 250, 350, 430, 630]);
});

test('a line stands at each distance from its top to what is below it', () => {
  const all = lines(10, [
    [5, 30],
    [2, 100],
  ]);
  expect([0, 49, 50, 149, 150, 249, 250, 299, 300, 429, 430].map((top) => lineAt(all, top))).toEqual([
    0, 0, 1, 2, 2, 2, 3, 3, 4, 5, 6,
  ]);
  expect([-20, 629, 5000].map((top) => lineAt(all, top))).toEqual([0, 9, 9]);
  expect(lineAt(lines(0, []), 30)).toBe(0);
});

test('the line at any distance begins at it or above it, and the next one below it', () => {
  const below = fc.uniqueArray(fc.tuple(fc.nat(40), fc.integer({ min: 0, max: 500 })), { selector: ([at]) => at });
  fc.assert(
    fc.property(below, fc.nat(3000), (some, top) => {
      const all = lines(41, some);
      const index = lineAt(all, top);
      expect(topOf(all, index)).toBeLessThanOrEqual(top);
      if (index < 40) expect(topOf(all, index + 1)).toBeGreaterThan(top);
    }),
  );
});
