import { describe, expect, test } from 'vitest';
import { firstWire, readGapAt, readMilliseconds, storedWire } from '../../../../src/workbench/wire/wire-settings.ts';

describe('what is typed of a line', () => {
  test('is a time from 0 to 2000 ms', () => {
    expect(['0', '0.5', '5 ms', '2000ms'].map(readMilliseconds)).toEqual([0, 0.5, 5, 2000]);
    for (const wrong of ['-1', '2001', 'soon', '', '5 s']) expect(readMilliseconds(wrong)).toBeUndefined();
  });

  test('is the byte that a gap stands before, or blank', () => {
    expect([' ', '1', '0x7'].map((typed) => readGapAt(typed, 7))).toEqual([
      { gapAt: undefined },
      { gapAt: 1 },
      { gapAt: 7 },
    ]);
    for (const wrong of ['0', '8', '1.5', 'x']) expect(readGapAt(wrong, 7)).toBeUndefined();
  });
});

test('what is kept of the wire is read back field by field, each as at first where it is not legal', () => {
  expect(storedWire({ level: 'ttl', delay: 2001 })).toEqual({ ...firstWire, level: 'ttl' });
  expect(storedWire({ level: 'constructor', delay: 0 })).toEqual({ ...firstWire, delay: 0 });
  for (const nothing of [null, 7, 'x', []]) expect(storedWire(nothing)).toEqual(firstWire);
});
