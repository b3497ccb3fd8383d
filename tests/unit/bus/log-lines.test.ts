import { describe, expect, test } from 'vitest';
import { BusClient, type TransactionRules } from '../../../src/bus/index.ts';
import { linesOf } from '../../../src/bus/log/line.ts';
import { hex } from '../modbus/frames.ts';
import { ScriptedLink } from './scripted-link.ts';
import { VirtualClock } from './virtual-clock.ts';

// Unit 17, three registers from 107 on.
const READ = hex('11 03 00 6B 00 03 76 87');
const THREE = hex('11 03 06 AE 41 56 52 43 40 49 AD');
const REFUSAL = hex('11 83 02 C1 34');
const WRITE = hex('11 06 00 01 00 03 9A 9B');
const BROADCAST = hex('00 06 00 01 00 03 99 DA');
const BROKEN = hex('11 03 06 AE 41 56 52 43 40 49 AE');

type Reply = readonly [after: number, bytes: Uint8Array];

/** Number, kind, time, what it answers, verdict of each line of one transaction, from number 5 and time 1000000 on. */
async function linesFor(request: Uint8Array, rules: Partial<TransactionRules>, ...replies: (readonly Reply[])[]) {
  const clock = new VirtualClock();
  const link = new ScriptedLink(clock);
  const client = new BusClient(link, clock, rules);
  for (const one of replies) link.replies.push(one.map(([after, bytes]) => ({ after, bytes })));
  const result = await clock.until(client.transact(request).result);
  return linesOf(result, result.transport, 1_000_000, 5).map(({ number, kind, time, answers, verdict, direction }) => {
    expect(direction).toBe(kind === 'request' ? 'sent' : 'received');
    return [number, kind, Math.round(time - 1_000_000), answers, verdict];
  });
}

describe('the lines of', () => {
  test('a request and its reply', async () => {
    expect(await linesFor(READ, {}, [[20, THREE]])).toEqual([
      [5, 'request', 0, undefined, 'good'],
      [6, 'reply', 20, 5, undefined],
    ]);
  });

  test('an exception', async () => {
    expect(await linesFor(READ, {}, [[20, REFUSAL]])).toEqual([
      [5, 'request', 0, undefined, 'refused'],
      [6, 'exception', 20, 5, undefined],
    ]);
  });

  test('a silence', async () => {
    expect(await linesFor(READ, {})).toEqual([[5, 'request', 0, undefined, 'silent']]);
  });

  test('a silence in a scan, which asks whether somebody is there', async () => {
    const clock = new VirtualClock();
    const client = new BusClient(new ScriptedLink(clock), clock, {});
    const result = await clock.until(client.transact(READ, {}, true).result);
    expect(linesOf(result, 'rtu', 0, 1)).toMatchObject([{ kind: 'request', verdict: 'absent' }]);
  });

  test('a broadcast', async () => {
    expect(await linesFor(BROADCAST, {})).toEqual([[5, 'request', 0, undefined, 'good']]);
  });

  test('a broken reply, a silence and a good reply, each behind its own sending', async () => {
    const lines = await linesFor(READ, { retries: 2, timeout: 500 }, [[20, BROKEN]], [], [[20, THREE]]);
    expect(lines.map(([number, kind, , answers, verdict]) => [number, kind, answers, verdict])).toEqual([
      [5, 'request', undefined, 'bad'],
      [6, 'broken', 5, undefined],
      [7, 'request', undefined, 'silent'],
      [8, 'request', undefined, 'good'],
      [9, 'reply', 8, undefined],
    ]);
  });

  test('an echo and the reply that is the same, handed over together', async () => {
    const both = Uint8Array.from([...WRITE, ...WRITE]);
    expect(await linesFor(WRITE, {}, [[20, both]])).toEqual([
      [5, 'request', 0, undefined, 'good'],
      [6, 'echo', 20, undefined, undefined],
      [7, 'reply', 20, 5, undefined],
    ]);
  });

  test('noise before the reply', async () => {
    expect(
      await linesFor(READ, {}, [
        [15, hex('FF')],
        [20, THREE],
      ]),
    ).toEqual([
      [5, 'request', 0, undefined, 'good'],
      [6, 'noise', 15, undefined, undefined],
      [7, 'reply', 20, 5, undefined],
    ]);
  });

  test('a request that was never sent are none', async () => {
    const clock = new VirtualClock();
    const link = new ScriptedLink(clock);
    link.become({ kind: 'closed' });
    const result = await clock.until(new BusClient(link, clock).transact(READ).result);
    expect(linesOf(result, 'rtu', 0, 1)).toEqual([]);
  });
});
