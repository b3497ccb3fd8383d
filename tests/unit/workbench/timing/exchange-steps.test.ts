import { describe, expect, it } from 'vitest';
import { timedExchange } from '../../../../src/workbench/timing/exchange-steps.ts';
import { timingLine } from '../../../../src/workbench/timing/timing-entries.ts';
import { firstTimingTexts } from '../../../../src/workbench/timing/timing-texts.ts';

// 9600 8N1, silences counted with 11 bits: a character is 1041.67 µs, t3.5 is 38.5 bits, 4010.42 µs.
const line = timingLine({ ...firstTimingTexts, baud: '9600', format: '8N1', counted: '11' })!;
const exchange = (parts: object) => timedExchange({ line, mode: 'rtu', request: 8, reply: 11, delay: 0, ...parts });
const shown = (parts: object) =>
  exchange(parts).steps.map(({ kind, time, silent }) => [kind, Math.round(time), silent]);

describe('the steps of an exchange', () => {
  it('are request, silence, reply and silence: 267 bits at 9600 baud', () => {
    expect(shown({})).toEqual([
      ['request', 8333, false],
      ['silence-and-answer', 4010, true],
      ['reply', 11_458, false],
      ['silence', 4010, true],
    ]);
    const { times, silent } = exchange({});
    expect(times.total).toBeCloseTo(27_812.5, 3);
    // 77 of 267 bits.
    expect(silent).toBeCloseTo(0.28839, 5);
  });

  it('wait for a device that answers after t3.5', () => {
    expect(shown({ delay: 10_000 })[1]).toEqual(['answer', 10_000, true]);
    // A delay of exactly t3.5 is no longer than the silence.
    expect(shown({ delay: line.silences.t35 })[1]).toEqual(['silence-and-answer', 4010, true]);
    expect(shown({ delay: line.silences.t35 + 1 })[1]).toEqual(['answer', 4011, true]);
  });

  it('end with the turnaround if nobody answers', () => {
    expect(shown({ reply: 0, delay: 100_000 })).toEqual([
      ['request', 8333, false],
      ['turnaround', 100_000, true],
    ]);
  });

  it('have no silence in ASCII', () => {
    expect(shown({ mode: 'ascii', request: 17, reply: 23 })).toEqual([
      ['request', 17_708, false],
      ['answer', 0, true],
      ['reply', 23_958, false],
    ]);
  });
});
