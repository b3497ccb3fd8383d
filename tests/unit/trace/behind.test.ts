import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { faultKinds, type Trace, type TraceInput, traceOf } from '../../../src/trace/index.ts';

const hex = (text: string) => Uint8Array.from(text.split(' '), (pair) => Number.parseInt(pair, 16));

const rtu = (bytes: string, side: 'request' | 'response') => ({ bytes: hex(bytes), side, transport: 'rtu' }) as const;
const tcp = (bytes: string, side: 'request' | 'response') => ({ bytes: hex(bytes), side, transport: 'tcp' }) as const;
/** AP 6.3: registers 108 to 110 are asked for, answered and refused. TG 3.1.3: the same on TCP, with the transactions 1 and 2. */
const FRAMES = {
  ask: rtu('11 03 00 6B 00 03 76 87', 'request'),
  other: rtu('06 03 02 A9 00 01 54 25', 'request'),
  broken: rtu('11 03 00 6B 00 03 76 88', 'request'),
  answer: rtu('11 03 06 02 2B 00 00 00 64 C8 BA', 'response'),
  refusal: rtu('11 83 02 C1 34', 'response'),
  damaged: rtu('11 03 06 02 2B 00 01 00 64 C8 BA', 'response'),
  echo: rtu('11 03 00 6B 00 03 76 87', 'response'),
  ask1: tcp('00 01 00 00 00 06 11 03 00 6B 00 03', 'request'),
  ask2: tcp('00 02 00 00 00 06 11 03 00 6B 00 03', 'request'),
  answer1: tcp('00 01 00 00 00 09 11 03 06 02 2B 00 00 00 64', 'response'),
  answer2: tcp('00 02 00 00 00 09 11 03 06 02 2B 00 00 00 64', 'response'),
} as const;
const names = Object.keys(FRAMES) as (keyof typeof FRAMES)[];

const anyRecord = fc.record({
  frame: fc.constantFrom(...names),
  /** Milliseconds since the one before. */
  pause: fc.constantFrom(5, 400, 1500),
  line: fc.constantFrom(undefined, 'COM2'),
  known: fc.constantFrom(undefined, undefined, 'late', 'noise', 'copy', 'echo', 'sure', 'silent'),
});
type AnyRecord = typeof anyRecord extends fc.Arbitrary<infer One> ? One : never;

/** Records whose times go on from one, in microseconds. */
function recordsOf(some: readonly AnyRecord[], from: number): TraceInput[] {
  let time = from;
  return some.map(({ frame, pause, line, known }) => {
    time += 1000 * pause;
    const { side } = FRAMES[frame];
    const isOutcome = known === 'sure' || known === 'silent';
    return {
      ...FRAMES[frame],
      time,
      from: line,
      known:
        known === undefined || isOutcome !== (side === 'request')
          ? undefined
          : isOutcome
            ? { outcome: known }
            : { beside: known },
    };
  });
}

const told = (trace: Trace) => ({
  summary: trace.summary(),
  pieces: trace.pieces,
  span: trace.span,
  exchanges: trace.exchanges(0, trace.exchangeCount),
  subjects: Array.from({ length: trace.exchangeCount }, (_, at) => trace.subject(at)),
  records: Array.from({ length: trace.size }, (_, at) => [trace.plain(at), trace.exchangeOf(at)]),
});

/** Exchanges in which nobody waits any more, an hour ago. */
const settled = (count: number): TraceInput[] =>
  Array.from({ length: count }, (_, at) => [
    { ...FRAMES.ask, time: 1000 * at },
    { ...FRAMES.answer, time: 1000 * at + 500 },
  ]).flat();
const HOUR = 3_600_000_000;

describe('a trace behind a record', () => {
  it('is that of the records from there on, where nothing was waited for, and goes on as that one', () => {
    const pieces = fc.tuple(fc.nat(3), fc.array(anyRecord, { maxLength: 12 }), fc.array(anyRecord, { maxLength: 6 }));
    fc.assert(
      fc.property(pieces, ([before, kept, later]) => {
        const gone = settled(before);
        const stays = recordsOf(kept, HOUR);
        const rest = traceOf([...gone, ...stays]).behind(gone.length);
        const anew = traceOf(stays);
        expect(told(rest)).toEqual(told(anew));
        for (const record of recordsOf(later, 2 * HOUR)) {
          rest.add(record);
          anew.add(record);
        }
        expect(told(rest)).toEqual(told(anew));
      }),
    );
  });

  it('has the records that stay as they were found, wherever it begins', () => {
    const log = fc.array(anyRecord, { minLength: 1, maxLength: 16 });
    fc.assert(
      fc.property(log, fc.nat(16), (some, at) => {
        const all = traceOf(recordsOf(some, 0));
        const first = at % all.size;
        const rest = all.behind(first);
        const stays = (records: readonly number[]) => records.filter((index) => index >= first);
        const back = (records: readonly number[]) => records.map((index) => index + first);
        for (let index = first; index < all.size; index++) {
          expect(rest.plain(index - first)).toEqual(all.plain(index));
          const [before, now] = [all.exchangeOf(index), rest.exchangeOf(index - first)];
          expect(rest.subject(now)).toEqual(all.subject(before));
          const [{ replies = [], request } = {}] = all.exchanges(before, before + 1);
          const [found] = rest.exchanges(now, now + 1);
          expect(back(found?.replies ?? [])).toEqual(stays(replies));
          if (request !== undefined && request >= first) expect(found?.request).toBe(request - first);
          const faults = all.faults(before).filter(({ records }) => (records.at(-1) ?? 0) >= first);
          expect(rest.faults(now).map(({ records, ...said }) => ({ ...said, records: back(records) }))).toEqual(
            faults.map(({ records, ...said }) => ({ ...said, records: stays(records) })),
          );
        }
        const count = (kind: string) =>
          rest.exchanges(0, rest.exchangeCount).flatMap(({ faults }) => faults.filter((fault) => fault.kind === kind))
            .length;
        expect(rest.summary().faults).toEqual(Object.fromEntries(faultKinds.map((kind) => [kind, count(kind)])));
      }),
    );
  });
});
