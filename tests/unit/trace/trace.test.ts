import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { type FaultKind, type TraceInput, traceOf } from '../../../src/trace/index.ts';

const hex = (text: string) => Uint8Array.from(text.match(/[0-9a-f]{2}/gi) ?? [], (pair) => Number.parseInt(pair, 16));
// Frames of AP 6.3 and AP 6.6 as RTU (SL 2.5.1.2), unit 1.
const ASK = '01 03 00 6B 00 03 74 17';
const ANSWER = '01 03 06 02 2B 00 00 00 64 05 7A';
const DAMAGED = '01 03 06 02 2B 00 01 00 64 05 7A';
const REFUSED = '01 83 02 C0 F1';
const WRITE = '01 06 00 01 00 03 98 0B';
const OTHER_UNIT = '02 03 06 02 2B 00 00 00 64 11 8A';
const ASK_TWO = '01 03 00 6B 00 02 B5 D7';
const ANSWER_TWO = '01 03 04 02 2B 00 00 8B 83';
const BROADCAST = '00 06 00 01 00 03 99 DA';

type Row = readonly [hex: string, milliseconds?: number | undefined, side?: 'request' | 'response'];
const rows = (...list: readonly Row[]): TraceInput[] =>
  list.map(([text, milliseconds, side]) => ({
    bytes: hex(text),
    ...(milliseconds !== undefined && { time: 1000 * milliseconds }),
    ...(side && { side }),
    place: { kind: 'text', from: 0, to: 1 },
  }));

const none: Record<FaultKind, number> = {
  exception: 0,
  checksum: 0,
  'no-reply': 0,
  late: 0,
  doubtful: 0,
  mismatch: 0,
  broken: 0,
  stray: 0,
  timing: 0,
};
const faults = (found: Partial<Record<FaultKind, number>>) => ({ ...none, ...found });

describe('exchanges', () => {
  it('pair a request with its reply', () => {
    const trace = traceOf(rows([ASK, 0], [ANSWER, 20], [WRITE, 100], [WRITE, 104]));
    expect(trace.exchanges(0, 9)).toEqual([
      { request: 0, replies: [1], after: 20_000, faults: [] },
      { request: 2, replies: [3], after: 4000, faults: [] },
    ]);
    expect(trace.summary()).toEqual({
      frames: 4,
      exchanges: 2,
      faults: none,
      units: [1],
      replyTime: { minimum: 4000, median: 12_000, p95: 20_000, maximum: 20_000 },
    });
  });

  it.each<[string, readonly Row[], Partial<Record<FaultKind, number>>]>([
    [
      'an exception',
      [
        [ASK, 0],
        [REFUSED, 20],
      ],
      { exception: 1 },
    ],
    [
      'a wrong CRC',
      [
        [ASK, 0],
        [DAMAGED, 20],
      ],
      { checksum: 1 },
    ],
    [
      'a wrong CRC of a request',
      [
        ['01 03 00 6B 00 03 74 18', 0, 'request'],
        [ASK, 500, 'request'],
        [ANSWER, 510],
      ],
      { checksum: 1 },
    ],
    [
      'silence',
      [
        [ASK, 0],
        [ASK, 2000],
        [ANSWER, 2020],
      ],
      { 'no-reply': 1 },
    ],
    [
      'silence at the end of a log',
      [
        [ASK, 0],
        [ANSWER, 20],
        [ASK, 500],
      ],
      { 'no-reply': 1 },
    ],
    [
      'silence without times',
      [
        [ASK, undefined, 'request'],
        [ASK, undefined, 'request'],
        [ANSWER, undefined, 'response'],
      ],
      { 'no-reply': 1 },
    ],
    [
      'a late reply',
      [
        [ASK, 0],
        [ANSWER, 1500, 'response'],
      ],
      { late: 1 },
    ],
    [
      'a late reply behind the next request',
      [
        [ASK, 0],
        [ASK_TWO, 1100],
        [ANSWER, 1150, 'response'],
        [ANSWER_TWO, 1160, 'response'],
      ],
      { late: 1 },
    ],
    [
      'a reply of another unit',
      [
        [ASK, 0],
        [OTHER_UNIT, 20, 'response'],
      ],
      { mismatch: 1 },
    ],
    [
      'a reply that is cut',
      [
        [ASK, 0],
        ['01 03 06 02 2B', 20, 'response'],
      ],
      { broken: 1 },
    ],
    ['a reply without a request', [[ANSWER, 0]], { stray: 1 }],
    [
      'a second reply',
      [
        [ASK, 0],
        [ANSWER, 20],
        [ANSWER, 25],
      ],
      { stray: 1 },
    ],
    [
      'an echo',
      [
        [ASK, 0, 'request'],
        [ASK, 5, 'response'],
        [ANSWER, 20, 'response'],
      ],
      { stray: 1 },
    ],
    [
      'no reply to a broadcast',
      [
        [BROADCAST, 0],
        [ASK, 200],
        [ANSWER, 210],
      ],
      {},
    ],
  ])('show %s', (_name, list, expected) => {
    expect(traceOf(rows(...list)).summary().faults).toEqual(faults(expected));
  });

  it('doubt a reply that fits the request before as well', () => {
    const ask = '01 03 00 6C 00 03 C5 D6';
    const trace = traceOf(rows([ASK, 0], [ask, 1100], [ANSWER, 1105]));
    expect(trace.summary().faults).toEqual(faults({ 'no-reply': 1, doubtful: 1 }));
    expect(trace.exchanges(1, 2)[0]?.faults).toEqual([
      { kind: 'doubtful', code: 'may-answer-the-request-before', records: [0, 2] },
    ]);
  });

  it('of what is heard just now wait for the reply as long as the time-out', () => {
    const live = (text: string, milliseconds: number): TraceInput => ({ bytes: hex(text), time: 1000 * milliseconds });
    const trace = traceOf([live(ASK, 0), live(ANSWER, 20), live(ASK, 500)]);
    expect(trace.summary().faults).toEqual(none);
    trace.add(live(ASK, 1600));
    expect(trace.summary().faults).toEqual(faults({ 'no-reply': 1 }));
    expect(trace.exchanges(1, 2)[0]?.faults).toEqual([{ kind: 'no-reply', code: 'no-reply', records: [2] }]);
  });

  it('of TCP are paired by connection and transaction, in any order', () => {
    const adu = (transaction: string, pdu: string, from: string, to: string): TraceInput => ({
      bytes: hex(`${transaction} 00 00 00 06 01 ${pdu}`),
      from,
      to,
    });
    const read = '03 00 6B 00 03';
    const reply = (transaction: string, from: string, to: string): TraceInput => ({
      bytes: hex(`${transaction} 00 00 00 09 01 03 06 02 2B 00 00 00 64`),
      from,
      to,
    });
    const trace = traceOf([
      adu('00 01', read, 'a', 's'),
      adu('00 02', read, 'a', 's'),
      adu('00 01', read, 'b', 's'),
      reply('00 02', 's', 'a'),
      reply('00 01', 's', 'b'),
      reply('00 01', 's', 'a'),
    ]);
    expect(trace.exchanges(0, 3).map(({ request, replies }) => [request, ...replies])).toEqual([
      [0, 5],
      [1, 3],
      [2, 4],
    ]);
    expect(trace.summary().faults).toEqual(none);
  });

  it('of TCP whose server counts transactions itself are a mismatch, and no other request is answered by them', () => {
    const ask = (transaction: string) => ({
      bytes: hex(`${transaction} 00 00 00 06 01 03 00 6B 00 03`),
      from: 'a',
      to: 's',
    });
    const reply = (transaction: string, pdu = '09 01 03 06 02 2B 00 00 00 64') => ({
      bytes: hex(`${transaction} 00 00 00 ${pdu}`),
      from: 's',
      to: 'a',
    });
    const counted = traceOf([ask('00 00'), reply('00 07'), ask('00 00'), reply('00 08')]);
    expect(counted.summary().faults).toEqual(faults({ mismatch: 2 }));
    const other = traceOf([ask('00 01'), reply('00 07', '07 01 03 04 02 2B 00 00'), reply('00 01')]);
    expect(other.summary().faults).toEqual(faults({ stray: 1 }));
    // A client that counts on, and a server that counts from 1.
    const own = traceOf(
      ['05', '06', '07', '08', '09'].flatMap((asked, n) => [ask(`00 ${asked}`), reply(`00 0${n + 1}`)]),
    );
    expect(own.summary().faults).toEqual(faults({ mismatch: 5 }));
  });

  it('of TCP are answered by the reply of their transaction, though one of another came before', () => {
    const at = (text: string, time: number, from: string, to: string) => ({ bytes: hex(text), time, from, to });
    const request = at('00 02 00 00 00 06 01 03 00 6B 00 03', 0, 'a', 's');
    const reply = (transaction: string, time: number) =>
      at(`${transaction} 00 00 00 09 01 03 06 02 2B 00 00 00 64`, time, 's', 'a');
    const trace = traceOf([request, reply('00 4D', 5000), reply('00 02', 9000)]);
    expect(trace.exchanges(0, 2)).toMatchObject([
      { request: 0, replies: [2, 1], after: 9000, faults: [{ kind: 'mismatch', records: [1] }] },
    ]);
    expect(trace.exchangeCount).toBe(1);
    // What comes behind it is asked for by nobody.
    trace.add(reply('00 02', 9500));
    expect(trace.exchanges(1, 2)).toMatchObject([{ replies: [3], faults: [{ kind: 'stray' }] }]);
  });

  it('judge the silence between frames where the speed is known (SL 2.5.1.1)', () => {
    // 8 characters of 11 bits at 9600 baud last 9.167 ms, t3.5 is 4.01 ms.
    const line = { baud: 9600, bits: 11 };
    const trace = (gap: number) => traceOf(rows([ASK, 0], [ANSWER, 9.1667 + gap]), { line }).summary().faults;
    expect(trace(4.2)).toEqual(none);
    expect(trace(3)).toEqual(faults({ timing: 1 }));
    expect(traceOf(rows([ASK, 0], [ANSWER, 12])).summary().faults).toEqual(none);
  });
});

describe('records', () => {
  it('come back as they were given, with what is found in them', () => {
    const source = hex(`${ASK} ${ANSWER}`);
    const trace = traceOf([
      { bytes: source.subarray(0, 8), time: 5, from: 'a', to: 'b', place: { kind: 'packet', numbers: [3, 4] } },
      { bytes: source.subarray(8), place: { kind: 'bytes', from: 8, to: 19 } },
    ]);
    expect(trace.record(0)).toMatchObject({
      bytes: hex(ASK),
      time: 5,
      side: 'request',
      transport: 'rtu',
      from: 'a',
      to: 'b',
      place: { kind: 'packet', numbers: [3, 4] },
    });
    expect(trace.record(1)).toMatchObject({
      bytes: hex(ANSWER),
      side: 'response',
      place: { kind: 'bytes', from: 8, to: 19 },
    });
    expect(trace.record(1).findings[0]?.code).toBe('valid');
    expect(() => trace.record(2)).toThrow(RangeError);
  });

  it('say why a frame fails, as the diagnosis does', () => {
    const trace = traceOf(rows([ASK, 0], [DAMAGED, 20]));
    expect(trace.record(1).findings[0]).toMatchObject({ code: 'bit-error' });
  });
});

describe('any records', () => {
  const frames = [ASK, ANSWER, DAMAGED, REFUSED, WRITE, OTHER_UNIT, ASK_TWO, ANSWER_TWO, BROADCAST].map(hex);
  const input = fc.record(
    {
      bytes: fc.oneof(fc.constantFrom(...frames), fc.uint8Array({ maxLength: 20 })),
      time: fc.nat(10_000_000),
      side: fc.constantFrom('request' as const, 'response' as const),
      transport: fc.constantFrom('rtu' as const, 'tcp' as const, 'ascii' as const),
    },
    { requiredKeys: ['bytes'] },
  );

  it('are each in one exchange, and nothing is counted twice', () => {
    fc.assert(
      fc.property(fc.array(input, { maxLength: 30 }), (inputs) => {
        const trace = traceOf(inputs);
        const exchanges = trace.exchanges(0, inputs.length + 1);
        const seen = exchanges.flatMap(({ request, replies }) =>
          request === undefined ? replies : [request, ...replies],
        );
        expect(seen.sort((a, b) => a - b)).toEqual(inputs.map((_, index) => index));
        const { faults: counted, frames: size } = trace.summary();
        expect(size).toBe(inputs.length);
        const each = exchanges.flatMap(({ faults: list }) => list.map(({ kind }) => kind));
        for (const kind of Object.keys(none) as FaultKind[]) {
          expect(each.filter((one) => one === kind)).toHaveLength(counted[kind]);
        }
      }),
    );
  });

  it('give the same one by one and at once', () => {
    fc.assert(
      fc.property(fc.array(input, { maxLength: 20 }), (inputs) => {
        const trace = traceOf([]);
        for (const one of inputs) {
          trace.add(one);
          trace.summary();
        }
        expect(trace.exchanges(0, 99)).toEqual(traceOf(inputs).exchanges(0, 99));
      }),
    );
  });
});
