import { expect, test } from 'vitest';
import { type Case, type Device, devices, fourReads, type Kind, kinds, missed, tallyOf } from './late-line.ts';

const TIMEOUT = 200;

const tally = (kind: Kind, one: Pick<Case, 'interval' | 'held'>, retries = 0) =>
  tallyOf({ ...kind, ...one, rules: { timeout: TIMEOUT, retries } }, 120, 7);

const decidable = kinds.filter(({ target }) => target !== 'undecidable');

// `npm run bench:late` plays them all for longer.
test.each(decidable)('$name: nothing wrong is shown as good, whatever the interval and the retries', async (kind) => {
  expect(missed(kind, await tally(kind, { interval: 0 }, 0))).toEqual([]);
  expect(missed(kind, await tally(kind, { interval: 1000 }, 2))).toEqual([]);
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
  for (let number = 0; number < 30; number += 7) {
    for (let late = 1.05; late < 4; late += 0.47) {
      const result = await tallyOf(
        {
          device: (parts) => [{ after: parts.number === number ? late * TIMEOUT : parts.usual, bytes: parts.reply }],
          queues: true,
          usual: [12, 25],
          interval: 0,
          requests: fourReads,
          rules: { timeout: TIMEOUT },
        },
        number + 12,
        7,
      );
      expect(result.wrong, `${late} time-outs`).toBe(0);
      expect(result.doubtful, `${late} time-outs, request ${number}`).toBeLessThanOrEqual(2);
    }
  }
});

// VW800, VW820, VW840 and VW860 of an S7-200, polled with the default time-out from a device that takes 20 ms, and once 1.3 s.
test.each([0, 1000])(
  'four registers, one reply of 1.3 s, interval %i ms: no value is that of another',
  async (interval) => {
    const once: Device = ({ number, reply }) => [{ after: number === 6 ? 1300 : 20, bytes: reply }];
    for (const queues of [true, false]) {
      const one = {
        device: once,
        queues,
        usual: [20, 20],
        held: 'constant',
        interval,
        rules: { timeout: 1000 },
      } as const;
      const { wrong, doubtful, answered, answeredGood } = await tallyOf(one, 60, 1);
      expect({ wrong, doubtful, answered, answeredGood }).toEqual({
        wrong: 0,
        doubtful: 0,
        answered: 59,
        answeredGood: 59,
      });
    }
  },
);

test('a copy at any time is not the value of another register where registers stay the same', async () => {
  for (const held of ['constant', 'changing'] as const) {
    for (let after = 1; after <= 61; after += 12) {
      const device = devices.doubles(after, after, 0.2);
      const one = { device, usual: [12, 25], held, interval: 0, rules: { timeout: TIMEOUT } } as const;
      expect((await tallyOf(one, 60, after)).wrong, `${held}, ${after} ms`).toBe(0);
    }
  }
});

test('the first copy of a line, handed over into the next request by a busy computer, is not the value of another', async () => {
  for (const held of ['constant', 'changing'] as const) {
    for (let copied = 4; copied <= 64; copied += 20) {
      for (let stalled = 0; stalled <= 150; stalled += 30) {
        // Behind the ninth answer nothing is left silent any more.
        const device: Device = ({ number, reply, usual }) => [
          { after: number === 11 ? usual + stalled : usual, bytes: reply },
          ...(number === 10 ? [{ after: usual + copied, bytes: reply }] : []),
        ];
        const one = { device, queues: true, usual: [20, 20], held, interval: 0, rules: { timeout: 1000 } } as const;
        const { wrong, doubtful } = await tallyOf(one, 40, 1);
        expect(wrong, `${held}, ${copied} ms, ${stalled} ms`).toBe(0);
        expect(doubtful, `${held}, ${copied} ms, ${stalled} ms`).toBeLessThanOrEqual(1);
      }
    }
  }
});

test('registers that often have the value of one read just before are waited for three times only', async () => {
  const { wrong, doubtful, time } = await tallyOf(
    { device: devices.right, usual: [20, 20], held: 'bits', interval: 0, rules: { timeout: 1000 } },
    400,
    7,
  );
  expect({ wrong, doubtful }).toEqual({ wrong: 0, doubtful: 0 });
  expect(time / 400).toBeLessThan(40);
});
