import { describe, expect, it } from 'vitest';
import {
  defaultRules,
  defaultSettings,
  type JobOrder,
  type LinkState,
  type LogLine,
  MOST_LINES,
  noErrors,
  type Refusal,
  type SentResult,
  type SessionCommand,
} from '../../../../src/bus/index.ts';
import { type BusState, type JobEnd, SessionView } from '../../../../src/workbench/bus/session-view.ts';
import { hex } from '../../modbus/frames.ts';

const READ = hex('11 03 00 6B 00 03 76 87');
const WRITE = hex('11 06 00 01 00 03 9A 9B');
const OPEN: LinkState = { kind: 'open', adapter: { kind: 'virtual' }, settings: defaultSettings, since: 0 };
const LOST: LinkState = { kind: 'lost', adapter: { kind: 'virtual' }, why: 'unplugged', at: 0 };
const CLOSED: LinkState = { kind: 'closed' };
const RESULT: SentResult = {
  request: READ,
  outcome: 'silent',
  verdict: 'bad',
  duration: 1000,
  attempts: 1,
  echo: 'none',
  findings: [],
  strays: 0,
};
const POLL: JobOrder = { kind: 'poll', requests: [READ], interval: 1000 };

/** A window with a session, and the commands that it was given since. */
function bench(link: LinkState = OPEN) {
  const commands: SessionCommand[] = [];
  const view = new SessionView({ link, settings: defaultSettings, rules: defaultRules });
  view.attach((command) => commands.push(command));
  commands.length = 0;
  const ends: JobEnd[] = [];
  const news: unknown[] = [];
  const begin = () => view.startJob(POLL, { news: (all) => news.push(...all), ended: (end) => ends.push(end) }, 'rtu');
  return { view, commands, ends, news, begin };
}

const line = (number: number): LogLine => ({
  number,
  time: 0,
  direction: 'sent',
  transport: 'rtu',
  kind: 'request',
  hex: '00',
});

describe('a session that is attached', () => {
  it('is told first what it has to know', () => {
    const commands: SessionCommand[] = [];
    const view = new SessionView({ link: CLOSED, settings: defaultSettings, rules: defaultRules });
    view.setReadOnly(false);
    view.attach((command) => commands.push(command));
    expect(commands).toEqual([
      { kind: 'set-rules', rules: defaultRules },
      { kind: 'set-read-only', readOnly: false },
    ]);
    expect(view.hasSession).toBe(true);
  });
});

describe('a request', () => {
  it('is sent in its mode, and no other until it has ended', () => {
    const { view, commands } = bench();
    view.send(READ, 'ascii');
    view.send(WRITE, 'ascii');
    expect(commands).toEqual([
      { kind: 'set-rules', rules: { ...defaultRules, transport: 'ascii' } },
      { kind: 'send', id: 1, request: READ, confirmed: false },
    ]);
    view.take({ kind: 'result', id: 1, result: RESULT });
    expect(view.state).toMatchObject({ sending: new Map(), last: RESULT });
    view.send(WRITE, 'ascii');
    expect(commands.at(-1)).toEqual({ kind: 'send', id: 2, request: WRITE, confirmed: false });
  });

  it('is sent again once the guard has refused it or somebody has said no', () => {
    const { view, commands } = bench();
    view.send(WRITE, 'rtu');
    view.take({ kind: 'refused', id: 1, why: 'read-only' });
    expect(view.state).toMatchObject({ sending: new Map(), refused: 'read-only' });
    view.send(WRITE, 'rtu');
    view.take({ kind: 'ask', id: 2, request: WRITE, why: 'first-write', once: true });
    expect(view.state.refused).toBeUndefined();
    view.answer(false);
    view.send(WRITE, 'rtu');
    expect(commands.map((command) => 'id' in command && command.id)).toEqual([1, 2, 3]);
  });

  it('is sent as it was asked about when somebody says yes', () => {
    const { view, commands } = bench();
    view.send(WRITE, 'rtu');
    view.take({ kind: 'ask', id: 1, request: WRITE, why: 'first-write', once: true });
    expect(view.state).toMatchObject({ sending: new Map(), question: { why: 'first-write' } });
    view.answer(true);
    expect(commands.at(-1)).toEqual({ kind: 'send', id: 1, request: WRITE, confirmed: true });
    expect(view.state.question).toBeUndefined();
    expect([...view.state.sending.keys()]).toEqual([1]);
    view.answer(true);
    expect(commands).toHaveLength(2);
  });

  it('leaves the mode to the virtual devices while they answer', () => {
    const { view, commands } = bench();
    view.take({ kind: 'serving', on: true });
    view.send(READ, 'ascii');
    expect(commands.map(({ kind }) => kind)).toEqual(['send']);
  });
});

describe('a job', () => {
  it('is told what it finds, and nothing of others', () => {
    const { view, begin, news } = bench();
    begin();
    const sample = { kind: 'sample', index: 0, round: 0, time: 1, outcome: 'silent', verdict: 'bad' } as const;
    view.take({
      kind: 'jobs',
      news: [
        { id: 2, news: { ...sample, index: 7 } },
        { id: 1, news: sample },
      ],
    });
    expect(news).toEqual([sample]);
  });

  it('ends with its own reason, whatever was refused before', () => {
    for (const why of ['read-only', 'serving', 'listening', 'scanning', 'busy'] satisfies Refusal[]) {
      const { view, begin, ends } = bench();
      begin();
      view.set({ refused: undefined });
      view.take({ kind: 'refused', id: 9, why: 'busy' });
      view.take({ kind: 'refused', id: 1, why });
      expect(ends).toEqual([{ kind: 'refused', why }]);
    }
  });

  it('ends once: stopped, lost, disconnected or declined', () => {
    const cases: readonly (readonly [string, (given: ReturnType<typeof bench>, stop: () => void) => void])[] = [
      ['stopped', ({ view }) => view.take({ kind: 'job-ended', id: 1 })],
      [
        'lost',
        ({ view }) => {
          view.take({ kind: 'state', state: LOST });
          view.take({ kind: 'job-ended', id: 1 });
        },
      ],
      [
        'disconnected',
        ({ view }) => {
          view.take({ kind: 'state', state: CLOSED });
          view.take({ kind: 'job-ended', id: 1 });
        },
      ],
      // Whoever has stopped it is not told that the connection was closed meanwhile.
      [
        'stopped',
        ({ view }, stop) => {
          stop();
          view.take({ kind: 'state', state: CLOSED });
          view.take({ kind: 'job-ended', id: 1 });
        },
      ],
      ['disconnected', ({ view }) => view.drop()],
      [
        'lost',
        ({ view }) => {
          view.take({ kind: 'state', state: LOST });
          view.drop();
        },
      ],
      [
        'declined',
        ({ view }) => {
          view.take({ kind: 'ask-job', id: 1, order: POLL, why: 'first-write', once: true });
          view.answer(false);
        },
      ],
    ];
    for (const [kind, end] of cases) {
      const given = bench();
      end(given, given.begin());
      given.view.take({ kind: 'job-ended', id: 1 });
      given.view.drop();
      expect(given.ends).toEqual([{ kind }]);
    }
  });

  it('is stopped as often as it is asked to, until it has ended', () => {
    const { view, begin, commands } = bench();
    const stop = begin();
    stop();
    stop();
    view.take({ kind: 'job-ended', id: 1 });
    stop();
    expect(commands.slice(1)).toEqual([
      { kind: 'stop-job', id: 1 },
      { kind: 'stop-job', id: 1 },
    ]);
  });

  it('begins as it was asked about when somebody says yes', () => {
    const { view, begin, commands } = bench();
    begin();
    view.take({ kind: 'ask-job', id: 1, order: POLL, why: 'broadcast', once: false });
    view.answer(true);
    expect(commands.at(-1)).toEqual({ kind: 'start-job', id: 1, order: POLL, confirmed: true });
  });

  it('is disconnected at once where there is no session', () => {
    const view = new SessionView({ link: CLOSED, settings: defaultSettings, rules: defaultRules });
    const ends: JobEnd[] = [];
    view.startJob(POLL, { news: () => {}, ended: (end) => ends.push(end) });
    expect(ends).toEqual([{ kind: 'disconnected' }]);
  });
});

describe('the log', () => {
  it('keeps the last lines, is cleared, and brought back until others come', () => {
    const { view } = bench();
    view.take({ kind: 'lines', lines: [line(1), line(2)] });
    view.clearLog();
    expect(view.state).toMatchObject({ log: [], cleared: [line(1), line(2)] });
    view.bringLogBack();
    expect(view.state).toMatchObject({ log: [line(1), line(2)], cleared: undefined });
    view.openLog([line(7)]);
    expect(view.state).toMatchObject({ log: [line(7)], cleared: [line(1), line(2)] });
    view.take({ kind: 'lines', lines: [line(8)] });
    expect(view.state).toMatchObject({ log: [line(7), line(8)], cleared: undefined });
    view.take({ kind: 'lines', lines: Array.from({ length: MOST_LINES }, (_, index) => line(index)) });
    expect(view.state.log).toHaveLength(MOST_LINES);
    expect([view.state.log[0]?.number, view.state.log.at(-1)?.number]).toEqual([0, MOST_LINES - 1]);
    view.take({ kind: 'lines', lines: [line(-1), line(-2)] });
    expect(view.state.log).toHaveLength(MOST_LINES);
    expect([view.state.log[0]?.number, view.state.log.at(-1)?.number]).toEqual([2, -2]);
    view.take({ kind: 'lines', lines: Array.from({ length: MOST_LINES + 3 }, (_, index) => line(index)) });
    expect([view.state.log.length, view.state.log[0]?.number]).toEqual([MOST_LINES, 3]);
  });
});

describe('what the session tells', () => {
  it('is in the state, and listeners are told', () => {
    const { view } = bench(CLOSED);
    const seen: BusState[] = [];
    const stop = view.listen((state) => seen.push(state));
    view.take({ kind: 'signals', signals: { cts: true, dsr: false, dcd: false, ri: false }, set: false });
    expect(view.state).toMatchObject({ signals: { cts: true }, signalsTaken: false });
    view.take({ kind: 'state', state: OPEN });
    expect(view.state).toMatchObject({ link: OPEN, signals: undefined, signalsTaken: true });
    view.take({ kind: 'errors', errors: { ...noErrors, parity: 3 } });
    expect(view.state.errors.parity).toBe(3);
    expect(seen).toHaveLength(3);
    stop();
    view.setReadOnly(false);
    expect(seen).toHaveLength(3);
  });

  it('is nothing more when the session is gone', () => {
    const { view, commands } = bench();
    view.send(READ, 'rtu');
    view.take({ kind: 'serving', on: true });
    view.drop();
    expect(view.state).toMatchObject({ sending: new Map(), question: undefined, serving: false, signals: undefined });
    expect(view.hasSession).toBe(false);
    view.stop();
    expect(commands).toHaveLength(1);
  });
});
