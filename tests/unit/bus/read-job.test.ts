import { describe, expect, it } from 'vitest';
import { BusClient, type ReadNews, requestsOf, type Wanted } from '../../../src/bus/index.ts';
import { startJob } from '../../../src/bus/jobs/index.ts';
import { toHex } from '../../../src/modbus/index.ts';
import { framed } from './late-line.ts';
import { ScriptedLink } from './scripted-link.ts';
import { VirtualClock } from './virtual-clock.ts';

const register = (address: number, more: Partial<Wanted> = {}): Wanted => ({
  unit: 1,
  table: 'holding-register',
  address,
  size: 1,
  ...more,
});
/** A reply of unit 1 with registers; an exception; nothing. */
const words = (...list: readonly number[]) =>
  framed(1, 3, 2 * list.length, ...list.flatMap((word) => [word >> 8, word & 0xff]));
const exception = (code: number) => framed(1, 0x83, code);
const nothing = new Uint8Array();

/** Reads on a line that plays these replies, one for each request. */
async function reading(wanted: readonly Wanted[], replies: readonly Uint8Array[], stopAfter = Number.NaN) {
  const clock = new VirtualClock();
  const link = new ScriptedLink(clock);
  for (const bytes of replies) link.replies.push(bytes.length > 0 ? [{ bytes, after: 30 }] : []);
  const news: ReadNews[] = [];
  const order = { kind: 'read', transport: 'rtu', wanted, rules: {} } as const;
  const job = startJob(order, {
    client: new BusClient(link, clock, { timeout: 200, retries: 0 }),
    clock,
    link,
    reopen: () => Promise.resolve(false),
    log: () => 0,
    tell: (one) => {
      if (one.kind === 'read') news.push(one);
      if (news.length === stopAfter) job.stop();
    },
  });
  await clock.until(job.ended);
  const items = new Map(news.flatMap(({ values }) => values.map(({ index, items }) => [index, items] as const)));
  return {
    news,
    /** Start address and quantity of each request that was sent: without unit, function and CRC. */
    sent: link.written.map(({ bytes }) => toHex(bytes.subarray(2, 6))),
    planned: requestsOf(order).map((bytes) => toHex(bytes.subarray(2, 6))),
    items: wanted.map((_, index) => items.get(index)),
    settled: [...items.keys()].toSorted((a, b) => a - b),
  };
}

describe('values that are read once', () => {
  it('come in as few requests as can be, each request once, and end', async () => {
    const wanted = [register(10), register(11, { size: 2 }), register(500), register(14)];
    const { sent, planned, items, news } = await reading(wanted, [words(7, 1, 2, 0, 9), words(5)]);
    expect(sent).toEqual(['000A0005', '01F40001']);
    expect(planned).toEqual(sent);
    expect(items).toEqual([[7], [1, 2], [5], [9]]);
    expect(news.map(({ left, outcome }) => [left, outcome])).toEqual([
      [1, 'reply'],
      [0, 'reply'],
    ]);
  });

  it('are at most 125 registers a request (AP 6.3)', async () => {
    const wanted = Array.from({ length: 126 }, (_, address) => register(address));
    const replies = [words(...Array.from({ length: 125 }, (_, address) => address)), words(125)];
    const { sent, items } = await reading(wanted, replies);
    expect(sent).toEqual(['0000007D', '007D0001']);
    expect(items.map((one) => one?.[0])).toEqual([...wanted.keys()]);
  });

  it('leave out the gap first where the device refuses it, so that only what is missing fails', async () => {
    const wanted = [register(10), register(11), register(20)];
    const { sent, items, news } = await reading(wanted, [exception(2), words(7, 8), exception(2)]);
    // 10 to 20 with a gap of 8; then 10 and 11, and 20 alone
    expect(sent).toEqual(['000A000B', '000A0002', '00140001']);
    expect(items).toEqual([[7], [8], undefined]);
    expect(news.at(-1)).toMatchObject({ values: [{ index: 2 }], outcome: 'exception', exceptionCode: 2, left: 0 });
    expect(news[0]).toMatchObject({ values: [], left: 2 });
  });

  it.each([2, 3])('are halved where exception %i refuses neighbours, down to the one that is missing', async (code) => {
    const wanted = [0, 1, 2, 3, 4].map((address) => register(address));
    const replies = [exception(code), words(1, 2, 3), exception(code), exception(code), words(5)];
    const { sent, items } = await reading(wanted, replies);
    expect(sent).toEqual(['00000005', '00000003', '00030002', '00030001', '00040001']);
    expect(items).toEqual([[1], [2], [3], undefined, [5]]);
  });

  it('are not asked for one by one where they are the same register', async () => {
    const { sent, settled } = await reading([register(3), register(3), register(3)], [exception(2)]);
    expect(sent).toEqual(['00030001']);
    expect(settled).toEqual([0, 1, 2]);
  });

  it.each([1, 4, 6])('are not split for exception %i, which is not about addresses', async (code) => {
    const { sent, items, news } = await reading([register(0), register(1)], [exception(code)]);
    expect(sent).toEqual(['00000002']);
    expect(items).toEqual([undefined, undefined]);
    expect(news[0]).toMatchObject({ verdict: 'refused', exceptionCode: code });
  });

  it('are given up where the device answers none of the first three requests, and not later', async () => {
    const wanted = [0, 100, 200, 300, 400].map((address) => register(address));
    const silent = await reading(wanted, []);
    expect(silent.sent).toHaveLength(3);
    expect(silent.settled).toEqual([0, 1, 2]);
    const later = await reading(wanted, [words(1), nothing, nothing, nothing]);
    expect(later.sent).toHaveLength(5);
  });

  it('are asked for again, once, where the reply may be that to the request before', async () => {
    // The first request gets no reply; the reply to the second fits both.
    const { sent, news, items } = await reading([register(0), register(100)], [nothing, words(9), words(9)]);
    expect(sent.slice(0, 3)).toEqual(['00000001', '00640001', '00640001']);
    expect(sent).toHaveLength(3);
    expect(news[1]).toMatchObject({ values: [], unsure: expect.any(String), left: 1 });
    // The second reply may still be that to the first request, so that it is no value.
    expect(news[2]).toMatchObject({ values: [{ index: 1 }], unsure: 'perhaps-late', left: 0 });
    expect(items).toEqual([undefined, undefined]);
  });

  it('end after the reply that is waited for when they are stopped', async () => {
    const { sent, settled } = await reading([register(0), register(100), register(200)], [words(1), words(2)], 1);
    expect(sent).toHaveLength(1);
    expect(settled).toEqual([0]);
  });
});
