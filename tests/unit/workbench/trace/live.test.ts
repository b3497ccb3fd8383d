import { describe, expect, it } from 'vitest';
import type { TraceInput } from '../../../../src/trace/index.ts';
import { type TraceAnswer, TraceDesk, type TraceTask } from '../../../../src/workbench/index.ts';

const hex = (text: string) => Uint8Array.from(text.match(/[0-9a-f]{2}/gi) ?? [], (pair) => Number.parseInt(pair, 16));
// AP 6.3: registers 108 to 110 of unit 17 are asked for and answered.
const ASK = hex('11 03 00 6B 00 03 76 87');
const ANSWER = hex('11 03 06 02 2B 00 00 00 64 C8 BA');

/** Exchanges from this one on, a second apart, each answered after 16 ms. */
const exchanges = (from: number, count: number): TraceInput[] =>
  Array.from({ length: count }, (_, at) => [
    { bytes: ASK, time: 1_000_000 * (from + at), side: 'request' as const },
    { bytes: ANSWER, time: 1_000_000 * (from + at) + 16_000, side: 'response' as const },
  ]).flat();

/** A desk, and what it has said last of each kind. */
function setUp() {
  const said = new Map<string, TraceAnswer>();
  const desk = new TraceDesk(
    (answer) => said.set(answer.kind, answer),
    (act) => act(),
  );
  const last = <K extends TraceAnswer['kind']>(kind: K) => said.get(kind) as Extract<TraceAnswer, { kind: K }>;
  const take = (...tasks: Exclude<TraceTask, { kind: 'open' }>[]) => {
    for (const task of tasks) desk.take(task);
  };
  take({ kind: 'filter', text: '', by: 'frame', list: 1 });
  return { last, take };
}

describe('a trace that grows without an end', () => {
  it('keeps its last records, from a request on, and says how many are gone', () => {
    const { last, take } = setUp();
    take({ kind: 'append', records: exchanges(0, 10), most: 11 });
    expect(last('grown').gone).toEqual({ frame: 0, exchange: 0 });
    expect(last('list').count).toBe(20);
    take({ kind: 'frame', row: 19 }, { kind: 'append', records: exchanges(10, 2), most: 11 });
    // 24 are more than twice 11: 11 would begin with a reply, so that its request stays, too.
    expect(last('grown')).toMatchObject({ gone: { frame: 12, exchange: 6 }, summary: { frames: 12, exchanges: 6 } });
    expect(last('grown').summary.faults.stray).toBe(0);
    expect([last('list').count, last('list').chosen]).toEqual([12, 7]);
    take({ kind: 'rows', from: 0, to: 2 });
    expect(last('rows').rows.map(({ time, after }) => [time, after])).toEqual([
      [6_000_000, undefined],
      [6_016_000, 16_000],
    ]);
    take({ kind: 'append', records: exchanges(12, 6), most: 11 });
    expect(last('grown').gone).toEqual({ frame: 24, exchange: 12 });
    expect(last('list').chosen).toBeUndefined();
    take({ kind: 'clear' });
    expect(last('grown')).toMatchObject({ gone: { frame: 0, exchange: 0 }, summary: { frames: 0 } });
  });

  it('looks again at an old request whose time-out has passed', () => {
    const { last, take } = setUp();
    take({ kind: 'filter', text: 'no-reply', by: 'frame', list: 2 });
    const asked = { bytes: ASK, time: 0, side: 'request', from: 'COM2' } as const;
    // 300 exchanges on another line within its time-out.
    const others = exchanges(0, 300).map((one, at) => ({ ...one, time: 1000 * at }));
    take({ kind: 'append', records: [asked, ...others], most: undefined });
    expect([last('list').count, last('grown').summary.faults['no-reply']]).toEqual([0, 0]);
    take({ kind: 'append', records: exchanges(5, 1), most: undefined });
    expect([last('list').count, last('grown').summary.faults['no-reply']]).toEqual([1, 1]);
  });

  it('keeps all where nobody says how many, and knows what its source knew of those that stay', () => {
    const { last, take } = setUp();
    take({ kind: 'append', records: exchanges(0, 500), most: undefined });
    expect(last('grown').gone.frame).toBe(0);
    const silent = { ...exchanges(500, 1)[0], bytes: ASK, known: { outcome: 'silent' } } as const;
    take({ kind: 'append', records: [silent], most: 2 });
    expect(last('grown').summary).toMatchObject({ frames: 3, faults: { 'no-reply': 1 } });
  });
});
