import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import type { TraceInput } from '../../../src/trace/index.ts';
import { playedTrace } from './played-trace.ts';

const hex = (text: string) => Uint8Array.from(text.split(' '), (pair) => Number.parseInt(pair, 16));
/** AP 6.3: registers 108 to 110 of unit 17 are asked for, answered and refused; the reply with a bit changed, and another request. */
const FRAMES = {
  ask: { bytes: hex('11 03 00 6B 00 03 76 87'), side: 'request' },
  other: { bytes: hex('06 03 02 A9 00 01 54 25'), side: 'request' },
  answer: { bytes: hex('11 03 06 02 2B 00 00 00 64 C8 BA'), side: 'response' },
  refusal: { bytes: hex('11 83 02 C1 34'), side: 'response' },
  damaged: { bytes: hex('11 03 06 02 2B 00 01 00 64 C8 BA'), side: 'response' },
} as const;
const names = Object.keys(FRAMES) as (keyof typeof FRAMES)[];

const anyRecord = fc.record({
  frame: fc.constantFrom(...names),
  /** Milliseconds since the one before. */
  pause: fc.constantFrom(5, 400, 1500),
  known: fc.constantFrom(undefined, { beside: 'late' } as const),
});

/** Pieces as they are added, with times that go on. */
const anyPieces = fc
  .array(fc.array(anyRecord, { minLength: 1, maxLength: 12 }), { minLength: 1, maxLength: 8 })
  .map((pieces) => {
    let time = 0;
    return pieces.map((piece) =>
      piece.map(({ frame, pause, known }): TraceInput => {
        time += 1000 * pause;
        return { ...FRAMES[frame], time, known: FRAMES[frame].side === 'response' ? known : undefined };
      }),
    );
  });

describe('the rows of a trace that grows', () => {
  it('are those of the list as it is, whatever was seen of them before', () => {
    const shown = fc.record({
      by: fc.constantFrom('frame', 'exchange'),
      filter: fc.constantFrom('', 'fault', 'no-reply', 'unit:17', '-no-reply'),
      most: fc.constantFrom(undefined, 7),
    });
    fc.assert(
      fc.property(anyPieces, shown, (pieces, { by, filter, most }) => {
        const [seen, anew] = [playedTrace(), playedTrace()];
        for (const { view } of [seen, anew]) {
          view.setUnit(by);
          view.setFilter(filter);
        }
        for (const piece of pieces) {
          for (const { view, work } of [seen, anew]) {
            view.append(piece, most);
            work();
          }
          anew.view.setFilter(filter);
          anew.work();
          expect(seen.rows()).toEqual(anew.rows());
        }
      }),
      { numRuns: 40 },
    );
  });

  it('are asked for only where they may be others', () => {
    const { view, rows, work, workers } = playedTrace();
    const asked = () => workers.at(-1)?.tasks.flatMap((task) => (task.kind === 'rows' ? [task.from] : []));
    const { ask, answer } = FRAMES;
    view.append([
      { ...ask, time: 0 },
      { ...answer, time: 16_000 },
      { ...ask, time: 100_000 },
    ]);
    work();
    rows();
    view.append([{ ...answer, time: 116_000 }]);
    work();
    view.row(0);
    view.row(1);
    expect(asked()).toEqual([]);
    // The reply that has come changes its exchange from the request on.
    view.row(2);
    expect(asked()).toEqual([2]);
  });
});
