import { describe, expect, test } from 'vitest';
import {
  defaultRules,
  defaultSettings,
  requestsOf,
  type SequenceNews,
  Session,
  type SessionNews,
} from '../../../src/bus/index.ts';
import {
  builtInSequences,
  newSequence,
  newStep,
  readSequence,
  type SequenceTexts,
  type StepTexts,
} from '../../../src/sequences/index.ts';
import { hex } from '../modbus/frames.ts';
import { ScriptedLink } from './scripted-link.ts';
import { VirtualClock } from './virtual-clock.ts';

// The WEG drive at 6: P0683 is set to 4096; P0682 to 1 and 0; P0681 is read, as 0, 3999, 4000 and −1.
const SET = '06 06 02 AB 10 00 F5 E5';
const RUN = '06 06 02 AA 00 01 68 25';
const STOP = '06 06 02 AA 00 00 A9 E5';
const READ = '06 03 02 A9 00 01 54 25';
const READ_NEXT = '06 03 02 AA 00 01 A4 25';
const STANDS = '06 03 02 00 00 0D 84';
const NEARLY = '06 03 02 0F 9F 48 1C';
const THERE = '06 03 02 0F A0 08 0C';
const REVERSE = '06 03 02 FF FF 0C 34';
const REFUSES = '06 86 04 F2 62';

const send = (bytes: string, onFailure = 'stop') => newStep('send', { bytes, onFailure });
const wait = (duration: number) => newStep('wait', { duration: String(duration) });
const until = (fields: Readonly<Record<string, string>> = {}) =>
  newStep('until', { unit: '6', address: '681', type: 'i16', relation: '≥', value: '4000', ...fields });
const sequence = (steps: readonly StepTexts[], last: readonly StepTexts[] = [send(STOP)]): SequenceTexts => ({
  ...newSequence('Test'),
  steps,
  finally: last,
});

const ADAPTER_PORT = { usbVendorId: 0x0403, usbProductId: 0x6001 };

/** A session on a link that answers each write with these, 20 ms later; `undefined` is silence. */
async function bench(texts: SequenceTexts, replies: readonly (string | undefined)[]) {
  const clock = new VirtualClock();
  const link = new ScriptedLink(clock);
  link.replies.push(...replies.map((reply) => (reply === undefined ? [] : [{ bytes: hex(reply), after: 20 }])));
  const told: SessionNews[] = [];
  const other = new ScriptedLink(clock);
  const links = [link, other];
  const session = new Session({ clock, portLink: async () => links.shift(), tell: (news) => told.push(news) });
  await session.take({ kind: 'open-port', port: ADAPTER_PORT, settings: defaultSettings });
  await session.take({ kind: 'set-read-only', readOnly: false });
  await session.take({ kind: 'set-rules', rules: { ...defaultRules, echo: 'off' } });
  const reading = readSequence(texts);
  if (reading.kind !== 'sequence') throw new Error(JSON.stringify(reading.faults));
  const order = { kind: 'sequence', sequence: reading.sequence } as const;
  const start = (confirmed = true) => session.take({ kind: 'start-job', id: 1, order, confirmed });
  const jobNews = () =>
    told.flatMap((news) => (news.kind === 'jobs' ? news.news.map(({ news }) => news as SequenceNews) : []));
  return {
    clock,
    link,
    /** What the port leads to when it is opened again. */
    other,
    session,
    told,
    start,
    /** What was written, and when. */
    written: () => link.written.map(({ bytes, at }) => [Math.round(at), Buffer.from(bytes).toString('hex')] as const),
    sent: () => link.written.map(({ bytes }) => Buffer.from(bytes).toString('hex')),
    ends: () => jobNews().flatMap((news) => (news.kind === 'list-ended' ? [`${news.list} ${news.how}`] : [])),
    outcomes: () =>
      jobNews().flatMap((news) =>
        news.kind === 'step-ended' ? [[`${news.place.list} ${news.place.at.join('.')}`, news.outcome] as const] : [],
      ),
    news: jobNews,
  };
}

const plain = (...frames: string[]) => frames.map((frame) => frame.replaceAll(' ', '').toLowerCase());

describe('a sequence', () => {
  test('sends, waits, looks until the condition holds, and carries out its end', async () => {
    const { clock, start, written, outcomes, ends, told } = await bench(builtInSequences[0]!, [
      SET,
      RUN,
      STANDS,
      NEARLY,
      THERE,
      STOP,
    ]);
    await clock.until(start());
    expect(written().map(([, bytes]) => bytes)).toEqual(plain(SET, RUN, READ, READ, READ, STOP));
    const [set = 0, run = 0, first = 0, second = 0, third = 0, stop = 0] = written().map(([time]) => time);
    // 20 ms to the reply, and three times as long behind the first replies of a device; the 10 ms of the guide fall into that.
    expect(run - set).toBe(80);
    // The silence before a frame falls into the intervals, which begin when the reading is due.
    expect(Math.round(second - first)).toBe(80);
    expect(third - second).toBe(60);
    expect(stop - third).toBe(10_020);
    expect(outcomes()).toMatchObject([
      ['steps 0', { kind: 'sent', outcome: 'reply', verdict: 'good', duration: 20, reply: hex(SET) }],
      ['steps 1', { kind: 'waited' }],
      ['steps 2', { kind: 'sent', outcome: 'reply' }],
      ['steps 3', { kind: 'held', value: 4000, requests: 3 }],
      ['steps 4', { kind: 'waited' }],
      ['finally 0', { kind: 'sent', outcome: 'reply' }],
    ]);
    expect(ends()).toEqual(['steps done', 'finally done']);
    expect(told.filter(({ kind }) => kind === 'job-ended')).toEqual([{ kind: 'job-ended', id: 1 }]);
  });

  test('is asked about before it begins, the finally list too', async () => {
    const { clock, start, session, told, sent } = await bench(sequence([wait(10)]), []);
    await clock.until(start(false));
    expect(told.at(-1)).toMatchObject({ kind: 'ask-job', id: 1, why: 'first-write', once: true });
    await session.take({ kind: 'set-read-only', readOnly: true });
    await clock.until(start(true));
    expect(told.at(-1)).toEqual({ kind: 'refused', id: 1, why: 'read-only' });
    expect(sent()).toEqual([]);
  });

  test('is asked about by each of its requests once, those that change something first', () => {
    const repeat = { ...newStep('repeat'), steps: [send(RUN), until(), send(RUN)] };
    const reading = readSequence(sequence([until(), repeat]));
    if (reading.kind !== 'sequence') throw new Error('no sequence');
    const requests = requestsOf({ kind: 'sequence', sequence: reading.sequence });
    expect(requests.map((bytes) => Buffer.from(bytes).toString('hex'))).toEqual(plain(RUN, STOP, READ));
  });

  test('ends by what fails, or goes on where it is to', async () => {
    const refused = await bench(sequence([send(RUN), send(SET)]), [REFUSES, STOP]);
    await refused.clock.until(refused.start());
    expect(refused.sent()).toEqual(plain(RUN, STOP));
    expect(refused.outcomes()[0]).toMatchObject(['steps 0', { outcome: 'exception', verdict: 'refused' }]);
    expect(refused.ends()).toEqual(['steps failed', 'finally done']);

    const silent = await bench(sequence([send(RUN), send(SET)]), [undefined, STOP]);
    await silent.clock.until(silent.start());
    expect(silent.sent()).toEqual(plain(RUN, STOP));
    expect(silent.outcomes()[0]).toMatchObject(['steps 0', { outcome: 'silent', verdict: 'bad' }]);

    const onward = await bench(sequence([send(RUN, 'go-on'), send(SET)]), [REFUSES, SET, STOP]);
    await onward.clock.until(onward.start());
    expect(onward.sent()).toEqual(plain(RUN, SET, STOP));
    expect(onward.ends()).toEqual(['steps done', 'finally done']);
  });

  test('fails by a reply that may be the one to a request before, and says so', async () => {
    const { clock, start, sent, outcomes, ends } = await bench(
      sequence([send(READ, 'go-on'), send(READ_NEXT), send(SET)]),
      [undefined, STANDS, STOP],
    );
    await clock.until(start());
    expect(sent()).toEqual(plain(READ, READ_NEXT, STOP));
    expect(outcomes()).toMatchObject([
      ['steps 0', { outcome: 'silent', verdict: 'bad' }],
      ['steps 1', { outcome: 'reply', verdict: 'doubtful', unsure: 'perhaps-late' }],
      ['finally 0', { outcome: 'reply', verdict: 'good' }],
    ]);
    expect(ends()).toEqual(['steps failed', 'finally done']);
  });

  test('carries out all of the finally list, whatever fails in it', async () => {
    const { clock, start, sent, ends } = await bench(sequence([send(RUN)], [send(STOP), send(SET)]), [
      RUN,
      REFUSES,
      SET,
    ]);
    await clock.until(start());
    expect(sent()).toEqual(plain(RUN, STOP, SET));
    expect(ends()).toEqual(['steps done', 'finally failed']);
  });

  test('repeats, and tells the round', async () => {
    const inner = { ...newStep('repeat', { times: '2' }), steps: [send(RUN)] };
    const outer = { ...newStep('repeat', { times: '3' }), steps: [send(SET), inner] };
    const { clock, start, sent, news, outcomes } = await bench(sequence([outer]), [
      ...[1, 2, 3].flatMap(() => [SET, RUN, RUN]),
      STOP,
    ]);
    await clock.until(start());
    expect(sent()).toEqual(plain(...[1, 2, 3].flatMap(() => [SET, RUN, RUN]), STOP));
    const rounds = news().flatMap((one) =>
      one.kind === 'step-began' && one.place.at.join('.') === '0.1.0' ? [one.rounds] : [],
    );
    expect(rounds).toEqual([
      [0, 0],
      [0, 1],
      [1, 0],
      [1, 1],
      [2, 0],
      [2, 1],
    ]);
    expect(outcomes()).toContainEqual(['steps 0', { kind: 'repeated', times: 3 }]);
  });

  test('ends a repetition by what fails in it', async () => {
    const repeat = { ...newStep('repeat', { times: '3' }), steps: [send(RUN)] };
    const { clock, start, sent, outcomes } = await bench(sequence([repeat, send(SET)]), [RUN, REFUSES, STOP]);
    await clock.until(start());
    expect(sent()).toEqual(plain(RUN, RUN, STOP));
    expect(outcomes()).toContainEqual(['steps 0', { kind: 'failed' }]);
  });
});

describe('a condition', () => {
  const first = async (fields: Readonly<Record<string, string>>, ...replies: (string | undefined)[]) => {
    const { clock, start, outcomes, written } = await bench(sequence([until(fields)], []), replies);
    await clock.until(start());
    return { outcome: outcomes()[0]?.[1], written: written() };
  };

  test('is over after its time, with the value read last', async () => {
    const { outcome, written } = await first({ timeout: '250' }, STANDS, NEARLY, NEARLY);
    expect(outcome).toEqual({ kind: 'timed-out', value: 3999, requests: 3 });
    expect(written.map(([at]) => at)).toEqual([0, 100, 200]);
  });

  test('goes on reading through silence, which takes no longer than it may itself', async () => {
    expect(await first({ timeout: '3000' }, undefined, THERE)).toMatchObject({
      outcome: { kind: 'held', requests: 2 },
    });
    const { outcome, written } = await first({ timeout: '300' }, undefined);
    expect(outcome).toEqual({ kind: 'timed-out', requests: 1 });
    expect(written).toHaveLength(1);
  });

  test('reads signed and unsigned values, bits, coils and values of two registers', async () => {
    expect((await first({ relation: '=', value: '-1' }, REVERSE)).outcome).toMatchObject({ kind: 'held', value: -1 });
    expect((await first({ relation: '=', value: '0xFFFF', type: 'u16' }, REVERSE)).outcome).toMatchObject({
      value: 65535,
    });
    // 0x0FA0: bit 5 is 1, bit 6 is 0
    expect((await first({ bit: '5', relation: '=', value: '1' }, THERE)).outcome).toMatchObject({ value: 1 });
    expect((await first({ bit: '6', relation: '=', value: '0' }, THERE)).outcome).toMatchObject({ value: 0 });
    const coil = await first({ table: 'coil', relation: '=', value: '1' }, '06 01 01 01 91 3C');
    expect(coil).toMatchObject({
      outcome: { kind: 'held', value: 1 },
      written: [[0, ...plain('06 01 02 A9 00 01 2D E5')]],
    });
    // low register first
    const wide = await first({ type: 'u32', order: 'CDAB', relation: '=', value: '1' }, '06 03 04 00 01 00 00 DD 33');
    expect(wide).toMatchObject({
      outcome: { kind: 'held', value: 1 },
      written: [[0, ...plain('06 03 02 A9 00 02 14 24')]],
    });
  });

  test('compares by each relation', async () => {
    const ofThree = async (relation: string, value: string) =>
      (await first({ relation, value, timeout: '50' }, NEARLY)).outcome?.kind === 'held';
    const table = await Promise.all(
      ['=', '≠', '<', '≤', '>', '≥'].map(async (relation) => [
        relation,
        ...(await Promise.all(['3998.5', '3999', '4000'].map((value) => ofThree(relation, value)))),
      ]),
    );
    expect(table).toEqual([
      ['=', false, true, false],
      ['≠', true, false, true],
      ['<', false, false, true],
      ['≤', false, true, true],
      ['>', true, false, false],
      ['≥', true, true, false],
    ]);
  });
});

describe('stopped', () => {
  const stopJob = { kind: 'stop-job', id: 1 } as const;

  test('in a wait, it carries out its end at once', async () => {
    const { clock, start, session, written, ends, outcomes } = await bench(sequence([send(RUN), wait(10_000)]), [
      RUN,
      STOP,
    ]);
    const ended = start();
    await clock.advance(500);
    await session.take(stopJob);
    await clock.until(ended);
    expect(written().at(-1)).toEqual([500, ...plain(STOP)]);
    expect(outcomes()[1]).toEqual(['steps 1', { kind: 'stopped' }]);
    expect(ends()).toEqual(['steps stopped', 'finally done']);
  });

  test('while a reply is waited for, it takes the reply first', async () => {
    const { clock, start, session, written } = await bench(sequence([send(RUN), send(SET)]), [RUN, STOP]);
    const ended = start();
    await clock.advance(10);
    await session.take(stopJob);
    await clock.until(ended);
    expect(written().map(([, bytes]) => bytes)).toEqual(plain(RUN, STOP));
    expect(written()[1]![0]).toBeGreaterThanOrEqual(20);
  });

  test('twice before its end has begun, it carries that out all the same; once more ends it', async () => {
    const { clock, start, session, sent, ends } = await bench(
      sequence([send(RUN)], [send(STOP), wait(5000), send(SET)]),
      [RUN, STOP],
    );
    const ended = start();
    await clock.advance(10);
    await session.take(stopJob);
    await session.take(stopJob);
    await clock.advance(1000);
    expect(sent()).toEqual(plain(RUN, STOP));
    await session.take(stopJob);
    await clock.until(ended);
    expect(sent()).toEqual(plain(RUN, STOP));
    expect(ends()).toEqual(['steps done', 'finally stopped']);
  });

  test('for the first time in its end, it goes on with that, and sends again what was cancelled', async () => {
    const last = [send(STOP), wait(1000), send(SET)];
    const late = await bench(sequence([send(RUN)], last), [RUN, STOP, SET]);
    const lateEnded = late.start();
    await late.clock.advance(500);
    await late.session.take(stopJob);
    await late.clock.until(lateEnded);
    expect(late.sent()).toEqual(plain(RUN, STOP, SET));
    expect(late.ends()).toEqual(['steps done', 'finally done']);

    const all = await bench(sequence([wait(10)], last), [undefined, STOP, SET]);
    const allEnded = all.start();
    await all.clock.advance(100);
    await all.session.take({ kind: 'stop' });
    await all.clock.until(allEnded);
    expect(all.sent()).toEqual(plain(STOP, STOP, SET));
    expect(all.ends()).toEqual(['steps done', 'finally done']);
  });

  test('with all else that goes on, and by a disconnection, it still carries out its end', async () => {
    for (const kind of ['stop', 'close'] as const) {
      const { clock, start, session, sent, link, ends } = await bench(sequence([send(RUN), until()]), [
        RUN,
        undefined,
        STOP,
      ]);
      const ended = start();
      await clock.advance(100);
      expect(sent()).toEqual(plain(RUN, READ));
      const taken = session.take({ kind });
      await clock.until(ended);
      await clock.until(taken);
      expect(sent(), kind).toEqual(plain(RUN, READ, STOP));
      expect(ends(), kind).toEqual(['steps stopped', 'finally done']);
      expect(link.state.kind).toBe(kind === 'close' ? 'closed' : 'open');
    }
  });

  test('by another line being opened, it ends on its own line first', async () => {
    const { clock, start, session, sent, link, other } = await bench(sequence([send(RUN), wait(10_000)]), [RUN, STOP]);
    const ended = start();
    await clock.advance(100);
    await clock.until(session.take({ kind: 'open-port', port: ADAPTER_PORT, settings: defaultSettings }));
    await clock.until(ended);
    expect(sent()).toEqual(plain(RUN, STOP));
    expect(link.state.kind).toBe('closed');
    expect(other.written).toEqual([]);
  });

  test('by the loss of the adapter, it says that its end was lost too', async () => {
    const { clock, start, sent, link, ends, outcomes } = await bench(sequence([send(RUN), until(), send(SET)]), [RUN]);
    const ended = start();
    await clock.advance(100);
    link.lose();
    await clock.until(ended);
    expect(sent()).toEqual(plain(RUN, READ));
    expect(ends()).toEqual(['steps lost', 'finally lost']);
    expect(outcomes().at(-1)).toEqual(['finally 0', { kind: 'lost' }]);
  });
});
