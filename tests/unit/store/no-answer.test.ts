import { type ReadonlySignal, signal } from '@preact/signals-core';
import { describe, expect, it } from 'vitest';
import {
  type DeviceSetup,
  defaultSettings,
  type FaultRule,
  type LinkSettings,
  type LinkState,
  type Port,
  Session,
  sourceSetups,
} from '../../../src/bus/index.ts';
import { Bus, Line, NoAnswer, Scan } from '../../../src/store/index.ts';
import type { NoAnswerStep, Unanswered } from '../../../src/workbench/index.ts';
import { AnsweringLink } from '../bus/answering-link.ts';
import { framed } from '../bus/late-line.ts';
import { VirtualClock } from '../bus/virtual-clock.ts';
import { hex } from '../modbus/frames.ts';
import { linePage, noTrace, TestBrowser } from './window.ts';

// The devices of the sources are units 1, 6, 9, 17 and 33, at 19200 baud, 8E1.
const READ_5 = framed(5, 3, 0, 0, 0, 4);
const READ_33 = hex('21 03 03 E7 00 04 F3 1A');
const WRITE_6 = hex('06 06 02 AB 10 00 F5 E5');

interface Given {
  readonly settings?: Partial<LinkSettings>;
  readonly faults?: readonly FaultRule[];
  readonly devices?: readonly DeviceSetup[];
  readonly current?: Uint8Array;
  /** What answers on a port in place of the virtual devices. */
  readonly answer?: (request: Uint8Array, settings: LinkSettings) => readonly [number, Uint8Array] | undefined;
}

/** A window on the virtual bus, on a clock that is moved by hand. */
async function bench({ settings, faults = [], devices = sourceSetups(), current = READ_5, answer }: Given = {}) {
  const clock = new VirtualClock();
  const storage = new TestBrowser().tab();
  const bus = new Bus<Port>({
    link: signal<LinkState>({ kind: 'closed' }),
    line: new Line(linePage(), storage, signal(undefined), signal(false)),
    serial: undefined,
    inWorker(tell) {
      const session = new Session({ clock, portLink: async () => answer && new AnsweringLink(clock, answer), tell });
      return { post: (command) => void session.take(command), end: () => undefined };
    },
    inWindow: () => ({ post: () => undefined, end: () => undefined }),
    trace: noTrace,
    storage,
  });
  bus.settings.value = { ...defaultSettings, ...settings };
  bus.virtual.setDevices(devices);
  bus.virtual.setFaults(faults);
  if (answer) await bus.open({ getInfo: () => ({}) });
  else bus.openVirtual();
  await clock.advance(100);
  const scan = new Scan(bus, storage);
  const frame: ReadonlySignal<Unanswered> = signal({ request: current, transport: 'rtu' });
  const noAnswer = new NoAnswer(bus, scan, frame);
  const mark = (step: NoAnswerStep) => noAnswer.marks.value.get(step);
  const run = async (step: NoAnswerStep, milliseconds = 120_000) => {
    noAnswer.start(step);
    expect(noAnswer.running.value).toBe(step);
    await clock.advance(milliseconds);
    expect(noAnswer.running.value).toBeUndefined();
    return mark(step);
  };
  return { bus, clock, scan, noAnswer, mark, run };
}

describe('no device answers', () => {
  it('because the unit is another: those that answer are found, and the line is good', async () => {
    const { bus, clock, noAnswer, mark, run } = await bench({ current: READ_33 });
    bus.send(READ_5, 'rtu');
    await clock.advance(2000);
    expect([noAnswer.about.value?.request, noAnswer.wasAsked.value]).toEqual([READ_5, true]);
    expect(mark('unit')).toEqual({ state: 'open' });
    const plan = noAnswer.plan('unit');
    // 247 units, each waited for 100 ms, and the time of the request.
    expect(plan.kind === 'scan' && Math.round(plan.time / 1000)).toBe(26);
    expect(await run('unit')).toEqual({
      state: 'found',
      finding: { code: 'others-answer', unit: 5, units: [1, 6, 9, 17, 33] },
    });
    expect(mark('echo')).toEqual({ state: 'excluded', finding: { code: 'ruled-out', by: 'unit' } });
    expect(mark('wires')).toEqual({ state: 'open' });
    expect(mark('line')).toEqual({ state: 'open' });
  });

  it('though its unit is there: what is wrong is the request, not the line', async () => {
    const { mark, run } = await bench({ current: READ_33 });
    expect(await run('unit')).toEqual({ state: 'excluded', finding: { code: 'unit-answers', unit: 33 } });
    for (const step of ['line', 'echo', 'wires', 'power'] as const)
      expect(mark(step)).toMatchObject({ state: 'excluded', finding: { code: 'ruled-out', by: 'unit' } });
    for (const step of ['gap', 'length', 'termination'] as const) expect(mark(step)).toEqual({ state: 'open' });
  });

  it('because the line has another speed: the speed is found, the rest is not tried, and the line is put back', async () => {
    const answer: Given['answer'] = (request, { baud, parity }) =>
      request[0] === 0x21 && baud === 19_200 && parity === 'even' ? [20, framed(0x21, 3, 2, 0, 7)] : undefined;
    const { bus, run } = await bench({ current: READ_33, settings: { baud: 9600, parity: 'none' }, answer });
    expect(await run('unit')).toEqual({ state: 'tried', finding: { code: 'none-answers', asked: 247 } });
    expect(await run('line')).toEqual({
      state: 'found',
      finding: { code: 'other-line-answers', settings: { ...defaultSettings, baud: 19_200, parity: 'even' } },
    });
    expect(bus.link.value).toMatchObject({ kind: 'open', settings: { baud: 9600, parity: 'none' } });
  });

  it('at any usual speed: nothing is excluded, and it says how many were tried', async () => {
    const { run } = await bench({ current: READ_5 });
    expect(await run('line')).toEqual({
      state: 'tried',
      finding: { code: 'lines-silent', tried: 32, notOpened: 0 },
    });
  });

  it('at the speed that the line has: the device is there', async () => {
    const { run, mark } = await bench({ current: READ_33 });
    expect(await run('line')).toMatchObject({ state: 'excluded', finding: { code: 'line-answers' } });
    expect(mark('wires')).toMatchObject({ state: 'excluded' });
  });

  it('because it takes long, or needs a longer silence', async () => {
    const late: FaultRule = { fault: { kind: 'late', by: 3000 } };
    const { bus, run } = await bench({ current: READ_33, faults: [late] });
    bus.setRules({ ...bus.rules.value, timeout: 200 });
    expect(await run('gap')).toEqual({ state: 'found', finding: { code: 'answers-late' } });
  });

  it('to a long request: half of it is read, and nothing is written', async () => {
    const { run, noAnswer } = await bench({ current: READ_33 });
    expect(await run('length')).toEqual({ state: 'found', finding: { code: 'answers-half' } });
    const plan = noAnswer.plan('length');
    // Two registers in place of four.
    expect(plan.kind === 'trials' && plan.order.trials.map(({ request }) => request)).toEqual([
      framed(0x21, 3, 3, 0xe7, 0, 2),
    ]);
  });

  it('but the adapter returns the request, or nothing', async () => {
    const { run } = await bench({ current: READ_5 });
    expect(await run('echo')).toEqual({ state: 'tried', finding: { code: 'nothing-returned' } });
    const echoing = await bench({ current: READ_5, answer: (request) => [5, request] });
    expect(await echoing.run('echo')).toEqual({ state: 'excluded', finding: { code: 'returned' } });
  });
});

describe('a step', () => {
  it('is stopped, says how far it was, and can be begun again', async () => {
    const { clock, noAnswer, mark } = await bench({ devices: [] });
    noAnswer.start('unit');
    await clock.advance(1000);
    expect(mark('unit')).toEqual({ state: 'running', finding: undefined });
    expect(noAnswer.progress.value).toMatchObject({ total: 247 });
    noAnswer.start('gap');
    expect(noAnswer.running.value).toBe('unit');
    noAnswer.stop();
    await clock.advance(1000);
    expect(mark('unit')).toMatchObject({ state: 'open', finding: { code: 'stopped', total: 247 } });
    noAnswer.start('unit');
    expect(mark('unit')).toEqual({ state: 'running', finding: undefined });
  });

  it('passes the guard: what may change a device is not sent while only reading is allowed', async () => {
    const { clock, noAnswer, mark, bus } = await bench({ current: WRITE_6 });
    noAnswer.start('gap');
    await clock.advance(1000);
    expect([noAnswer.running.value, noAnswer.refused.value]).toEqual([undefined, 'read-only']);
    expect(mark('gap')).toEqual({ state: 'open' });
    // A single register cannot be half.
    expect(noAnswer.plan('length')).toEqual({ kind: 'impossible' });
    bus.setReadOnly(false);
    noAnswer.start('gap');
    await clock.advance(10_000);
    expect(noAnswer.refused.value).toBeUndefined();
    expect(mark('gap')).toMatchObject({ finding: { code: 'answers-after-silence' } });
  });

  it('waits for the scan of somebody else', async () => {
    const { clock, scan, noAnswer } = await bench();
    const plan = noAnswer.plan('unit');
    if (plan.kind !== 'scan') throw new Error();
    scan.start({ ...plan.order });
    await clock.advance(500);
    expect([noAnswer.busy.value, noAnswer.running.value]).toEqual([true, undefined]);
    noAnswer.start('unit');
    expect(noAnswer.running.value).toBeUndefined();
  });

  it('that no page can carry out is marked by hand, and taken back; another request begins anew', async () => {
    const { bus, clock, noAnswer, mark } = await bench();
    expect(noAnswer.plan('wires')).toEqual({ kind: 'by-hand' });
    noAnswer.check('wires');
    expect(mark('wires')).toEqual({ state: 'excluded', finding: { code: 'checked' } });
    // The current frame, which is sent now and not answered, is the same.
    bus.send(READ_5, 'rtu');
    await clock.advance(2000);
    expect(mark('wires')).toMatchObject({ state: 'excluded' });
    noAnswer.check('wires');
    expect(mark('wires')).toEqual({ state: 'open' });
    noAnswer.check('power');
    bus.send(framed(7, 3, 0, 0, 0, 4), 'rtu');
    await clock.advance(2000);
    expect(mark('power')).toEqual({ state: 'open' });
  });
});
