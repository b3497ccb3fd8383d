import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { exchangeTimes, pollingTime, rtuSilences, type SerialLine } from '../../../../src/modbus/index.ts';

/** 11 bits a character: 1000 µs a character, t3.5 is 3500 µs. */
const line: SerialLine = { baud: 11_000, dataBits: 8, parity: 'even', stopBits: 1 };
const silences = rtuSilences(11_000, 11);
const exchange = { mode: 'rtu', line, silences, request: 8, reply: 7, delay: 0 } as const;

describe('an exchange', () => {
  it('has two frames and two silences in RTU', () => {
    expect(exchangeTimes(exchange)).toEqual({ request: 8000, pause: 3500, reply: 7000, after: 3500, total: 22_000 });
  });

  it('waits for the device where that takes longer than the silence', () => {
    expect(exchangeTimes({ ...exchange, delay: 3499 }).pause).toBe(3500);
    expect(exchangeTimes({ ...exchange, delay: 5000 })).toMatchObject({ pause: 5000, total: 23_500 });
  });

  it('waits for the turnaround alone after a broadcast (SL 2.4.1)', () => {
    expect(exchangeTimes({ ...exchange, reply: 0, delay: 100_000 })).toEqual({
      request: 8000,
      pause: 100_000,
      reply: 0,
      after: 0,
      total: 108_000,
    });
  });

  it('needs no silence in ASCII', () => {
    const ascii = exchangeTimes({ ...exchange, mode: 'ascii', request: 17, reply: 15 });
    expect(ascii).toEqual({ request: 17_000, pause: 0, reply: 15_000, after: 0, total: 32_000 });
  });

  it('of every device: a time-out for each that does not answer', () => {
    const times = exchangeTimes(exchange);
    expect(pollingTime({ exchange: times, devices: 10, missing: 0, timeout: 1_000_000 })).toBe(220_000);
    expect(pollingTime({ exchange: times, devices: 10, missing: 1, timeout: 1_000_000 })).toBe(1_206_000);
  });

  it('never grows shorter with more characters or a longer delay', () => {
    const sizes = fc.nat(513);
    fc.assert(
      fc.property(
        fc.constantFrom('rtu', 'ascii'),
        sizes,
        sizes,
        fc.nat(1e6),
        fc.nat(1e6),
        (mode, request, reply, delay, more) => {
          const { total } = exchangeTimes({ ...exchange, mode, request, reply, delay });
          expect(exchangeTimes({ ...exchange, mode, request: request + 1, reply, delay }).total).toBeCloseTo(
            total + 1000,
            6,
          );
          expect(exchangeTimes({ ...exchange, mode, request, reply: reply + 1, delay }).total).toBeGreaterThan(total);
          expect(
            exchangeTimes({ ...exchange, mode, request, reply, delay: delay + more }).total,
          ).toBeGreaterThanOrEqual(total);
        },
      ),
    );
  });
});
