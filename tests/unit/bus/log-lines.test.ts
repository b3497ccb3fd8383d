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

/** Kind, time, verdict of each line of one transaction, from time 1000000 on. */
async function linesFor(request: Uint8Array, rules: Partial<TransactionRules>, ...replies: (readonly Reply[])[]) {
  const clock = new VirtualClock();
  const link = new ScriptedLink(clock);
  const client = new BusClient(link, clock, rules);
  for (const one of replies) link.replies.push(one.map(([after, bytes]) => ({ after, bytes })));
  const result = await clock.until(client.transact(request).result);
  return linesOf(result, result.transport, 1_000_000).map(({ kind, time, verdict, direction }) => {
    expect(direction).toBe(kind === 'request' ? 'sent' : 'received');
    return [kind, Math.round(time - 1_000_000), verdict];
  });
}

describe('the lines of', () => {
  test('a request and its reply', async () => {
    expect(await linesFor(READ, {}, [[20, THREE]])).toEqual([
      ['request', 0, 'good'],
      ['reply', 20, undefined],
    ]);
  });

  test('an exception', async () => {
    expect(await linesFor(READ, {}, [[20, REFUSAL]])).toEqual([
      ['request', 0, 'refused'],
      ['exception', 20, undefined],
    ]);
  });

  test('a silence', async () => {
    expect(await linesFor(READ, {})).toEqual([['request', 0, 'silent']]);
  });

  test('a silence in a scan, which asks whether somebody is there', async () => {
    const clock = new VirtualClock();
    const client = new BusClient(new ScriptedLink(clock), clock, {});
    const result = await clock.until(client.transact(READ, {}, true).result);
    expect(linesOf(result, 'rtu', 0)).toMatchObject([{ kind: 'request', verdict: 'absent' }]);
  });

  test('a broadcast', async () => {
    expect(await linesFor(BROADCAST, {})).toEqual([['request', 0, 'good']]);
  });

  test('a broken reply, a silence and a good reply, each behind its own sending', async () => {
    const lines = await linesFor(READ, { retries: 2, timeout: 500 }, [[20, BROKEN]], [], [[20, THREE]]);
    expect(lines.map(([kind, , verdict]) => [kind, verdict])).toEqual([
      ['request', 'bad'],
      ['broken', undefined],
      ['request', 'silent'],
      ['request', 'good'],
      ['reply', undefined],
    ]);
  });

  test('an echo and the reply that is the same, handed over together', async () => {
    const both = Uint8Array.from([...WRITE, ...WRITE]);
    expect(await linesFor(WRITE, {}, [[20, both]])).toEqual([
      ['request', 0, 'good'],
      ['echo', 20, undefined],
      ['reply', 20, undefined],
    ]);
  });

  test('noise before the reply', async () => {
    expect(
      await linesFor(READ, {}, [
        [15, hex('FF')],
        [20, THREE],
      ]),
    ).toEqual([
      ['request', 0, 'good'],
      ['noise', 15, undefined],
      ['reply', 20, undefined],
    ]);
  });

  test('a request that was never sent are none', async () => {
    const clock = new VirtualClock();
    const link = new ScriptedLink(clock);
    link.become({ kind: 'closed' });
    const result = await clock.until(new BusClient(link, clock).transact(READ).result);
    expect(linesOf(result, 'rtu', 0)).toEqual([]);
  });
});
