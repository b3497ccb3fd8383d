import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { compareFrames, MOST_COMPARED, type Run } from '../../../src/diagnosis/index.ts';
import type { DecodeContext } from '../../../src/modbus/index.ts';
import frames from '../../vectors/frames.json' with { type: 'json' };
import { bytes } from './compare.ts';

const context = fc.record<DecodeContext>({
  transport: fc.constantFrom('rtu', 'ascii', 'tcp', 'pdu'),
  direction: fc.constantFrom('request', 'response'),
});
const octets = fc.uint8Array({ maxLength: 40 });

/** Published frames with some bytes changed, left out or put in. */
const damaged = fc
  .record({
    frame: fc.constantFrom(...frames.slice(0, 400).map(({ hex }) => bytes(hex))),
    at: fc.nat(300),
    out: fc.nat(4),
    put: fc.uint8Array({ maxLength: 4 }),
  })
  .map(({ frame, at, out, put }) => {
    const from = at % (frame.length + 1);
    return [frame, Uint8Array.of(...frame.subarray(0, from), ...put, ...frame.subarray(from + out))] as const;
  });

const pairs = fc.oneof(damaged, fc.tuple(octets, octets));

/** Whether the runs go over all the compared bytes of a side, each once and in order. */
function covers(runs: readonly Run[], side: 'mine' | 'theirs', length: number): boolean {
  let at = 0;
  const joined = runs.every((run) => {
    const follows = run[`${side}From`] === at;
    at = run[`${side}To`];
    return follows;
  });
  return joined && at === Math.min(length, MOST_COMPARED);
}

function isTrue({ kind, mineFrom, mineTo, theirsFrom, theirsTo }: Run, mine: Uint8Array, theirs: Uint8Array): boolean {
  const [above, below] = [mine.slice(mineFrom, mineTo), theirs.slice(theirsFrom, theirsTo)];
  if (kind === 'only-mine') return above.length > 0 && below.length === 0;
  if (kind === 'only-theirs') return above.length === 0 && below.length > 0;
  const same = above.every((byte, index) => (byte === below[index]) === (kind === 'equal'));
  return same && above.length > 0 && above.length === below.length;
}

describe('any two frames', () => {
  test('every byte of either stands in one run, in order, and the run says the truth of it', () => {
    fc.assert(
      fc.property(pairs, context, ([mine, theirs], how) => {
        const { runs } = compareFrames(mine, theirs, how);
        expect(covers(runs, 'mine', mine.length)).toBe(true);
        expect(covers(runs, 'theirs', theirs.length)).toBe(true);
        expect(runs.filter((run) => !isTrue(run, mine, theirs))).toEqual([]);
      }),
    );
  });

  test('they are called identical if and only if they are equal, and else something is said', () => {
    fc.assert(
      fc.property(
        fc.oneof(
          pairs,
          octets.map((same) => [same, same.slice()] as const),
        ),
        context,
        ([mine, theirs], how) => {
          const { causes, differences } = compareFrames(mine, theirs, how);
          const equal = mine.length === theirs.length && mine.every((byte, at) => byte === theirs[at]);
          expect(causes.some(({ code }) => code === 'identical')).toBe(equal);
          expect(causes.length + differences.length).toBeGreaterThan(0);
        },
      ),
    );
  });

  test('every byte that is not equal is in a difference, where both are laid out alike', () => {
    fc.assert(
      fc.property(pairs, context, ([mine, theirs], how) => {
        const { runs, differences, causes } = compareFrames(mine, theirs, how);
        if (causes.some(({ code }) => LAID_OUT_OTHERWISE.has(code))) return;
        const inside = (run: Run) =>
          differences.some(
            (difference) =>
              (run.mineTo > run.mineFrom && within(run.mineFrom, run.mineTo, difference.mine)) ||
              (run.theirsTo > run.theirsFrom && within(run.theirsFrom, run.theirsTo, difference.theirs)),
          );
        expect(runs.filter((run) => run.kind !== 'equal' && !inside(run))).toEqual([]);
      }),
    );
  });
});

const LAID_OUT_OTHERWISE = new Set(['other-transport', 'other-direction', 'exception-instead', 'echo-of-request']);
const within = (from: number, to: number, place: { readonly from: number; readonly to: number } | undefined) =>
  place !== undefined && place.from <= from && to <= place.to;
