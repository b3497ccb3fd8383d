import { describe, expect, it } from 'vitest';
import { gapReading, silenceReadings } from '../../../../src/workbench/timing/line-silences.ts';
import { timingLine } from '../../../../src/workbench/timing/timing-entries.ts';
import { firstTimingTexts } from '../../../../src/workbench/timing/timing-texts.ts';

const lineOf = (baud: number, format: string, counted: 'format' | '11' = 'format') =>
  timingLine({ ...firstTimingTexts, baud: String(baud), format, counted })!;
const readings = (...of: Parameters<typeof lineOf>) =>
  silenceReadings(lineOf(...of)).map(({ bits, t15, t35, inForce }) => [
    bits,
    Math.round(t15),
    Math.round(t35),
    inForce,
  ]);

describe('the silences of a line', () => {
  it('are counted by the bits of the format and by 11: at 9600 baud 8N1, t3.5 is 3.646 or 4.010 ms', () => {
    expect(readings(9600, '8N1')).toEqual([
      [10, 1563, 3646, true],
      [11, 1719, 4010, false],
    ]);
    expect(readings(9600, '8N1', '11')).toEqual([
      [10, 1563, 3646, false],
      [11, 1719, 4010, true],
    ]);
    expect(readings(9600, '8E1')).toEqual([[11, 1719, 4010, true]]);
  });

  it('are fixed above 19200 baud, whatever is counted (SL 2.5.1.1)', () => {
    expect(readings(19_200, '8E1')).toEqual([[11, 859, 2005, true]]);
    expect(readings(38_400, '8E1')).toEqual([
      [11, 430, 1003, false],
      [undefined, 750, 1750, true],
    ]);
  });
});

describe('a gap inside a frame', () => {
  // Counted with 11 bits, t1.5 is 1719 µs and t3.5 4010 µs; with 10 bits 1563 µs and 3646 µs.
  it.each([
    [1500, 'whole', undefined],
    [1600, 'whole', { bits: 10, effect: 'discarded' }],
    [2000, 'discarded', undefined],
    [3800, 'discarded', { bits: 10, effect: 'two-frames' }],
    [4100, 'two-frames', undefined],
  ])('of %d µs at 9600 baud 8N1', (gap, effect, other) => {
    expect(gapReading(gap, lineOf(9600, '8N1', '11'))).toEqual({ effect, other });
  });

  it('is read by receivers that count 11 bits, where the line counts 10', () => {
    expect(gapReading(1600, lineOf(9600, '8N1'))).toEqual({
      effect: 'discarded',
      other: { bits: 11, effect: 'whole' },
    });
  });

  it('is read by receivers that count all the same above 19200 baud', () => {
    // Fixed: 750 and 1750 µs; counted with 11 bits: 430 and 1003 µs.
    expect(gapReading(1100, lineOf(38_400, '8E1'))).toEqual({
      effect: 'discarded',
      other: { bits: 11, effect: 'two-frames' },
    });
    expect(gapReading(400, lineOf(38_400, '8E1'))).toEqual({ effect: 'whole', other: undefined });
  });
});
