import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { lineForKey, linesInSight, scrollHeight, scrollScale, scrollToLine } from '../../../src/ui/kit/line-window.ts';

const small = { count: 1000, line: 32, view: 320 };
const million = { count: 1_000_000, line: 32, view: 320 };

describe('the lines of a list that are drawn', () => {
  test('are those in sight and eight on each side', () => {
    expect(linesInSight(small, 0)).toEqual({ from: 0, to: 18, origin: 0 });
    expect(linesInSight(small, 3200)).toEqual({ from: 92, to: 118, origin: 0 });
    expect(linesInSight(small, 32_000 - 320)).toEqual({ from: 982, to: 1000, origin: 0 });
    expect(linesInSight({ ...small, count: 0 }, 0)).toEqual({ from: 0, to: 0, origin: 0 });
  });

  test('are some when the list has become shorter than it was scrolled', () => {
    expect(linesInSight({ ...small, count: 5 }, 3200)).toMatchObject({ to: 5, from: 0 });
  });

  test('stand in a box no taller than browsers can count', () => {
    expect(scrollHeight(small)).toBe(32_000);
    expect(scrollScale(small)).toBe(1);
    expect(scrollHeight(million)).toBe(7_000_000);
    expect(linesInSight(million, 7_000_000 - 320).to).toBe(1_000_000);
  });
});

/** The place of a line in the box, from the top of what is in sight. */
const placeOf = (box: typeof small, scrolled: number, index: number) =>
  linesInSight(box, scrolled).origin + index * box.line - scrolled;

const boxes = fc.record({
  count: fc.integer({ min: 1, max: 3_000_000 }),
  line: fc.integer({ min: 20, max: 60 }),
  view: fc.integer({ min: 120, max: 900 }),
});

test('a line that is brought into sight is drawn, and stands in sight as a whole', () => {
  fc.assert(
    fc.property(boxes, fc.nat(), fc.nat(), (box, at, to) => {
      const index = to % box.count;
      const most = Math.max(0, scrollHeight(box) - box.view);
      const scrolled = Math.min(most, scrollToLine(box, at % (most + 1), index));
      const { from, to: past } = linesInSight(box, scrolled);
      expect(index).toBeGreaterThanOrEqual(from);
      expect(index).toBeLessThan(past);
      const top = placeOf(box, scrolled, index);
      expect(top).toBeGreaterThan(-0.01);
      expect(top + box.line).toBeLessThanOrEqual(box.view + 0.01);
    }),
  );
});

test('a line in sight is not moved', () => {
  expect(scrollToLine(small, 3200, 100)).toBe(3200);
  expect(scrollToLine(small, 3200, 109)).toBe(3200);
  expect(scrollToLine(small, 3200, 110)).toBe(3232);
  expect(scrollToLine(small, 3200, 99)).toBe(3168);
});

test('keys lead to the next line, a page further and to the ends', () => {
  const lead = (key: string, from: number) => lineForKey(key, small, from);
  expect(['ArrowDown', 'ArrowUp', 'PageDown', 'PageUp', 'Home', 'End'].map((key) => lead(key, 500))).toEqual([
    501, 499, 510, 490, 0, 999,
  ]);
  expect([lead('ArrowUp', 0), lead('PageUp', 5), lead('ArrowDown', 999), lead('PageDown', 995)]).toEqual([
    0, 0, 999, 999,
  ]);
  expect(lead('a', 500)).toBeUndefined();
  expect(lineForKey('PageDown', { ...small, view: 10 }, 3)).toBe(4);
});
