import { effect, signal } from '@preact/signals-core';
import { describe, expect, it } from 'vitest';
import { type LinkState, type Port, Session, sourceSetups } from '../../../src/bus/index.ts';
import { plainRegister } from '../../../src/devices/index.ts';
import { builtInSequences, readSequence } from '../../../src/sequences/index.ts';
import { Bus, Line, Listening, Poll, Scan, SequenceRun } from '../../../src/store/index.ts';
import { defaultScan, type PollSource, scanOrder } from '../../../src/workbench/index.ts';
import { VirtualClock } from '../bus/virtual-clock.ts';
import { hex } from '../modbus/frames.ts';
import { linePage, noTrace, TestBrowser } from './window.ts';

// The WEG drive, unit 6: its registers 681 and 682 (P0681 and P0682).
const READ = hex('06 03 02 A9 00 02 14 24');
const [weg] = builtInSequences;

const value = (at: number) => ({
  name: `P068${at + 1}`,
  place: '',
  register: { ...plainRegister, name: '', table: 'holding-register', address: 681 + at, type: 'u16' } as const,
  where: { read: 0, at, size: 1 },
});
const source: PollSource = {
  title: 'WEG',
  transport: 'rtu',
  requests: [READ],
  reads: [{ quantity: 2, width: 1 }],
  values: [value(0), value(1)],
  unreadable: [],
};

/** A window whose session works in it, on a clock that is moved by hand. Nothing is connected at first. */
function bench() {
  const clock = new VirtualClock();
  const browser = new TestBrowser();
  const storage = browser.tab();
  let die = () => {};
  const bus = new Bus<Port>({
    link: signal<LinkState>({ kind: 'closed' }),
    line: new Line(linePage(), storage, signal(undefined), signal(false)),
    serial: undefined,
    inWorker(tell, ended) {
      die = () => ended('died');
      const session = new Session({ clock, portLink: async () => undefined, tell });
      return { post: (command) => void session.take(command), end: () => undefined };
    },
    inWindow: () => ({ post: () => undefined, end: () => undefined }),
    trace: noTrace,
    storage,
  });
  return { bus, clock, browser, storage, die: () => die() };
}

/** The same, connected to the virtual bus. */
async function connected() {
  const given = bench();
  given.bus.virtual.setDevices(sourceSetups());
  given.bus.openVirtual();
  await given.clock.advance(100);
  expect(given.bus.connected.value).toBe(true);
  return given;
}

describe('a poll', () => {
  it('reads the same again and again, until it is stopped', async () => {
    const { bus, clock, storage } = await connected();
    const poll = new Poll(bus, storage);
    poll.settings.value = { ...poll.settings.value, interval: 500 };
    expect([poll.running.value, poll.end.value, poll.polled.value]).toEqual([false, undefined, undefined]);
    poll.start(source);
    await clock.advance(2400);
    expect(poll.polled.value).toMatchObject({ source, interval: 500, requests: 5, failed: 0, drawn: [0, 1] });
    expect(poll.polled.value?.samples.rounds).toBe(5);
    expect(poll.polled.value?.samples.last).toEqual([0, 0]);
    poll.start({ ...source, title: 'another' });
    expect([poll.running.value, poll.source.value?.title]).toEqual([true, 'WEG']);
    poll.stop();
    await clock.advance(1000);
    expect([poll.running.value, poll.end.value]).toEqual([false, { kind: 'stopped' }]);
    expect(poll.polled.value?.requests).toBe(5);
  });

  it('goes on after its session has died, and keeps what it has read', async () => {
    const { bus, clock, storage, die } = await connected();
    const poll = new Poll(bus, storage);
    poll.start(source);
    await clock.advance(1500);
    const requests = poll.polled.value?.requests ?? 0;
    die();
    await clock.advance(1500);
    expect(poll.end.value).toEqual({ kind: 'disconnected' });
    expect(poll.polled.value).toMatchObject({ requests, failed: 0 });
    bus.openVirtual();
    await clock.advance(100);
    poll.goOn();
    await clock.advance(1500);
    expect(poll.running.value).toBe(true);
    expect(poll.polled.value?.requests).toBeGreaterThan(requests);
  });

  it('is disconnected by hand, also between two rounds, and goes on; a poll that was stopped is stopped', async () => {
    const { bus, clock, storage } = await connected();
    const poll = new Poll(bus, storage);
    for (const moment of [1, 500]) {
      poll.start(source);
      await clock.advance(2000 + moment);
      bus.disconnect();
      await clock.advance(1500);
      expect([bus.connected.value, poll.end.value]).toEqual([false, { kind: 'disconnected' }]);
      bus.openVirtual();
      await clock.advance(100);
      poll.goOn();
      await clock.advance(100);
      expect(poll.running.value).toBe(true);
      // Another line in place of this one ends it in the same way.
      bus.openVirtual();
      await clock.advance(1500);
      expect(poll.end.value).toEqual({ kind: 'disconnected' });
    }
    poll.start(source);
    await clock.advance(2500);
    poll.stop();
    bus.disconnect();
    await clock.advance(1500);
    expect(poll.end.value).toEqual({ kind: 'stopped' });
  });

  it('is not begun without a connection', () => {
    const { bus, storage } = bench();
    const poll = new Poll(bus, storage);
    poll.goOn();
    expect(poll.end.value).toBeUndefined();
    poll.start(source);
    expect(poll.end.value).toEqual({ kind: 'disconnected' });
  });

  it('tells 17 times a second at most that something was read, and only then that its source or what is drawn is another', async () => {
    const { bus, clock, storage } = await connected();
    bus.setPace('fast');
    await clock.advance(100);
    const poll = new Poll(bus, storage);
    poll.settings.value = { ...poll.settings.value, interval: 0 };
    let [told, sources, drawings] = [0, 0, 0];
    effect(() => {
      poll.polled.value;
      told++;
    });
    effect(() => {
      poll.source.value;
      sources++;
    });
    effect(() => {
      poll.drawn.value;
      drawings++;
    });
    poll.start(source);
    [told, sources, drawings] = [0, 0, 0];
    await clock.advance(2000);
    expect(poll.polled.value?.requests).toBeGreaterThan(60);
    expect(told).toBeGreaterThan(20);
    expect(told).toBeLessThanOrEqual(34);
    expect([sources, drawings]).toEqual([0, 0]);
    poll.draw(0, false);
    expect([poll.drawn.value, drawings]).toEqual([[1], 1]);
  });

  it('keeps its settings', async () => {
    const { bus, browser, storage } = bench();
    const poll = new Poll(bus, storage);
    poll.settings.value = { ...poll.settings.value, from: 'device', interval: 7 };
    expect(new Poll(bus, browser.tab()).settings.value).toMatchObject({ from: 'device', interval: 7 });
  });
});

describe('a scan', () => {
  it('finds units as it goes, and forgets them when the next begins', async () => {
    const { bus, clock, storage } = await connected();
    const scan = new Scan(bus, storage);
    const order = scanOrder({ ...defaultScan, lastUnit: 8 }, bus.settings.value)!;
    scan.start(order);
    await clock.advance(10_000);
    expect([scan.running.value, scan.end.value]).toEqual([false, { kind: 'stopped' }]);
    expect(scan.progress.value).toMatchObject({ done: 8, total: 8 });
    const units = sourceSetups().flatMap(({ unit }) => (unit <= 8 ? [unit] : []));
    expect(scan.found.value.map((one) => one.what === 'unit' && one.unit)).toEqual(units);
    scan.start(order);
    expect([scan.running.value, scan.found.value, scan.progress.value]).toEqual([true, [], undefined]);
  });
});

describe('listening', () => {
  it('holds the line, and counts nothing where nobody speaks', async () => {
    const { bus, clock } = await connected();
    const listening = new Listening(bus);
    listening.start();
    await clock.advance(500);
    expect([listening.running.value, listening.heard.value]).toEqual([
      true,
      { kind: 'heard', counts: [], frames: 0, noise: 0 },
    ]);
    bus.send(READ, 'rtu');
    await clock.advance(100);
    expect(bus.refused.value).toBe('listening');
    listening.stop();
    await clock.advance(100);
    expect(listening.end.value).toEqual({ kind: 'stopped' });
  });
});

describe('the run of a sequence', () => {
  async function run() {
    const given = await connected();
    const reading = readSequence(weg!);
    if (reading.kind !== 'sequence') throw new Error(JSON.stringify(reading.faults));
    const run = new SequenceRun(given.bus);
    const start = () => run.start(reading.sequence, weg!);
    /** Starts it, and allows what it sends. */
    const allowed = async () => {
      given.bus.setReadOnly(false);
      start();
      await given.clock.advance(4000);
    };
    const marks = () => Object.fromEntries(run.marks.value);
    return { ...given, run, start, allowed, marks };
  }

  it('is refused while “Read only” is on, and nobody is asked about virtual devices', async () => {
    const { bus, clock, run: sequence, start } = await run();
    expect(sequence.phase.value).toEqual({ kind: 'idle' });
    start();
    await clock.advance(0);
    expect(sequence.phase.value).toEqual({ kind: 'not-begun', why: 'read-only' });
    bus.setReadOnly(false);
    start();
    await clock.advance(100);
    expect([sequence.phase.value, bus.question.value]).toEqual([{ kind: 'running', list: 'steps' }, undefined]);
  });

  it('marks its steps, and carries out the finally list when it is stopped once', async () => {
    const { clock, run: sequence, allowed, marks } = await run();
    await allowed();
    expect(sequence.phase.value).toEqual({ kind: 'running', list: 'steps' });
    expect(marks()).toMatchObject({
      'steps 0': { kind: 'ended', outcome: { kind: 'sent', outcome: 'reply' } },
      'steps 3': { kind: 'ended', outcome: { kind: 'held' } },
      'steps 4': { kind: 'running' },
    });
    sequence.stopLast();
    sequence.stopSteps();
    sequence.stopSteps();
    await clock.advance(1000);
    expect(sequence.phase.value).toEqual({ kind: 'ended', how: 'stopped', last: 'done' });
    expect(marks()).toMatchObject({
      'steps 4': { outcome: { kind: 'stopped' } },
      'finally 0': { outcome: { kind: 'sent' } },
    });
  });

  it('is lost with its session, and the step that it was at', async () => {
    const { die, run: sequence, allowed, marks } = await run();
    await allowed();
    die();
    expect(sequence.phase.value).toEqual({ kind: 'ended', how: 'lost', last: 'lost' });
    expect(marks()['steps 4']).toEqual({ kind: 'ended', outcome: { kind: 'lost' } });
  });
});
