import { describe, expect, it } from 'vitest';
import { clockTime, LogClock } from '../../../src/captures/clock.ts';

describe('the time that a log prints', () => {
  it.each([
    ['10:31:22', 37_882_000_000, false],
    ['10:31:22.5', 37_882_500_000, false],
    ['10:31:22,123', 37_882_123_000, false],
    ['10:31:22:123', 37_882_123_000, false],
    ['10:31:22.123456789', 37_882_123_456, false],
    ['01:02:03 PM', 46_923_000_000, false],
    ['12:00:00 AM', 0, false],
    ['1970-01-02 00:00:01', 86_401_000_000, true],
    ['2023-11-14T22:13:20Z', 1_700_000_000_000_000, true],
    ['2023-11-14T23:13:20.5+01:00', 1_700_000_000_500_000, true],
    ['14.11.2023 22:13:20', 1_700_000_000_000_000, true],
    ['11/14/2023 22:13:20', 1_700_000_000_000_000, true],
    ['2024/02/29 00:00:00', 1_709_164_800_000_000, true],
    ['1700000000.249713', 1_700_000_000_249_713, true],
    ['0.012345', 12_345, false],
    ['02:03.500', 123_500_000, false],
  ])('%s', (text, time, dated) => expect(clockTime(text)).toEqual({ time, dated }));

  it.each(['', 'abc', '12', '1:2'])('is not “%s”', (text) => expect(clockTime(text)).toBeUndefined());

  it('counts from the first without a date, over midnight', () => {
    const clock = new LogClock();
    expect(['23:59:59.500', undefined, '00:00:00.250', '00:00:01'].map((text) => clock.read(text))).toEqual([
      0,
      undefined,
      750_000,
      1_500_000,
    ]);
  });
});
