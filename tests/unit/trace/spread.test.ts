import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { Distribution } from '../../../src/trace/spread.ts';
import { Trace } from '../../../src/trace/trace.ts';

/** What a plain sort says of all numbers. */
function sorted(numbers: readonly number[]) {
  const all = [...numbers].sort((a, b) => a - b);
  const { length } = all;
  if (length === 0) return undefined;
  const half = Math.floor(length / 2);
  return {
    minimum: all[0],
    median: length % 2 === 1 ? all[half] : (all[half - 1]! + all[half]!) / 2,
    p95: all[Math.ceil(0.95 * length) - 1],
    maximum: all.at(-1),
  };
}

describe('the spread of numbers that become more', () => {
  it('is that of a plain sort, whenever it is asked for', () => {
    const number = fc.oneof(
      fc.nat(5),
      fc.nat(2_000_000),
      fc.double({ noNaN: true, noDefaultInfinity: true, min: -1e9, max: 1e9 }),
    );
    fc.assert(
      fc.property(fc.array(fc.array(number, { maxLength: 60 }), { maxLength: 30 }), (parts) => {
        const distribution = new Distribution();
        const all: number[] = [];
        for (const part of parts) {
          for (const one of part) distribution.add(one);
          all.push(...part);
          const expected = sorted(all);
          // −0 and 0 are the same time.
          if (expected === undefined) expect(distribution.spread).toBeUndefined();
          else
            for (const [name, value] of Object.entries(expected))
              expect(distribution.spread).toHaveProperty(name, value! + 0);
        }
      }),
    );
  });

  it('does not count what is not a number', () => {
    const distribution = new Distribution();
    distribution.add(Number.NaN);
    expect(distribution.spread).toBeUndefined();
    distribution.add(7);
    expect(distribution.spread).toEqual({ minimum: 7, median: 7, p95: 7, maximum: 7 });
  });

  it('takes the middle of two, and the number that 95 of 100 do not pass', () => {
    const distribution = new Distribution();
    for (let one = 100; one > 0; one--) distribution.add(one);
    expect(distribution.spread).toEqual({ minimum: 1, median: 50.5, p95: 95, maximum: 100 });
  });
});

describe('a summary that is asked for at each record', () => {
  // 11 03 00 6B 00 03 76 87: AP 6.3, with the unit of SL's example.
  const bytes = Uint8Array.of(0x11, 0x03, 0x00, 0x6b, 0x00, 0x03, 0x76, 0x87);

  it('counts what is not answered once the time-out has passed, or another request has come', () => {
    const trace = new Trace({ timeout: 100 });
    const silent = [];
    for (let index = 0; index < 4; index++) {
      trace.add({ bytes, side: 'request', time: 50_000 * index });
      silent.push(trace.summary().faults['no-reply']);
    }
    trace.add({ bytes, side: 'request', time: 10_000_000, from: 'another', to: 'line' });
    silent.push(trace.summary().faults['no-reply']);
    expect(silent).toEqual([0, 1, 2, 3, 4]);
  });
});
