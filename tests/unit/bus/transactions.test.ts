import { describe, expect, test } from 'vitest';
import { BusClient, type BusEvent, type TransactionResult, type TransactionRules } from '../../../src/bus/index.ts';
import { sentResult } from '../../../src/bus/session/messages.ts';
import { hex } from '../modbus/frames.ts';
import { ScriptedLink } from './scripted-link.ts';
import { VirtualClock } from './virtual-clock.ts';

// Unit 17, three registers from 107 on, as the guide PI-MBUS-300 asks for them.
const READ = hex('11 03 00 6B 00 03 76 87');
const THREE = hex('11 03 06 AE 41 56 52 43 40 49 AD');
const OTHER_THREE = hex('11 03 06 00 01 00 02 00 03 30 B4');
const REFUSAL = hex('11 83 02 C1 34');
const WRITE = hex('11 06 00 01 00 03 9A 9B');
const READ_ONE = hex('11 03 00 6B 00 01 F7 46');
const ONE = hex('11 03 02 12 34 74 F0');

const text = (bytes: Uint8Array) => Buffer.from(bytes).toString('hex').toUpperCase();
const joined = (...parts: Uint8Array[]) => Uint8Array.from(parts.flatMap((part) => [...part]));

function bench(rules: Partial<TransactionRules> = {}) {
  const clock = new VirtualClock();
  const link = new ScriptedLink(clock);
  const client = new BusClient(link, clock, rules);
  const events: BusEvent[] = [];
  client.listen((event) => events.push(event));
  /** Sends a request whose replies are these, so many milliseconds after the writing. */
  const ask = (request: Uint8Array, ...replies: (readonly [number, Uint8Array])[]): Promise<TransactionResult> => {
    link.replies.push(replies.map(([after, bytes]) => ({ after, bytes })));
    return clock.until(client.transact(request).result);
  };
  return { clock, link, client, events, ask };
}

const strays = ({ strays }: TransactionResult) => strays.map(({ what, bytes }) => [what, text(bytes)]);

describe('a reply', () => {
  test('is read, checked against its request, and timed', async () => {
    const { ask, link } = bench();
    const result = await ask(READ, [20, THREE]);
    expect(result).toMatchObject({ verdict: 'good', echo: 'none', sentAt: 0, endedAt: 20, strays: [], findings: [] });
    expect(result.outcome).toMatchObject({ kind: 'reply', at: 20 });
    expect(result.outcome).toHaveProperty('reading.fields.registers', [0xae41, 0x5652, 0x4340]);
    expect(link.written).toEqual([{ bytes: READ, at: 0 }]);
  });

  test('is one in whatever two pieces it comes, or byte by byte', async () => {
    for (let cut = 1; cut < THREE.length; cut++) {
      const { ask } = bench();
      const result = await ask(READ, [20, THREE.subarray(0, cut)], [36, THREE.subarray(cut)]);
      expect(result, `cut at ${cut}`).toMatchObject({ verdict: 'good', endedAt: 36, strays: [] });
    }
    const { ask } = bench();
    const bytes = [...THREE].map((byte, at) => [20 + at, Uint8Array.of(byte)] as const);
    expect(await ask(READ, ...bytes)).toMatchObject({ verdict: 'good', endedAt: 30 });
  });

  test('that refuses is an exception', async () => {
    const { ask } = bench();
    const result = await ask(READ, [20, REFUSAL]);
    expect(result).toMatchObject({ verdict: 'refused', outcome: { kind: 'exception', exceptionCode: 2 } });
  });

  test('with fewer registers than were asked for is taken, and bad', async () => {
    const { ask } = bench();
    const result = await ask(READ, [20, ONE]);
    expect(result).toMatchObject({ verdict: 'bad', outcome: { kind: 'reply' } });
    expect(result.outcome).toHaveProperty('reading.problems.0.code', 'count-not-as-requested');
    expect(result.findings[0]).toMatchObject({ code: 'quantity-mismatch' });
  });

  test('whose length no byte tells ends with the request again, or with silence', async () => {
    const query = hex('11 08 00 00 A5 37 D8 1D');
    const same = await bench({ echo: 'off' }).ask(query, [20, query.subarray(0, 6)], [30, query.subarray(6)]);
    expect(same).toMatchObject({ verdict: 'good', endedAt: 30 });
    const longer = hex('11 08 00 00 A5 37 01 02 1A 58');
    const result = await bench({ echo: 'off' }).ask(query, [20, longer]);
    // 3.5 characters of 10 bits at 9600 baud, and the 200 ms of patience.
    expect(result.endedAt).toBeCloseTo(20 + 3.646 + 200, 2);
    expect(result).toMatchObject({ verdict: 'bad', outcome: { kind: 'reply', bytes: longer } });
  });

  test('that takes longer than the time-out, once it has begun, is waited for', async () => {
    const { ask } = bench({ timeout: 100 });
    const result = await ask(READ, [100, THREE.subarray(0, 4)], [130, THREE.subarray(4, 8)], [160, THREE.subarray(8)]);
    expect(result).toMatchObject({ verdict: 'good', endedAt: 160 });
  });
});

test('a page that is held up while a reply comes still gets it', async () => {
  const { client, link, clock } = bench();
  const { result } = client.transact(READ);
  await clock.advance(20);
  link.receive(THREE.subarray(0, 4));
  clock.holdUp(3000);
  clock.after(5, () => link.receive(THREE.subarray(4)));
  expect(await clock.until(result)).toMatchObject({ verdict: 'good' });
});

describe('no reply, or a broken one', () => {
  test('nothing comes: the time-out counts from the end of the request', async () => {
    const result = await bench({ timeout: 500 }).ask(READ);
    expect(result).toMatchObject({ verdict: 'bad', outcome: { kind: 'silent' } });
    // Eight characters of 10 bits at 9600 baud take 8.33 ms.
    expect(result.endedAt).toBeCloseTo(508.33, 2);
  });

  test('a reply that is cut off is over after a silence', async () => {
    const { ask } = bench();
    const result = await ask(READ, [20, THREE.subarray(0, 7)]);
    expect(result.endedAt).toBeLessThan(300);
    expect(result).toMatchObject({ verdict: 'bad', outcome: { kind: 'broken', bytes: THREE.subarray(0, 7) } });
    expect(result.findings[0]).toMatchObject({ code: 'truncated', missing: 4 });
  });

  test('a reply with a wrong bit is broken, and what is wrong is found', async () => {
    const flipped = THREE.with(4, THREE[4]! ^ 1);
    const result = await bench().ask(READ, [20, flipped]);
    expect(result).toMatchObject({ verdict: 'bad', outcome: { kind: 'broken', bytes: flipped } });
    expect(result.findings[0]).toMatchObject({ code: 'bit-error', at: 4, bit: 0 });
  });

  test('a bad frame and a good one in one piece: the good one is the reply', async () => {
    const flipped = THREE.with(4, THREE[4]! ^ 1);
    const result = await bench().ask(READ, [20, joined(flipped, THREE)]);
    expect(result).toMatchObject({ verdict: 'good', outcome: { bytes: THREE } });
    expect(strays(result)).toEqual([['noise', text(flipped)]]);
  });

  test('noise before and behind the reply is taken away', async () => {
    for (const noise of [hex('00'), hex('FF 11'), hex('11 03'), hex('80 C4 7F')]) {
      const result = await bench().ask(READ, [20, joined(noise, THREE, hex('00'))]);
      expect(result, text(noise)).toMatchObject({ verdict: 'good', outcome: { bytes: THREE } });
      expect(strays(result)).toEqual([
        ['noise', text(noise)],
        ['noise', '00'],
      ]);
    }
  });

  test('noise alone does not end the waiting', async () => {
    const result = await bench().ask(READ, [5, hex('FF')], [300, THREE]);
    expect(result).toMatchObject({ verdict: 'good', endedAt: 300 });
    const noise = await bench().ask(READ, [5, hex('FF 80')]);
    expect(noise).toMatchObject({ verdict: 'bad', outcome: { kind: 'broken', bytes: hex('FF 80') } });
    expect(noise.endedAt).toBeGreaterThan(1000);
  });

  test('another unit’s reply is refused, and waiting goes on', async () => {
    const other = hex('21 03 08 30 39 D4 31 1A 0A 22 B8 C4 18');
    const result = await bench().ask(READ, [20, other], [200, THREE]);
    expect(result).toMatchObject({ verdict: 'good', endedAt: 200 });
    expect(strays(result)).toEqual([['other', text(other)]]);
    const alone = await bench().ask(READ, [20, other]);
    expect(alone).toMatchObject({ verdict: 'bad', outcome: { kind: 'silent' } });
  });

  test('it is asked again as often as the rules say', async () => {
    const { client, clock, link } = bench({ retries: 2, timeout: 100 });
    link.replies.push([], [{ after: 20, bytes: THREE.subarray(0, 5) }], [{ after: 20, bytes: THREE }]);
    const result = await clock.until(client.transact(READ).result);
    expect(result.earlier.map(({ outcome }) => outcome.kind)).toEqual(['silent', 'broken']);
    expect(result).toMatchObject({ verdict: 'good' });
    expect(link.written).toHaveLength(3);
  });

  test('errors of the line are counted, and what comes with them is no noise', async () => {
    const { client, link, clock } = bench();
    const { result } = client.transact(READ);
    await clock.advance(20);
    link.error('parity');
    link.receive(hex('AA'));
    expect(await clock.until(result)).toMatchObject({
      verdict: 'bad',
      outcome: { kind: 'broken' },
      errors: { parity: 1, framing: 0 },
    });
    expect(clock.now()).toBeLessThan(300);
  });
});

describe('late replies', () => {
  test('one that comes between two requests is named', async () => {
    const { ask, link, clock, events } = bench({ timeout: 100 });
    await ask(READ);
    link.receive(THREE);
    await clock.advance(300);
    const [stray] = events.filter(({ kind }) => kind === 'stray');
    expect(stray).toMatchObject({ stray: { what: 'late', bytes: THREE, answers: READ } });
  });

  test('one that has come whole does not keep the next request', async () => {
    const { ask, link, clock } = bench({ timeout: 100 });
    await ask(READ);
    await clock.advance(500);
    link.receive(THREE);
    const before = clock.now();
    const result = await ask(READ_ONE, [20, ONE]);
    // 3.5 characters of 10 bits at 9600 baud.
    expect((result.sentAt ?? 0) - before).toBeCloseTo(3.646, 2);
    expect(result).toMatchObject({ verdict: 'good', outcome: { bytes: ONE } });
    expect(strays(result)).toEqual([['late', text(THREE)]]);
  });

  test('one that comes behind the next request is not taken for its reply', async () => {
    const { ask } = bench({ timeout: 100 });
    await ask(READ);
    const result = await ask(READ_ONE, [20, THREE], [40, ONE]);
    expect(result).toMatchObject({ verdict: 'good', outcome: { bytes: ONE } });
    expect(strays(result)).toEqual([['late', text(THREE)]]);
  });

  test('of two replies in one piece, each goes to its request', async () => {
    const { ask } = bench({ timeout: 100 });
    await ask(READ);
    const result = await ask(READ_ONE, [20, joined(THREE, ONE)]);
    expect(result).toMatchObject({ verdict: 'good', outcome: { bytes: ONE } });
    expect(strays(result)).toEqual([['late', text(THREE)]]);
  });

  test('to a request that could be answered the same way: the next frame is the reply, and doubtful', async () => {
    const { ask } = bench({ timeout: 100 });
    await ask(READ);
    const result = await ask(READ, [20, THREE], [35, OTHER_THREE]);
    expect(result).toMatchObject({ verdict: 'doubtful', unsure: 'perhaps-late', outcome: { bytes: OTHER_THREE } });
    expect(strays(result)).toEqual([['late', text(THREE)]]);
    // Both have been answered.
    expect(await ask(READ, [20, THREE])).toMatchObject({ verdict: 'good', endedAt: expect.any(Number) });
  });

  test('after three in a row, the time that the device takes is told', async () => {
    const { ask } = bench({ timeout: 100 });
    const slow = [];
    for (const after of [150, 160, 170, 150]) slow.push((await ask(READ, [after, THREE])).slow);
    expect(slow.slice(0, 3)).toEqual([undefined, undefined, undefined]);
    expect(slow[3]).toBeCloseTo(170, 0);
  });

  test('to such a request, sooner than the device has ever answered: the next frame is the reply for sure', async () => {
    const { ask, clock } = bench({ timeout: 100 });
    for (let i = 0; i < 9; i++) await ask(READ, [20, THREE]);
    await ask(READ);
    await clock.advance(150);
    const result = await ask(READ, [5, THREE], [20, OTHER_THREE]);
    expect(result).toMatchObject({ verdict: 'good', outcome: { bytes: OTHER_THREE } });
    expect(strays(result)).toEqual([['late', text(THREE)]]);
  });

  test('where only one frame comes, it is doubtful, and no later than at the time-out', async () => {
    const { ask } = bench({ timeout: 100 });
    await ask(READ);
    const result = await ask(READ, [20, THREE]);
    expect(result).toMatchObject({
      verdict: 'doubtful',
      unsure: 'perhaps-late',
      outcome: { bytes: THREE },
      strays: [],
    });
    // Eight characters of 10 bits at 9600 baud take 8.33 ms.
    expect(result.endedAt - (result.sentAt ?? 0)).toBeCloseTo(108.33, 2);
  });

  test('that do not come: once the device has answered, two replies are doubtful, and then it is clear', async () => {
    const { ask } = bench({ timeout: 100 });
    await ask(READ, [20, THREE]);
    await ask(READ);
    const verdicts = [];
    for (let i = 0; i < 4; i++) verdicts.push((await ask(READ, [20, THREE])).verdict);
    expect(verdicts).toEqual(['doubtful', 'doubtful', 'good', 'good']);
  });

  test('are waited for in silence, at most for one more time-out', async () => {
    const { ask, link, clock } = bench({ timeout: 100 });
    link.replies.push([{ after: 150, bytes: THREE }]);
    const { client } = { client: new BusClient(link, clock, { timeout: 100 }) };
    await clock.until(client.transact(READ).result);
    link.replies.push([{ after: 20, bytes: OTHER_THREE }]);
    const result = await clock.until(client.transact(READ).result);
    expect(result).toMatchObject({ verdict: 'good', outcome: { bytes: OTHER_THREE } });
    expect(strays(result)).toEqual([['late', text(THREE)]]);
    // 3.5 characters behind the late reply.
    expect(link.written[1]?.at).toBeCloseTo(150 + 3.646, 2);
    await ask(READ);
    const silent = clock.now();
    await ask(READ_ONE, [20, ONE]);
    expect((link.written.at(-1)?.at ?? 0) - silent).toBeCloseTo(100, 2);
  });

  test('are not waited for where the rules say so, nor before a request that they do not answer', async () => {
    const off = bench({ timeout: 100, quiet: false });
    await off.ask(READ);
    await off.ask(READ, [20, THREE]);
    expect(off.link.written[1]?.at).toBeCloseTo(108.33, 2);
    const other = bench({ timeout: 100 });
    await other.ask(READ);
    await other.ask(WRITE, [20, WRITE]);
    expect(other.link.written[1]?.at).toBeCloseTo(108.33, 2);
  });

  test('to the same request, sent again, are its reply', async () => {
    const { client, link, clock } = bench({ timeout: 100, retries: 1 });
    link.replies.push([{ after: 150, bytes: THREE }]);
    const result = await clock.until(client.transact(READ).result);
    expect(result).toMatchObject({ verdict: 'good', sentAt: 0, endedAt: 150, earlier: [], strays: [] });
    expect(link.written).toHaveLength(1);
  });

  test('three in a row say that the time-out is too short', async () => {
    const { client, link, clock } = bench({ timeout: 100 });
    const slow = [];
    for (let i = 0; i < 5; i++) {
      link.replies.push([{ after: 150, bytes: THREE }]);
      slow.push((await clock.until(client.transact(READ).result)).slow);
    }
    expect(slow.map((after) => after && Math.round(after))).toEqual([undefined, undefined, undefined, 150, 150]);
  });

  test('whose beginning came before the next request: its end is not taken for noise', async () => {
    const { ask, link, client, clock } = bench({ timeout: 100 });
    await ask(READ);
    link.receive(THREE.subarray(0, 5));
    clock.after(10, () => link.receive(THREE.subarray(5)));
    link.replies.push([{ after: 20, bytes: ONE }]);
    const result = await clock.until(client.transact(READ_ONE).result);
    expect(result).toMatchObject({ verdict: 'good', outcome: { bytes: ONE } });
    expect(strays(result)).toEqual([['late', text(THREE)]]);
  });
});

describe('second copies', () => {
  const first = async (count: number) => {
    const all = bench({ gap: 0 });
    for (let i = 0; i < count; i++) await all.ask(READ, [20, THREE]);
    return all;
  };

  test('that come sooner than the device has ever answered are not taken for the reply', async () => {
    const { ask } = await first(9);
    const result = await ask(READ, [7, THREE], [20, OTHER_THREE]);
    expect(result).toMatchObject({ verdict: 'good', outcome: { bytes: OTHER_THREE } });
    expect(strays(result)).toEqual([['copy', text(THREE)]]);
  });

  test('where no other frame comes, it is doubtful', async () => {
    const { ask } = await first(9);
    const result = await ask(READ, [7, THREE]);
    expect(result).toMatchObject({ verdict: 'doubtful', unsure: 'perhaps-copy', outcome: { bytes: THREE } });
  });

  test('of one of the first replies come in the silence behind it', async () => {
    const { link, clock, client } = bench({ gap: 0 });
    link.replies.push([
      { after: 20, bytes: THREE },
      { after: 33, bytes: THREE },
    ]);
    await clock.until(client.transact(READ).result);
    link.replies.push([{ after: 20, bytes: OTHER_THREE }]);
    const result = await clock.until(client.transact(READ).result);
    expect(result).toMatchObject({ verdict: 'good', outcome: { bytes: OTHER_THREE } });
    expect(strays(result)).toEqual([['copy', text(THREE)]]);
  });

  test('the same value again, read as quickly as ever, is good', async () => {
    const { ask } = await first(20);
    expect(await ask(READ, [20, THREE])).toMatchObject({ verdict: 'good' });
  });
});

test('the time of a transaction counts to the last byte of the reply', async () => {
  const { ask } = bench();
  const result = await ask(READ, [20, THREE.subarray(0, 4)], [90, THREE.subarray(4)]);
  expect(result.outcome).toMatchObject({ at: 20, endAt: 90 });
  expect(sentResult(result).duration).toBe(90);
});

describe('frames of the unit that do not answer', () => {
  test('another function’s is a stray while the reply can come', async () => {
    const result = await bench().ask(READ, [12, WRITE], [40, THREE]);
    expect(result).toMatchObject({ verdict: 'good', outcome: { bytes: THREE }, endedAt: 40 });
    expect(strays(result)).toEqual([['other', text(WRITE)]]);
  });

  test('another function’s is the reply, and bad, where no other comes', async () => {
    const result = await bench().ask(READ, [12, WRITE]);
    expect(result).toMatchObject({ verdict: 'bad', outcome: { kind: 'reply', bytes: WRITE }, strays: [] });
    expect(result.endedAt).toBeCloseTo(1008.33, 2);
  });

  test('with fewer registers than were asked for is waited behind for a silence only', async () => {
    const result = await bench().ask(READ, [12, ONE], [100, THREE]);
    expect(result).toMatchObject({ verdict: 'good', outcome: { bytes: THREE } });
    const alone = await bench().ask(READ, [12, ONE]);
    expect(alone).toMatchObject({ verdict: 'bad', outcome: { bytes: ONE } });
    expect(alone.endedAt).toBeCloseTo(12 + 3.646 + 200, 2);
  });

  test('two replies that differ are doubtful', async () => {
    const result = await bench().ask(READ, [20, joined(THREE, OTHER_THREE)]);
    expect(result).toMatchObject({ verdict: 'doubtful', unsure: 'two-replies', outcome: { bytes: THREE } });
  });
});

describe('echo', () => {
  test('before a reply that differs from the request, it is removed, in whatever pieces it comes', async () => {
    const all = joined(READ, THREE);
    for (let cut = 1; cut < all.length; cut++) {
      const result = await bench().ask(READ, [8, all.subarray(0, cut)], [24, all.subarray(cut)]);
      expect(result, `cut at ${cut}`).toMatchObject({ verdict: 'good', echo: 'removed', outcome: { bytes: THREE } });
      expect(strays(result)).toEqual([['echo', text(READ)]]);
    }
  });

  test('alone, it is no reply', async () => {
    expect(await bench().ask(READ, [8, READ])).toMatchObject({ echo: 'removed', outcome: { kind: 'silent' } });
  });

  test('of a request whose reply is the same: two copies are echo and reply', async () => {
    for (const replies of [
      [[8, joined(WRITE, WRITE)]],
      [
        [8, WRITE],
        [60, WRITE],
      ],
    ] as const) {
      const result = await bench().ask(WRITE, ...replies);
      expect(result).toMatchObject({ verdict: 'good', echo: 'removed', outcome: { bytes: WRITE } });
    }
  });

  test('of a request whose reply is the same: one copy alone is doubtful until the line is known', async () => {
    const { ask } = bench();
    expect(await ask(WRITE, [20, WRITE])).toMatchObject({ verdict: 'doubtful', echo: 'undecided', endedAt: 220 });
    await ask(READ, [20, THREE]);
    const known = await ask(WRITE, [20, WRITE]);
    expect(known).toMatchObject({ verdict: 'good', echo: 'none' });
    expect(known.endedAt - (known.sentAt ?? 0)).toBeCloseTo(20, 6);
  });

  test('once the line is known to echo, a single copy is no reply', async () => {
    const { ask } = bench();
    await ask(READ, [8, READ], [20, THREE]);
    expect(await ask(WRITE, [8, WRITE])).toMatchObject({ outcome: { kind: 'silent' } });
    // To the write before, or to this one.
    const refused = await ask(WRITE, [8, WRITE], [30, hex('11 86 02 C2 64')]);
    expect(refused).toMatchObject({ verdict: 'doubtful', outcome: { kind: 'exception' } });
  });

  test('is removed although it is damaged, where it is said to be there', async () => {
    const damaged = READ.with(3, 0x6a);
    const result = await bench({ echo: 'on' }).ask(READ, [8, damaged], [20, THREE]);
    expect(result).toMatchObject({ verdict: 'good', echo: 'removed' });
  });

  test('is removed if no more than a quarter of it is damaged', async () => {
    // The request has 8 bytes.
    const withDamage = (count: number) => READ.map((byte, at) => (at < count ? byte ^ 0xff : byte));
    for (const count of [1, 2]) {
      const result = await bench({ echo: 'on' }).ask(READ, [8, withDamage(count)], [20, THREE]);
      expect(result, `${count} bytes`).toMatchObject({ verdict: 'good', echo: 'removed', outcome: { bytes: THREE } });
    }
    for (const count of [3, 4]) {
      const result = await bench({ echo: 'on' }).ask(READ, [8, withDamage(count)], [20, THREE]);
      expect(result.echo, `${count} bytes`).toBe('none');
    }
  });

  test('is not looked for where it is said not to be there', async () => {
    expect(await bench({ echo: 'off' }).ask(WRITE, [20, WRITE])).toMatchObject({ verdict: 'good', endedAt: 20 });
  });
});

describe('one after another', () => {
  test('however many are asked for at once, each waits for the one before and for the silence', async () => {
    const { client, link, clock } = bench({ echo: 'off' });
    for (let i = 0; i < 3; i++) link.replies.push([{ after: 20, bytes: THREE }]);
    const all = [1, 2, 3].map(() => client.transact(READ));
    expect(client.pending).toBe(3);
    const results = await clock.until(Promise.all(all.map(({ result }) => result)));
    expect(results.map(({ verdict }) => verdict)).toEqual(['good', 'good', 'good']);
    // 20 ms each, and three times as long between them while the device is new: a second copy of a reply would come there.
    expect(link.written.map(({ at }) => Number(at.toFixed(2)))).toEqual([0, 80, 160]);
    expect(client.pending).toBe(0);
  });

  test('one that is cancelled makes room for the next', async () => {
    const { client, link, clock } = bench();
    link.replies.push([], [{ after: 20, bytes: ONE }]);
    const [first, second, third] = [client.transact(READ), client.transact(WRITE), client.transact(READ_ONE)];
    await clock.advance(5);
    second.cancel();
    first.cancel();
    expect(await clock.until(first.result)).toMatchObject({ verdict: 'ended', outcome: { stage: 'waiting' } });
    expect(await clock.until(second.result)).toMatchObject({ verdict: 'ended', outcome: { stage: 'queued' } });
    expect(await clock.until(third.result)).toMatchObject({ verdict: 'good' });
    expect(link.written.map(({ bytes }) => bytes)).toEqual([READ, READ_ONE]);
    first.cancel();
  });

  test('a broadcast is over when it is sent, and devices get their time', async () => {
    const { ask, link } = bench();
    const all = hex('00 06 00 01 00 03 99 DA');
    expect(await ask(all)).toMatchObject({ verdict: 'good', outcome: { kind: 'sent', why: 'broadcast' }, endedAt: 0 });
    await ask(READ, [20, THREE]);
    expect(link.written[1]?.at).toBeCloseTo(8.33 + 100, 2);
  });

  test('a function without a reply is over when it is sent', async () => {
    const result = await bench().ask(hex('11 08 00 04 00 00 A3 5A'));
    expect(result).toMatchObject({ verdict: 'good', outcome: { kind: 'sent', why: 'no-reply' } });
  });
});

describe('the link goes away', () => {
  test.each([
    ['while it waits for its turn', 0, [20, THREE]],
    ['while it is sent', 0, undefined],
    ['while the reply is waited for', 10, undefined],
    ['while the reply comes', 25, [20, THREE.subarray(0, 4)]],
  ] as const)('%s', async (what, after, reply) => {
    const { client, link, clock } = bench();
    link.replies.push(reply === undefined ? [] : [{ after: reply[0], bytes: reply[1] }]);
    if (what === 'while it is sent') link.writes.push(new Promise(() => {}));
    const first = client.transact(READ);
    const second = client.transact(WRITE);
    await clock.advance(after);
    link.lose();
    const stage = what === 'while it is sent' ? 'sending' : 'waiting';
    expect((await clock.until(first.result)).outcome).toEqual({ kind: 'lost', stage });
    expect((await clock.until(second.result)).outcome).toEqual({ kind: 'lost', stage: 'queued' });
    expect(await clock.until(client.transact(READ).result)).toMatchObject({
      verdict: 'ended',
      outcome: { kind: 'not-sent', why: 'not-open' },
    });
  });

  test('between two transactions nothing is lost, and after it is opened again it goes on', async () => {
    const { ask, link } = bench();
    const { state } = link;
    await ask(READ, [20, THREE]);
    link.lose();
    link.become(state);
    expect(await ask(READ, [20, THREE])).toMatchObject({ verdict: 'good' });
  });

  test('what cannot be written is said', async () => {
    const failed = bench();
    failed.link.writes.push(false);
    expect((await failed.ask(READ)).outcome).toEqual({ kind: 'not-sent', why: 'write-failed' });
    const stuck = bench();
    stuck.link.writes.push(new Promise(() => {}));
    expect((await stuck.ask(READ)).outcome).toEqual({ kind: 'not-sent', why: 'stuck' });
  });
});

describe('ASCII', () => {
  const ascii = (line: string) => new TextEncoder().encode(line);
  const request = ascii(':1103006B00037E\r\n');
  const reply = ascii(':110306AE4156524340CC\r\n');

  test('a reply is one in whatever two pieces it comes, after noise and an echo', async () => {
    const all = joined(request, ascii('x'), reply);
    for (let cut = 1; cut < all.length; cut++) {
      const { ask } = bench({ transport: 'ascii' });
      const result = await ask(request, [20, all.subarray(0, cut)], [400, all.subarray(cut)]);
      expect(result, `cut at ${cut}`).toMatchObject({ verdict: 'good', echo: 'removed', endedAt: 400 });
    }
  });

  test('a wrong LRC is known as soon as the line ends', async () => {
    const wrong = ascii(':110306AE4156524340CD\r\n');
    const result = await bench({ transport: 'ascii' }).ask(request, [20, wrong]);
    expect(result).toMatchObject({ verdict: 'bad', outcome: { kind: 'broken' }, endedAt: 20 });
    expect(result.findings[0]).toMatchObject({ code: 'lrc-wrong' });
  });

  test('a frame that begins again takes the place of its first beginning', async () => {
    const result = await bench({ transport: 'ascii' }).ask(request, [20, joined(reply.subarray(0, 9), reply)]);
    expect(result).toMatchObject({ verdict: 'good', outcome: { bytes: reply } });
  });
});
