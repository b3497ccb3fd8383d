import { describe, expect, it } from 'vitest';
import { KnownValues, type TraceInput, TraceStatistics, traceOf } from '../../../src/trace/index.ts';

const hex = (text: string) => Uint8Array.from(text.match(/[0-9a-f]{2}/gi) ?? [], (pair) => Number.parseInt(pair, 16));
const row = (milliseconds: number, text: string): TraceInput => ({
  bytes: hex(text),
  time: 1000 * milliseconds,
  place: { kind: 'text', from: 0, to: 1 },
});

// Unit 1: reads 107 to 109 (AP 6.3), writes 1 (AP 6.6), is refused once; unit 17 is silent.
const log = [
  row(0, '01 03 00 6B 00 03 74 17'),
  row(10, '01 03 06 02 2B 00 00 00 64 05 7A'),
  row(1000, '01 03 00 6B 00 03 74 17'),
  row(1030, '01 83 02 C0 F1'),
  row(2000, '01 06 00 01 00 03 98 0B'),
  row(2004, '01 06 00 01 00 03 98 0B'),
  row(3000, '11 03 00 6B 00 03 76 87'),
  row(5000, '01 03 00 6B 00 03 74 17'),
  row(5020, '01 03 06 02 2B 00 01 00 64 54 BA'),
];

describe('statistics', () => {
  const statistics = new TraceStatistics(traceOf(log)).take();

  it('count by unit', () => {
    expect(statistics.by('unit')).toMatchObject([
      {
        unit: 1,
        exchanges: 4,
        replies: 4,
        faults: { exception: 1, 'no-reply': 0 },
        exceptions: new Map([[2, 1]]),
        replyTime: { minimum: 4000, median: 15_000, p95: 30_000, maximum: 30_000 },
      },
      { unit: 17, exchanges: 1, replies: 0, faults: { 'no-reply': 1 }, replyTime: undefined },
    ]);
  });

  it('count by function and by address', () => {
    expect(statistics.by('function').map(({ functionCode, exchanges }) => [functionCode, exchanges])).toEqual([
      [3, 4],
      [6, 1],
    ]);
    expect(
      statistics
        .by('address')
        .map(({ unit, functionCode, address, exchanges }) => [unit, functionCode, address, exchanges]),
    ).toEqual([
      [1, 3, 107, 3],
      [1, 6, 1, 1],
      [17, 3, 107, 1],
    ]);
  });

  it('tell how often the same is asked', () => {
    expect(statistics.by('poll')[0]).toMatchObject({
      unit: 1,
      address: 107,
      quantity: 3,
      exchanges: 3,
      interval: { minimum: 1_000_000, median: 2_500_000, maximum: 4_000_000 },
    });
  });

  it('go on where they stopped', () => {
    const trace = traceOf(log.slice(0, 4));
    const growing = new TraceStatistics(trace).take();
    for (const one of log.slice(4)) trace.add(one);
    expect(growing.take().by('unit')).toEqual(statistics.by('unit'));
  });
});

describe('what became known', () => {
  it('are the registers that were read and written, with their changes', () => {
    expect(new KnownValues(traceOf(log)).take().list).toEqual([
      {
        unit: 1,
        table: 'holding-register',
        address: 1,
        value: 3,
        time: 2_004_000,
        record: 5,
        reads: 0,
        writes: 1,
        changes: 0,
      },
      {
        unit: 1,
        table: 'holding-register',
        address: 107,
        value: 0x022b,
        time: 5_020_000,
        record: 8,
        reads: 2,
        writes: 0,
        changes: 0,
      },
      {
        unit: 1,
        table: 'holding-register',
        address: 108,
        value: 1,
        time: 5_020_000,
        record: 8,
        reads: 2,
        writes: 0,
        changes: 1,
      },
      {
        unit: 1,
        table: 'holding-register',
        address: 109,
        value: 100,
        time: 5_020_000,
        record: 8,
        reads: 2,
        writes: 0,
        changes: 0,
      },
    ]);
  });

  it('are bits without their padding, coils that are set, and both lists of function 17', () => {
    const known = (...texts: readonly string[]) =>
      new KnownValues(traceOf(texts.map((text, index) => row(index, text))))
        .take()
        .list.map(({ table, address, value, reads, writes }) => [table, address, value, reads, writes]);
    // AP 6.1: coils 20 to 22 of its example; AP 6.5: coil 173 on.
    expect(known('01 01 00 13 00 03 8D CE', '01 01 01 05 91 8B')).toEqual([
      ['coil', 19, 1, 1, 0],
      ['coil', 20, 0, 1, 0],
      ['coil', 21, 1, 1, 0],
    ]);
    expect(known('01 05 00 AC FF 00 4C 1B', '01 05 00 AC FF 00 4C 1B')).toEqual([['coil', 172, 1, 0, 1]]);
    expect(known('01 17 00 03 00 01 00 0E 00 01 02 00 FF E5 CF', '01 17 02 00 FE 3C 34')).toEqual([
      ['holding-register', 3, 0xfe, 1, 0],
      ['holding-register', 14, 0xff, 0, 1],
    ]);
  });
});
