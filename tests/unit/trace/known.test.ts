import { describe, expect, it } from 'vitest';
import { readCapture, writeTraceJson } from '../../../src/captures/index.ts';
import { type Known, knownOf, type TraceInput, traceOf } from '../../../src/trace/index.ts';

const hex = (text: string) => Uint8Array.from(text.match(/[0-9a-f]{2}/gi) ?? [], (pair) => Number.parseInt(pair, 16));
// Frames of AP 6.3 as RTU (SL 2.5.1.2), unit 1.
const ASK = '01 03 00 6B 00 03 74 17';
const ANSWER = '01 03 06 02 2B 00 00 00 64 05 7A';
const ASK_TWO = '01 03 00 6B 00 02 B5 D7';
const ANSWER_TWO = '01 03 04 02 2B 00 00 8B 83';

const record = (text: string, milliseconds: number, side: 'request' | 'response', known?: Known): TraceInput => ({
  bytes: hex(text),
  time: 1000 * milliseconds,
  side,
  transport: 'rtu',
  known,
});
const ask = (milliseconds: number, known?: Known, text = ASK) => record(text, milliseconds, 'request', known);
const answer = (milliseconds: number, known?: Known, text = ANSWER) => record(text, milliseconds, 'response', known);
const kindsOf = (...records: readonly TraceInput[]) => {
  const trace = traceOf(records);
  return trace
    .exchanges(0, 99)
    .map(({ request, replies, faults }) => [request, replies, faults.map(({ kind, code }) => `${kind} ${code}`)]);
};

describe('what the source of a record knows', () => {
  it('of a request: a reply that was waited for is not late, and one that is not due is not missed', () => {
    expect(kindsOf(ask(0, { outcome: 'sure' }), answer(2500))).toEqual([[0, [1], []]]);
    expect(kindsOf(ask(0), answer(2500))).toEqual([[0, [1], ['late late']]]);
    const end = ask(9000, { outcome: 'sure' });
    for (const outcome of ['sure', 'absent', 'ended'] as const)
      expect(kindsOf(ask(0, { outcome }), end)).toEqual([
        [0, [], []],
        [1, [], []],
      ]);
    expect(kindsOf(ask(0), end)).toEqual([
      [0, [], ['no-reply no-reply']],
      [1, [], []],
    ]);
  });

  it('of a request: nobody waits for its reply any longer, though nothing has followed it', () => {
    expect(kindsOf(ask(0))).toEqual([[0, [], []]]);
    const given = ask(0, { outcome: 'silent' });
    expect(kindsOf(given)).toEqual([[0, [], ['no-reply no-reply']]]);
    expect(traceOf([given]).summary().faults['no-reply']).toBe(1);
    expect(kindsOf(given, answer(300, { beside: 'late' }))).toEqual([[0, [1], ['late late']]]);
  });

  it('of a request: its reply is unsure, even where its bytes do not tell; or sure, where they might', () => {
    expect(kindsOf(ask(0, { outcome: 'doubtful' }), answer(9))).toEqual([[0, [1], ['doubtful unsure']]]);
    const again = '01 03 00 00 00 03 05 CB';
    const bytesOnly = kindsOf(ask(0, undefined, again), ask(1200), answer(1209));
    expect(bytesOnly[1]).toEqual([1, [2], ['doubtful may-answer-the-request-before']]);
    expect(kindsOf(ask(0, undefined, again), ask(1200, { outcome: 'sure' }), answer(1209))[1]).toEqual([1, [2], []]);
  });

  it('of bytes beside the replies: the request goes on waiting', () => {
    const noise = record('FF 00', 3, 'response', { beside: 'noise' });
    const copy = answer(4, { beside: 'copy' });
    const other = record('02 03 06 02 2B 00 00 00 64 11 8A', 5, 'response', { beside: 'other' });
    expect(kindsOf(ask(0, { outcome: 'sure' }), noise, copy, other, answer(9))).toEqual([
      [0, [4], []],
      [undefined, [1], ['broken noise']],
      [undefined, [2], ['stray copy']],
      [undefined, [3], ['stray other']],
    ]);
  });

  it('of an echo: it is not a fault, and not the reply', () => {
    const trace = traceOf([ask(0, { outcome: 'sure' }), ask(1, { beside: 'echo' }), answer(9)]);
    expect(trace.exchanges(0, 9)).toEqual([{ request: 0, replies: [2], after: 9000, faults: [] }]);
    expect([trace.exchangeOf(1), trace.known(1), trace.known(2)]).toEqual([0, { beside: 'echo' }, undefined]);
    expect(kindsOf(ask(1, { beside: 'echo' }))).toEqual([[0, [], []]]);
  });

  it('of a late reply: it belongs to the request that was given up, or to none', () => {
    const given = ask(0, undefined, ASK_TWO);
    const late = answer(300, { beside: 'late' }, ANSWER_TWO);
    expect(kindsOf(given, ask(250, { outcome: 'sure' }), late, answer(310))).toEqual([
      [0, [2], ['late late']],
      [1, [3], []],
    ]);
    expect(kindsOf(given, late)).toEqual([[0, [1], ['late late']]]);
    expect(kindsOf(late)).toEqual([[undefined, [0], ['late late']]]);
    // Of two requests that are the same, the one that was given up.
    expect(kindsOf(ask(0), ask(250, { outcome: 'sure' }), answer(300, { beside: 'late' }), answer(310))).toEqual([
      [0, [2], ['late late']],
      [1, [3], []],
    ]);
  });

  it('is in the log of the bus by kind and verdict, and kept in files', () => {
    expect(knownOf('request', 'doubtful')).toEqual({ outcome: 'doubtful' });
    expect(knownOf('request', 'silent')).toEqual({ outcome: 'silent' });
    expect(['refused', 'bad'].map((verdict) => knownOf('request', verdict)?.outcome)).toEqual(['sure', 'sure']);
    expect(knownOf('request', undefined)).toBeUndefined();
    expect(knownOf('heard', 'good')).toBeUndefined();
    expect(knownOf('late', undefined)).toEqual({ beside: 'late' });
    const all = [ask(0, { outcome: 'absent' }), answer(9, { beside: 'copy' })];
    const trace = traceOf(all);
    const text = writeTraceJson([trace.plain(0), trace.plain(1)]);
    const read = readCapture(new TextEncoder().encode(text)).records;
    expect(Array.from(read, ({ known }) => known)).toEqual([{ outcome: 'absent' }, { beside: 'copy' }]);
    const log = {
      format: 'framewright log',
      version: 1,
      lines: [
        { time: 1, direction: 'sent', transport: 'rtu', kind: 'request', hex: '1103006B00037687', verdict: 'ended' },
        { time: 2, direction: 'received', transport: 'rtu', kind: 'noise', hex: 'FF00' },
      ],
    };
    const old = readCapture(new TextEncoder().encode(JSON.stringify(log))).records;
    expect(Array.from(old, ({ known }) => known)).toEqual([{ outcome: 'ended' }, { beside: 'noise' }]);
  });
});
