import { expect, test } from 'vitest';
import { type Case, fourReads, type Kind, kinds, missed, tallyOf } from './late-line.ts';

const TIMEOUT = 200;

const tally = (kind: Kind, one: Pick<Case, 'interval' | 'held'>, retries = 0) =>
  tallyOf({ ...kind, ...one, rules: { timeout: TIMEOUT, retries } }, 200, 7);

test.each(kinds)('$name: nothing wrong is shown as good, whatever the interval and the retries', async (kind) => {
  for (const interval of [0, 1000]) {
    for (const retries of [0, 2]) expect(missed(kind, await tally(kind, { interval }, retries))).toEqual([]);
  }
});

test.each(kinds.filter(({ target }) => target === 'clean'))(
  '$name: registers that are constant, or all equal, are as good',
  async (kind) => {
    for (const held of ['constant', 'equal'] as const) {
      for (const interval of [0, 1000]) expect(missed(kind, await tally(kind, { interval, held }))).toEqual([]);
    }
  },
);

test('one late reply makes two replies doubtful at most, whenever it comes', async () => {
  for (let number = 0; number < 30; number += 3) {
    for (let late = 1.05; late < 4; late += 0.31) {
      const result = await tallyOf(
        {
          device: (parts) => [{ after: parts.number === number ? late * TIMEOUT : parts.usual, bytes: parts.reply }],
          queues: true,
          usual: [12, 25],
          interval: 0,
          requests: fourReads,
          rules: { timeout: TIMEOUT },
        },
        40,
        7,
      );
      expect(result.wrong, `${late} time-outs`).toBe(0);
      expect(result.doubtful, `${late} time-outs, request ${number}`).toBeLessThanOrEqual(2);
    }
  }
});
