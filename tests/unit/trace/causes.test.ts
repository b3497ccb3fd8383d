import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { encodeFrame, type FrameInput } from '../../../src/modbus/index.ts';
import { causesOf, type TraceInput, type TraceOptions, traceOf } from '../../../src/trace/index.ts';

const frame = (input: Partial<FrameInput>): Uint8Array =>
  encodeFrame({ transport: 'rtu', direction: 'request', unitId: 1, functionCode: 3, fields: {}, ...input });
const ask = (startAddress = 0, quantity = 2, unitId = 1) => frame({ unitId, fields: { startAddress, quantity } });
const answer = (quantity = 2, unitId = 1) =>
  frame({ direction: 'response', unitId, fields: { registers: Array.from({ length: quantity }, (_, n) => 1000 + n) } });
const refuse = (unitId = 1) =>
  frame({ direction: 'response', unitId, functionCode: 0x83, fields: { exceptionCode: 2 } });
const damage = (bytes: Uint8Array) => bytes.with(2, (bytes[2] as number) ^ 0x10);

type Row = readonly [milliseconds: number, bytes: Uint8Array, side?: 'request' | 'response'];
const causes = (rows: readonly Row[], options?: TraceOptions) =>
  causesOf(
    traceOf(
      rows.map(
        ([milliseconds, bytes, side]): TraceInput => ({
          bytes,
          time: 1000 * milliseconds,
          ...(side && { side }),
          place: { kind: 'text', from: 0, to: 1 },
        }),
      ),
      options,
    ),
  );
const times = (count: number, rows: (n: number) => readonly Row[]): Row[] =>
  Array.from({ length: count }, (_, n) => rows(n)).flat();

describe('causes', () => {
  it('a unit that never answers', () => {
    const rows = times(5, (n) => [
      [n * 3000, ask(0, 2, 1), 'request'],
      [n * 3000 + 20, answer(2, 1), 'response'],
      [n * 3000 + 100, ask(0, 2, 17), 'request'],
    ]);
    expect(causes(rows)).toMatchObject([{ code: 'unit-silent', units: [17], kind: 'no-reply', explained: 5, all: 5 }]);
  });

  it('a time-out that is shorter than the slowest reply', () => {
    const rows = times(5, (n) => [
      [n * 3000, ask()],
      [n * 3000 + (n % 2 ? 20 : 1400 + n), answer(), 'response'],
    ]);
    expect(causes(rows)).toMatchObject([
      { code: 'timeout-short', slowest: 1_404_000, timeout: 1_000_000, explained: 3 },
    ]);
  });

  it('replies that come one too late from some exchange on', () => {
    const quantity = (n: number) => 1 + (n % 3);
    const rows = times(8, (n) => [
      [n * 1000, ask(10 * n, quantity(n)), 'request'],
      [n * 1000 + 20, answer(quantity(n < 3 ? n : n - 1)), 'response'],
    ]);
    expect(causes(rows)).toMatchObject([{ code: 'one-too-late', from: 3, kind: 'mismatch' }]);
  });

  it('a list of requests that has neither a time nor a reply is not a silent unit', () => {
    const list = [0, 4, 8, 12].map((from) => ({
      bytes: ask(from, 4),
      place: { kind: 'text', from: 0, to: 1 } as const,
    }));
    expect(causesOf(traceOf(list))).toEqual([]);
    const timed = list.map((record, n) => ({ ...record, time: n * 3_000_000 }));
    expect(causesOf(traceOf(timed))).toMatchObject([{ code: 'unit-silent', units: [1] }]);
  });

  it('addresses that a unit does not have, from some address on', () => {
    const rows = times(8, (n) => [
      [n * 1000, ask(10 * n, 10)],
      [n * 1000 + 20, n < 4 ? answer(10) : refuse(), 'response'],
    ]);
    expect(causes(rows)).toMatchObject([
      { code: 'addresses-end', unit: 1, functionCode: 3, answered: 40, kind: 'exception', explained: 4 },
    ]);
  });

  it('damage of one unit only, of two that speak alike', () => {
    const rows = times(40, (n) => {
      const unit = 1 + (n % 2);
      const reply = answer(4, unit);
      return [
        [n * 1000, ask(0, 4, unit), 'request'],
        [n * 1000 + 20, unit === 2 ? damage(reply) : reply, 'response'],
      ];
    });
    expect(causes(rows)).toMatchObject([{ code: 'unit-damaged', unit: 2, kind: 'checksum', explained: 20 }]);
  });

  it('damage of long frames only', () => {
    const rows = times(120, (n) => {
      const quantity = n % 4 === 0 ? 60 : 12;
      const reply = answer(quantity);
      return [
        [n * 1000, ask(0, quantity), 'request'],
        [n * 1000 + 20, quantity === 60 ? damage(reply) : reply, 'response'],
      ];
    });
    expect(causes(rows)).toMatchObject([{ code: 'long-frames-damaged', least: 125, kind: 'checksum', explained: 30 }]);
  });

  it('requests of two clients that overlap', () => {
    const rows = times(6, (n) => [
      [n * 1000, ask(0, 2, 1), 'request'],
      [n * 1000 + 4, ask(50, 2, 2), 'request'],
      [n * 1000 + 30, answer(2, 2), 'response'],
      [n * 1000 + 500, ask(0, 2, 1), 'request'],
      [n * 1000 + 530, answer(2, 1), 'response'],
    ]);
    expect(causes(rows)).toMatchObject([{ code: 'requests-overlap', shortest: 4000, kind: 'no-reply', explained: 6 }]);
  });

  it('an adapter that echoes', () => {
    const rows = times(4, (n) => [
      [n * 1000, ask(), 'request'],
      [n * 1000 + 3, ask(), 'response'],
      [n * 1000 + 30, answer(), 'response'],
    ]);
    expect(causes(rows)).toMatchObject([{ code: 'echo', kind: 'stray', explained: 4 }]);
  });

  it('polling that leaves no silence', () => {
    const line = { baud: 9600, bits: 11 };
    const rows = times(5, (n) => [
      [n * 40, ask(), 'request'],
      [n * 40 + 28.5, answer(), 'response'],
    ]);
    expect(causes(rows, { line })).toMatchObject([{ code: 'polled-too-fast', kind: 'timing', explained: 4 }]);
  });

  it('two faults are no pattern', () => {
    const rows = times(5, (n) => [
      [n * 3000, ask(0, 2, n > 2 ? 9 : 1), 'request'],
      ...(n > 2 ? [] : [[n * 3000 + 20, answer(), 'response'] as const]),
    ]);
    expect(causes(rows)).toEqual([]);
  });

  it('a clean log, and one that is damaged at random, have none', () => {
    const byChance = fc.record({
      quantity: fc.integer({ min: 1, max: 60 }),
      unit: fc.integer({ min: 1, max: 3 }),
      fate: fc.nat(99),
    });
    fc.assert(
      fc.property(fc.array(byChance, { minLength: 40, maxLength: 80 }), fc.boolean(), (list, isClean) => {
        const rows = list.flatMap(({ quantity, unit, fate }, n): Row[] => {
          const reply = answer(quantity, unit);
          // Damage of one byte in some hundred: the longer a frame, the likelier.
          const isHit = !isClean && fate < reply.length / 6;
          return [
            [n * 1000, ask(0, quantity, unit), 'request'],
            [n * 1000 + 20, isHit ? damage(reply) : reply, 'response'],
          ];
        });
        expect(causes(rows)).toEqual([]);
      }),
    );
  });

  it('nor one with requests that are damaged, not answered or refused at random', () => {
    const byChance = fc.record({
      address: fc.nat(200),
      quantity: fc.integer({ min: 1, max: 60 }),
      unit: fc.integer({ min: 1, max: 3 }),
      fate: fc.nat(99),
    });
    fc.assert(
      fc.property(
        fc.array(byChance, { minLength: 60, maxLength: 100 }),
        fc.integer({ min: 1, max: 10 }),
        (list, rate) => {
          const rows = list.flatMap(({ address, quantity, unit, fate }, n): Row[] => {
            const request = ask(address, quantity, unit);
            const at = n * 3000;
            if (fate < rate) return [[at, damage(request), 'request']];
            const asked: Row = [at, request, 'request'];
            if (fate < 2 * rate) return [asked];
            return [asked, [at + 20, fate < 3 * rate ? refuse(unit) : answer(quantity, unit), 'response']];
          });
          expect(causes(rows)).toEqual([]);
        },
      ),
    );
  });
});
