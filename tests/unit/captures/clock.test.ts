import { describe, expect, it } from 'vitest';
import { type ClockTime, clockOf, clockTime, LogClock, printedTime } from '../../../src/captures/clock.ts';

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
  ])('%s', (text, time, dated) => expect(clockTime(text)).toMatchObject({ time, dated }));

  it.each<[string, Partial<ClockTime>]>([
    ['2023-11-14 22:13:20', {}],
    ['2023-11-14T22:13:20Z', { zone: 0 }],
    ['2023-11-14T22:13:20-05:30', { zone: -19_800_000_000 }],
    ['22:13:20', {}],
    ['12.5', { counts: true }],
  ])('%s: its zone, and whether it counts', (text, said) => {
    const { zone, counts } = clockTime(text) ?? {};
    expect({ ...(zone !== undefined && { zone }), ...(counts && { counts }) }).toEqual(said);
  });

  it.each(['', 'abc', '1:2'])('is not “%s”', (text) => expect(clockTime(text)).toBeUndefined());

  it('counts from the first without a date, over midnight', () => {
    const clock = new LogClock();
    const times = ['23:59:59.500', undefined, '00:00:00.250', '00:00:01'].map((text) => clock.read(text));
    expect(times.map((time) => (time === undefined ? undefined : clock.since(time)))).toEqual([
      0,
      undefined,
      750_000,
      1_500_000,
    ]);
    expect(clock.printed).toEqual({ shows: 'day', shift: 86_399_500_000 });
  });

  it('is of the day of the date before it, and of the next one past midnight', () => {
    const clock = new LogClock();
    const read = (text: string) => clock.since(clock.read(text) ?? Number.NaN);
    expect(['1970-01-02 23:59:58', '23:59:59', '00:00:01'].map(read)).toEqual([
      172_798_000_000, 172_799_000_000, 172_801_000_000,
    ]);
    expect(clock.printed).toEqual({ shows: 'date', shift: 0 });
  });
});

describe('a time as its clock prints it', () => {
  it.each([
    ['23:59:59.500000', 0],
    ['12.345678', 1000],
    ['2026-11-30T10:31:00.004000', 1_796_034_660_004_000],
    ['2026-11-30T10:31:00.004000+05:30', 1_796_014_860_004_000],
    ['2026-11-30T10:31:00.004000-02:00', 1_796_041_860_004_000],
    ['2026-11-30T10:31:00.004000+00:00', 1_796_034_660_004_000],
    ['2026-11-30T10:31:00.004000Z', 1_796_034_660_004_000],
  ])('%s', (text, time) => expect(printedTime(time, clockOf(text, time))).toBe(text));

  it('of a day is that of the next day past midnight', () => {
    expect(printedTime(1_000_000, { shows: 'day', shift: 86_399_500_000 })).toBe('00:00:00.500000');
  });
});
