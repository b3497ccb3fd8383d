import { describe, expect, test } from 'vitest';
import {
  defaultRules,
  defaultSettings,
  type Link,
  Session,
  type SessionCommand,
  type SessionNews,
} from '../../../src/bus/index.ts';
import { hex } from '../modbus/frames.ts';
import { framed } from './late-line.ts';
import { ScriptedLink } from './scripted-link.ts';
import { VirtualClock } from './virtual-clock.ts';

// Unit 17, three registers from 107 on.
const READ = hex('11 03 00 6B 00 03 76 87');
const THREE = hex('11 03 06 AE 41 56 52 43 40 49 AD');
const READ_OTHERS = framed(0x11, 3, 0, 0xc8, 0, 3);
const OTHER_THREE = framed(0x11, 3, 6, 0, 1, 0, 2, 0, 3);
// Register 1 becomes 3; the reply is the same.
const WRITE = hex('11 06 00 01 00 03 9A 9B');
const OTHER_WRITE = hex('11 06 00 01 00 04 DB 59');
const WRITE_TO_18 = hex('12 06 00 01 00 03 9A A8');
const BROADCAST = hex('00 06 00 01 00 03 99 DA');
/** Long enough for news that are kept together. */
const SOON = 100;

type News<K extends SessionNews['kind']> = Extract<SessionNews, { readonly kind: K }>;

function bench() {
  const clock = new VirtualClock();
  const link = new ScriptedLink(clock);
  const links: (Link | undefined)[] = [link];
  const all: SessionNews[] = [];
  const session = new Session({ clock, portLink: async () => links[0], tell: (news) => all.push(news) });
  const news = <K extends SessionNews['kind']>(kind: K): News<K>[] =>
    all.filter((one): one is News<K> => one.kind === kind);
  /** Gives a command, and lets what it does at once be done. */
  const take = async (command: SessionCommand) => {
    void session.take(command);
    await clock.advance(0);
  };
  const open = () => take({ kind: 'open-port', port: {}, settings: defaultSettings });
  const send = (id: number, request: Uint8Array, confirmed = false) => take({ kind: 'send', id, request, confirmed });
  const poll = (id: number, request: Uint8Array, interval = 1000, confirmed = false) =>
    take({ kind: 'start-job', id, order: { kind: 'poll', requests: [request], interval }, confirmed });
  const answer = (bytes: Uint8Array, after = 20) => link.replies.push([{ bytes, after }]);
  const results = () => news('result').map(({ id, result }) => [id, result.outcome, result.verdict]);
  const lines = () => news('lines').flatMap(({ lines }) => lines);
  return { clock, link, links, all, news, take, open, send, poll, answer, results, lines };
}

describe('a connection', () => {
  test('to a port that is not there is refused', async () => {
    const { links, open, news } = bench();
    links[0] = undefined;
    await open();
    expect(news('state')).toEqual([{ kind: 'state', state: { kind: 'refused', why: 'cancelled' } }]);
  });

  test('tells each state, and closes', async () => {
    const { open, link, news, take } = bench();
    await open();
    link.lose();
    await take({ kind: 'close' });
    expect(news('state').map(({ state }) => state.kind)).toEqual(['lost', 'closed']);
  });

  test('to another link closes the one before, whose news are told no longer', async () => {
    const { open, link, links, news, clock, send, lines } = bench();
    await open();
    links[0] = new ScriptedLink(clock);
    await open();
    expect(link.state.kind).toBe('closed');
    const told = news('state').length;
    link.lose();
    expect(news('state')).toHaveLength(told);
    await send(1, READ);
    expect(link.written).toEqual([]);
    await clock.advance(2000);
    expect(lines()).toMatchObject([{ verdict: 'silent' }]);
  });

  test('without lines of the adapter says so', async () => {
    const { open, take, news } = bench();
    await take({ kind: 'set-signals', signals: { dtr: true } });
    await open();
    await take({ kind: 'set-signals', signals: { rts: true } });
    const none = { kind: 'signals', set: false, signals: undefined };
    expect(news('signals')).toEqual([none, none]);
  });

  test('counts errors of the line, anew from each opening', async () => {
    const { open, link, clock, news } = bench();
    await open();
    link.error('parity');
    link.error('parity');
    link.error('break');
    await clock.advance(SOON);
    expect(news('errors').at(-1)?.errors).toMatchObject({ parity: 2, break: 1, framing: 0 });
    link.become({ kind: 'opening', adapter: { kind: 'virtual' }, settings: defaultSettings });
    link.error('framing');
    await clock.advance(SOON);
    expect(news('errors').at(-1)?.errors).toMatchObject({ parity: 0, break: 0, framing: 1 });
  });

  test('tells of errors of the line only when their number has changed', async () => {
    const { open, link, clock, news, answer, send } = bench();
    const { errors } = link;
    await open();
    link.error('parity');
    await clock.advance(SOON);
    answer(THREE);
    await send(1, READ);
    await clock.advance(SOON);
    expect(news('lines')).toHaveLength(1);
    expect(news('errors').map(({ errors: { parity } }) => parity)).toEqual([1]);
    // The next opening begins at 0, which is told with it.
    link.become({ kind: 'opening', adapter: { kind: 'virtual' }, settings: defaultSettings });
    await clock.advance(SOON);
    expect(news('errors').map((told) => told.errors)).toEqual([{ ...errors, parity: 1 }, errors]);
  });
});

describe('a request', () => {
  test('is answered: its lines are told before its result', async () => {
    const { open, answer, send, clock, all, lines, news } = bench();
    await open();
    answer(THREE);
    await send(7, READ);
    await clock.advance(20);
    expect(all.map(({ kind }) => kind)).toEqual(['lines', 'result']);
    expect(lines()).toEqual([
      {
        time: 0,
        direction: 'sent',
        transport: 'rtu',
        kind: 'request',
        hex: '1103006B00037687',
        verdict: 'good',
      },
      {
        time: 20,
        direction: 'received',
        transport: 'rtu',
        kind: 'reply',
        hex: '110306AE415652434049AD',
      },
    ]);
    expect(news('result')).toEqual([
      {
        kind: 'result',
        id: 7,
        result: {
          transport: 'rtu',
          request: READ,
          outcome: 'reply',
          reply: THREE,
          verdict: 'good',
          attempts: 1,
          duration: 20,
          echo: 'none',
          findings: [],
          strays: 0,
        },
      },
    ]);
  });

  test('waits for the one before, and both are logged in order', async () => {
    const { open, answer, send, clock, link, results, lines } = bench();
    await open();
    answer(THREE);
    answer(THREE);
    await send(1, READ);
    await send(2, READ);
    expect(link.written).toHaveLength(1);
    await clock.advance(SOON);
    expect(link.written).toHaveLength(2);
    expect(results()).toEqual([
      [1, 'reply', 'good'],
      [2, 'reply', 'good'],
    ]);
    expect(lines().map(({ kind }) => kind)).toEqual(['request', 'reply', 'request', 'reply']);
  });

  test('is sent by the rules that are set', async () => {
    const { open, take, send, clock, news, link } = bench();
    await take({ kind: 'set-rules', rules: { ...defaultRules, timeout: 50, retries: 2 } });
    await open();
    await send(1, READ);
    await clock.advance(1000);
    expect(link.written).toHaveLength(3);
    expect(news('result')[0]?.result).toMatchObject({ outcome: 'silent', verdict: 'bad', attempts: 3 });
    await take({ kind: 'set-rules', rules: defaultRules });
    await send(2, READ);
    await clock.advance(3000);
    expect(link.written).toHaveLength(4);
  });

  test('that stop has cancelled is owed its reply still: it is not taken for the next one', async () => {
    const { open, send, take, clock, results, answer, lines } = bench();
    await open();
    // Three registers from 107 on, and then three others, which are answered in the same form.
    answer(THREE, 300);
    await send(1, READ);
    await take({ kind: 'stop' });
    answer(OTHER_THREE, 20);
    await send(2, READ_OTHERS);
    await clock.advance(3000);
    expect(results()).toEqual([
      [1, 'cancelled', 'ended'],
      [2, 'reply', 'good'],
    ]);
    expect(lines().filter(({ direction }) => direction === 'received')).toMatchObject([
      { kind: 'late' },
      { kind: 'reply', hex: Buffer.from(OTHER_THREE).toString('hex').toUpperCase() },
    ]);
  });

  test('is ended by stop, with those that wait, and the next one is sent', async () => {
    const { open, send, take, clock, results, answer, link } = bench();
    await open();
    await send(1, READ);
    await send(2, READ);
    await take({ kind: 'stop' });
    expect(results()).toEqual([
      [1, 'cancelled', 'ended'],
      [2, 'cancelled', 'ended'],
    ]);
    link.replies.length = 0;
    answer(THREE);
    await send(3, READ);
    // The reply may be the one to the first request, which is given its time, and then another is waited for.
    await clock.advance(4000);
    expect(results().at(-1)).toEqual([3, 'reply', 'doubtful']);
  });

  test('is not sent where nothing was ever connected', async () => {
    const { send, clock, link, take } = bench();
    await send(1, READ);
    await take({ kind: 'stop' });
    await take({ kind: 'close' });
    await clock.advance(SOON);
    expect(link.written).toEqual([]);
  });
});

describe('the adapter is pulled out', () => {
  test('while nothing goes on: what is sent then is not sent', async () => {
    const { open, link, send, clock, results } = bench();
    await open();
    link.lose();
    await send(1, READ);
    await clock.advance(0);
    expect(results()).toEqual([[1, 'not-sent', 'ended']]);
  });

  test('while a request is written, is waited for, is half answered, or waits its turn', async () => {
    for (const at of [0, 5, 15, 25]) {
      const { open, link, send, clock, results, lines } = bench();
      await open();
      link.replies.push([
        { bytes: THREE.subarray(0, 4), after: 10 },
        { bytes: THREE.subarray(4, 6), after: 20 },
      ]);
      await send(1, READ);
      await send(2, READ);
      await clock.advance(at);
      link.lose();
      await clock.advance(SOON);
      expect(results(), `at ${at}`).toEqual([
        [1, 'lost', 'ended'],
        [2, 'lost', 'ended'],
      ]);
      expect(lines().filter(({ kind }) => kind === 'request')).toMatchObject([{ verdict: 'ended' }]);
    }
  });

  test('while a job goes on, which ends', async () => {
    for (const at of [0, 10, 500]) {
      const { open, link, poll, clock, answer, news } = bench();
      await open();
      answer(THREE);
      await poll(4, READ);
      await clock.advance(at);
      link.lose();
      await clock.advance(2000);
      expect(news('job-ended'), `at ${at}`).toEqual([{ kind: 'job-ended', id: 4 }]);
      expect(link.written).toHaveLength(1);
    }
  });
});

describe('a job', () => {
  test('tells what it finds some times a second, and ends when it is stopped', async () => {
    const { open, poll, clock, link, news, take, lines } = bench();
    await open();
    for (let i = 0; i < 100; i++) link.replies.push([{ bytes: THREE, after: 2 }]);
    await poll(4, READ, 10);
    await clock.advance(995);
    const samples = news('jobs').flatMap(({ news }) => news);
    expect(samples.length).toBeGreaterThan(90);
    expect(news('jobs').length).toBeLessThan(20);
    expect(samples[1]).toMatchObject({ id: 4, news: { kind: 'sample', index: 0, round: 1, verdict: 'good' } });
    await take({ kind: 'stop-job', id: 4 });
    await clock.advance(SOON);
    expect(news('job-ended')).toEqual([{ kind: 'job-ended', id: 4 }]);
    const written = link.written.length;
    await clock.advance(1000);
    expect(link.written).toHaveLength(written);
    expect(lines()).toHaveLength(2 * written);
    expect(news('jobs').flatMap(({ news }) => news)).toHaveLength(written);
  });

  test('takes the place of the one with its number, and is ended by stop', async () => {
    const { open, poll, clock, news, take } = bench();
    await open();
    await poll(4, READ, 10);
    await poll(4, READ, 10);
    await clock.advance(5000);
    expect(news('job-ended')).toEqual([]);
    await take({ kind: 'stop' });
    await clock.advance(SOON);
    expect(news('job-ended')).toEqual([{ kind: 'job-ended', id: 4 }]);
  });

  test('has ended at once where nothing is connected', async () => {
    const { poll, news } = bench();
    await poll(4, READ);
    expect(news('job-ended')).toEqual([{ kind: 'job-ended', id: 4 }]);
  });

  test('that writes is refused while read only, and else asked about', async () => {
    const { open, poll, news, take, link } = bench();
    await open();
    await poll(4, WRITE);
    expect(news('refused')).toEqual([{ kind: 'refused', id: 4, why: 'read-only' }]);
    await take({ kind: 'set-read-only', readOnly: false });
    await poll(5, WRITE);
    expect(news('ask-job')).toMatchObject([{ id: 5, why: 'first-write', once: true, order: { kind: 'poll' } }]);
    expect(link.written).toEqual([]);
    await poll(5, WRITE, 1000, true);
    expect(link.written).toHaveLength(1);
  });
});

describe('the guard', () => {
  test('refuses, asks, remembers the device, and forgets it with the line', async () => {
    const { open, send, news, take, link, clock, answer } = bench();
    await open();
    await send(1, WRITE);
    expect(news('refused')).toEqual([{ kind: 'refused', id: 1, why: 'read-only' }]);
    // Even what somebody has said yes to.
    await send(2, WRITE, true);
    expect(news('refused')).toHaveLength(2);
    await take({ kind: 'set-read-only', readOnly: false });
    await send(3, WRITE);
    expect(news('ask')).toEqual([{ kind: 'ask', id: 3, request: WRITE, why: 'first-write', once: true }]);
    expect(link.written).toEqual([]);
    answer(WRITE);
    await send(3, WRITE, true);
    await clock.advance(1000);
    answer(OTHER_WRITE);
    await send(4, OTHER_WRITE);
    await clock.advance(1000);
    expect(link.written.map(({ bytes }) => bytes)).toEqual([WRITE, OTHER_WRITE]);
    await send(5, WRITE_TO_18);
    expect(news('ask').at(-1)).toMatchObject({ id: 5, why: 'first-write' });
    await open();
    await send(6, WRITE);
    expect(news('ask').at(-1)).toMatchObject({ id: 6, why: 'first-write' });
    expect(link.written).toHaveLength(2);
  });

  test('allows one request where only reading is allowed, asks nothing twice, and remembers nothing', async () => {
    const { open, news, take, link, clock, answer } = bench();
    await open();
    const send = (id: number, request: Uint8Array) =>
      take({ kind: 'send', id, request, confirmed: false, allowed: true });
    answer(WRITE);
    await send(1, WRITE);
    await clock.advance(1000);
    expect(link.written.map(({ bytes }) => bytes)).toEqual([WRITE]);
    await take({ kind: 'send', id: 2, request: WRITE, confirmed: false });
    expect(news('refused')).toEqual([{ kind: 'refused', id: 2, why: 'read-only' }]);
    // A broadcast is a question of its own.
    await send(3, BROADCAST);
    expect(news('ask')).toEqual([
      { kind: 'ask', id: 3, request: BROADCAST, why: 'broadcast', once: false, allowed: true },
    ]);
    await take({ kind: 'set-read-only', readOnly: false });
    await take({ kind: 'send', id: 4, request: WRITE, confirmed: false });
    expect(news('ask').at(-1)).toMatchObject({ id: 4, why: 'first-write' });
  });

  test('asks nothing on the virtual bus, and refuses there as elsewhere', async () => {
    const { news, take, clock, results } = bench();
    await take({ kind: 'open-virtual', settings: defaultSettings, pace: 'fast' });
    await take({ kind: 'send', id: 1, request: BROADCAST, confirmed: false });
    expect(news('refused')).toEqual([{ kind: 'refused', id: 1, why: 'read-only' }]);
    await take({ kind: 'set-read-only', readOnly: false });
    // A first write, a broadcast, and a frame that breaks a rule.
    for (const [id, request] of [WRITE, BROADCAST, hex('11 03 00 6B 00 03 76 88')].entries()) {
      await take({ kind: 'send', id, request, confirmed: false });
      await clock.advance(2000);
    }
    expect(news('ask')).toEqual([]);
    expect(results().map(([id]) => id)).toEqual([0, 1, 2]);
  });

  test('asks about each broadcast', async () => {
    const { open, send, news, take, clock, link } = bench();
    await open();
    await take({ kind: 'set-read-only', readOnly: false });
    for (const id of [1, 2]) {
      await send(id, BROADCAST);
      await send(id, BROADCAST, true);
      await clock.advance(1000);
    }
    expect(news('ask').map(({ id, why, once }) => [id, why, once])).toEqual([
      [1, 'broadcast', false],
      [2, 'broadcast', false],
    ]);
    expect(link.written).toHaveLength(2);
  });
});

test('what is heard between requests is logged, and numbers go on', async () => {
  const { open, link, clock, lines, answer, send } = bench();
  await open();
  link.receive(THREE);
  await clock.advance(1000);
  link.receive(hex('FF 00'));
  await clock.advance(1000);
  answer(THREE);
  await send(1, READ);
  await clock.advance(SOON);
  expect(lines().map(({ time, kind, hex }) => [time, kind, hex])).toEqual([
    [0, 'heard', '110306AE415652434049AD'],
    [1000, 'noise', 'FF00'],
    [2000, 'request', '1103006B00037687'],
    [2020, 'reply', '110306AE415652434049AD'],
  ]);
});
