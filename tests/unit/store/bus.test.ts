import { computed, signal } from '@preact/signals-core';
import { describe, expect, it } from 'vitest';
import {
  defaultRules,
  defaultSettings,
  type JobNews,
  type JobOrder,
  type LinkState,
  noErrors,
  type Port,
  type PortChoice,
  type Ports,
  type Refusal,
  type SentResult,
  type SessionCommand,
  type SessionNews,
} from '../../../src/bus/index.ts';
import { Bus, type JobState, Line } from '../../../src/store/index.ts';
import type { DeviceLine } from '../../../src/workbench/index.ts';
import { hex } from '../modbus/frames.ts';
import { linePage, noTrace, TestBrowser, TestWindow } from './window.ts';

const READ = hex('11 03 00 6B 00 03 76 87');
const WRITE = hex('11 06 00 01 00 03 9A 9B');
const OPEN: LinkState = { kind: 'open', adapter: { kind: 'virtual' }, settings: defaultSettings, since: 0 };
const LOST: LinkState = { kind: 'lost', adapter: { kind: 'virtual' }, why: 'unplugged', at: 0 };
const VIRTUAL = { kind: 'virtual' } as const;
const OPENING: LinkState = { kind: 'opening', adapter: VIRTUAL, settings: defaultSettings };
const CLOSED: LinkState = { kind: 'closed' };
const RESULT: SentResult = {
  request: READ,
  transport: 'rtu',
  outcome: 'silent',
  verdict: 'bad',
  duration: 1000,
  attempts: 1,
  echo: 'none',
  findings: [],
  strays: 0,
};
const POLL: JobOrder = { kind: 'poll', requests: [READ], interval: 1000 };
const FTDI: PortChoice = { usbVendorId: 1027, usbProductId: 24577 };
const WCH: PortChoice = { usbVendorId: 6790, usbProductId: 29987 };

/** The serial ports of a window: which are plugged in, and which the person chooses, if any. */
class TestSerial implements Ports<Port> {
  plugged: Port[] = [];
  chosen: Port | undefined;
  readonly #looks: (() => void)[] = [];

  plug(info: PortChoice): Port {
    const port = { getInfo: () => info };
    this.plugged.push(port);
    for (const look of this.#looks) look();
    return port;
  }
  requestPort(): Promise<Port> {
    return this.chosen
      ? Promise.resolve(this.chosen)
      : Promise.reject(Object.assign(new Error(), { name: 'NotFoundError' }));
  }
  getPorts(): Promise<Port[]> {
    return Promise.resolve([...this.plugged]);
  }
  addEventListener(_type: string, look: () => void): void {
    this.#looks.push(look);
  }
}

/** A session that does nothing by itself. */
interface TestSession {
  readonly where: 'worker' | Port;
  readonly commands: SessionCommand[];
  readonly tell: (news: SessionNews) => void;
  readonly die: () => void;
  ended: boolean;
}

/** The bus of a window, and the sessions that it has started. */
function bare(given: { readonly browser?: TestBrowser; readonly serial?: TestSerial } = {}) {
  const window = new TestWindow();
  const sessions: TestSession[] = [];
  const start = (where: 'worker' | Port, tell: TestSession['tell'], die = () => {}) => {
    const session: TestSession = { where, commands: [], tell, die, ended: false };
    sessions.push(session);
    return {
      post: (command: SessionCommand) => session.commands.push(command),
      end() {
        session.ended = true;
      },
    };
  };
  const link = signal(CLOSED);
  const storage = (given.browser ?? new TestBrowser()).tab();
  const device = signal<DeviceLine | undefined>(undefined);
  const bus = new Bus({
    link,
    line: new Line(
      linePage(),
      storage,
      device,
      computed(() => link.value.kind === 'open'),
    ),
    serial: given.serial,
    inWorker: (tell, ended) => start('worker', tell, () => ended('died')),
    inWindow: (port, tell) => start(port, tell),
    trace: noTrace,
    storage,
  });
  return { bus, window, sessions, device };
}

/** A bus that is connected to the virtual bus, and the commands that its session was given since. */
function connected(state: LinkState = OPEN) {
  const { bus, window, sessions } = bare();
  bus.openVirtual();
  const [{ commands, tell, die }] = sessions as [TestSession];
  tell({ kind: 'state', state });
  commands.length = 0;
  const news: JobNews[] = [];
  const begin = () => bus.start(POLL, (all) => news.push(...all), 'rtu');
  return { bus, window, sessions, commands, tell, die, news, begin };
}

describe('connecting', () => {
  it('tells a session first what it has to know, and keeps it for the next time', () => {
    const { bus, sessions } = bare();
    bus.setReadOnly(false);
    bus.openVirtual();
    expect(sessions[0]?.commands).toMatchObject([
      { kind: 'set-rules', rules: defaultRules },
      { kind: 'set-read-only', readOnly: false },
      { kind: 'virtual', order: { kind: 'devices' } },
      { kind: 'virtual', order: { kind: 'faults', faults: [] } },
      { kind: 'open-virtual', settings: defaultSettings, pace: 'line' },
    ]);
    bus.openVirtual();
    expect(sessions).toHaveLength(1);
  });

  it('opens the port that is chosen, in a worker', async () => {
    const serial = new TestSerial();
    serial.chosen = serial.plug(FTDI);
    serial.plug(WCH);
    const { bus, sessions } = bare({ serial });
    const chosen = bus.connect();
    expect(bus.link.value).toEqual({ kind: 'choosing' });
    await chosen;
    expect(sessions.map(({ where }) => where)).toEqual(['worker']);
    expect(sessions[0]?.commands.at(-1)).toEqual({ kind: 'open-port', port: FTDI, settings: defaultSettings });
    expect(bus.inWindow.value).toBe(false);
  });

  it('says that no port was chosen', async () => {
    const { bus, sessions } = bare({ serial: new TestSerial() });
    await bus.connect();
    expect(bus.link.value).toEqual({ kind: 'refused', why: 'cancelled' });
    expect(sessions).toEqual([]);
  });

  it('opens one of two adapters of a kind in the window, and goes back to a worker for the next', async () => {
    const serial = new TestSerial();
    const [, second, other] = [serial.plug(FTDI), serial.plug(FTDI), serial.plug(WCH)];
    const { bus, sessions } = bare({ serial });
    await bus.open(second!);
    expect(sessions.map(({ where }) => where)).toEqual([second]);
    expect(bus.inWindow.value).toBe(true);
    await bus.open(other!);
    expect(sessions[0]?.commands.at(-1)).toEqual({ kind: 'close' });
    expect(sessions.map(({ where, ended }) => [where, ended])).toEqual([
      [second, true],
      ['worker', false],
    ]);
    expect(bus.inWindow.value).toBe(false);
  });

  it('knows the ports that are plugged in', async () => {
    const serial = new TestSerial();
    const { bus } = bare({ serial });
    expect(bus.ports.value).toEqual([]);
    const port = serial.plug(WCH);
    await Promise.resolve();
    await Promise.resolve();
    expect(bus.ports.value).toEqual([port]);
  });

  it('starts another session after one that has ended by itself', () => {
    const { bus, sessions, die } = connected();
    expect(bus.connected.value).toBe(true);
    die();
    expect(bus.link.value).toEqual({ kind: 'no-session', why: 'died' });
    expect(bus.connected.value).toBe(false);
    bus.openVirtual();
    expect(sessions).toHaveLength(2);
  });

  it('keeps settings, rules and pace in the browser for the next tab, and leaves other tabs alone', () => {
    const browser = new TestBrowser();
    const [one, other] = [bare({ browser }).bus, bare({ browser }).bus];
    one.settings.value = { ...defaultSettings, baud: 9600 };
    one.setRules({ ...defaultRules, timeout: 300 });
    one.setPace('fast');
    expect([other.settings.value.baud, other.rules.value.timeout, other.pace.value]).toEqual([19_200, 1000, 'line']);
    const next = bare({ browser }).bus;
    expect([next.settings.value.baud, next.rules.value.timeout, next.pace.value]).toEqual([9600, 300, 'fast']);
  });

  it('opens a port with the line of the device that is chosen', async () => {
    const serial = new TestSerial();
    const port = serial.plug(FTDI);
    const { bus, sessions, device } = bare({ serial });
    const serialLine = { baud: 9600, dataBits: 8, parity: 'none', stopBits: 1 } as const;
    device.value = { id: 'drive', name: 'Drive', serial: serialLine };
    await bus.open(port);
    const settings = { ...defaultSettings, ...serialLine };
    expect(sessions[0]?.commands.at(-1)).toEqual({ kind: 'open-port', port: FTDI, settings });
  });

  it('opens the virtual bus again when its pace changes', () => {
    const { bus, commands } = connected();
    bus.setPace('fast');
    expect(commands.at(-1)).toMatchObject({ kind: 'open-virtual', pace: 'fast' });
  });
});

describe('a request', () => {
  it('is sent in its mode, and no other until it has ended', () => {
    const { bus, commands, tell } = connected();
    bus.send(READ, 'ascii');
    expect(bus.sending.value).toBe(true);
    bus.send(WRITE, 'ascii');
    expect(commands).toEqual([
      { kind: 'set-rules', rules: { ...defaultRules, transport: 'ascii' } },
      { kind: 'send', id: 1, request: READ, confirmed: false },
    ]);
    tell({ kind: 'result', id: 1, result: RESULT });
    expect([bus.sending.value, bus.last.value]).toEqual([false, RESULT]);
    bus.send(WRITE, 'ascii');
    expect(commands.at(-1)).toEqual({ kind: 'send', id: 2, request: WRITE, confirmed: false });
  });

  it('is sent again once the guard has refused it or somebody has said no', () => {
    const { bus, commands, tell } = connected();
    bus.send(WRITE, 'rtu');
    tell({ kind: 'refused', id: 1, why: 'read-only' });
    expect([bus.sending.value, bus.refused.value]).toEqual([false, 'read-only']);
    bus.send(WRITE, 'rtu');
    tell({ kind: 'ask', id: 2, request: WRITE, why: 'first-write', once: true });
    expect(bus.refused.value).toBeUndefined();
    bus.answer(false);
    bus.send(WRITE, 'rtu');
    expect(commands.map((command) => 'id' in command && command.id)).toEqual([1, 2, 3]);
  });

  it('is sent as it was asked about when somebody says yes', () => {
    const { bus, commands, tell } = connected();
    bus.send(WRITE, 'rtu');
    tell({ kind: 'ask', id: 1, request: WRITE, why: 'first-write', once: true });
    expect([bus.sending.value, bus.question.value?.why]).toEqual([false, 'first-write']);
    bus.answer(true);
    expect(commands.at(-1)).toEqual({ kind: 'send', id: 1, request: WRITE, confirmed: true });
    expect([bus.sending.value, bus.question.value]).toEqual([true, undefined]);
    bus.answer(true);
    expect(commands).toHaveLength(2);
  });

  it('leaves the mode to the virtual devices while they answer', () => {
    const { bus, commands, tell } = connected();
    tell({ kind: 'serving', on: true });
    bus.send(READ, 'ascii');
    expect(commands.map(({ kind }) => kind)).toEqual(['send']);
  });
});

describe('a job', () => {
  const ended = (end: Extract<JobState, { kind: 'ended' }>['end']): JobState => ({ kind: 'ended', end });

  it('is told what it finds, and nothing of others', () => {
    const { bus, tell, begin, news } = connected();
    expect(bus.job('poll').value).toEqual({ kind: 'idle' });
    begin();
    expect(bus.job('poll').value).toEqual({ kind: 'running' });
    const sample = { kind: 'sample', index: 0, round: 0, time: 1, outcome: 'silent', verdict: 'bad' } as const;
    tell({
      kind: 'jobs',
      news: [
        { id: 2, news: { ...sample, index: 7 } },
        { id: 1, news: sample },
      ],
    });
    expect(news).toEqual([sample]);
  });

  it('is the only one of its kind', () => {
    const { bus, commands, begin } = connected();
    begin();
    begin();
    bus.start({ kind: 'listen' }, () => {});
    expect(commands.map((command) => command.kind === 'start-job' && command.order.kind)).toEqual(['poll', 'listen']);
  });

  it('ends with its own reason, whatever was refused before', () => {
    for (const why of ['read-only', 'serving', 'listening', 'scanning', 'busy'] satisfies Refusal[]) {
      const { bus, tell, begin } = connected();
      begin();
      tell({ kind: 'refused', id: 9, why: 'busy' });
      tell({ kind: 'refused', id: 1, why });
      expect(bus.job('poll').value).toEqual(ended({ kind: 'refused', why }));
    }
  });

  it('ends once: stopped, lost, disconnected or declined', () => {
    const cases: readonly (readonly [string, (given: ReturnType<typeof connected>) => void])[] = [
      ['stopped', ({ tell }) => tell({ kind: 'job-ended', id: 1 })],
      [
        'lost',
        ({ tell }) => {
          tell({ kind: 'state', state: LOST });
          tell({ kind: 'job-ended', id: 1 });
        },
      ],
      [
        'disconnected',
        ({ tell }) => {
          tell({ kind: 'state', state: CLOSED });
          tell({ kind: 'job-ended', id: 1 });
        },
      ],
      // Whoever has stopped it is not told that the connection was closed meanwhile.
      [
        'stopped',
        ({ bus, tell }) => {
          bus.stop('poll');
          tell({ kind: 'state', state: CLOSED });
          tell({ kind: 'job-ended', id: 1 });
        },
      ],
      ['disconnected', ({ die }) => die()],
      [
        'declined',
        ({ bus, tell }) => {
          tell({ kind: 'ask-job', id: 1, order: POLL, why: 'first-write', once: true });
          bus.answer(false);
        },
      ],
    ];
    for (const [kind, end] of cases) {
      const given = connected();
      given.begin();
      const states: JobState[] = [];
      given.bus.job('poll').subscribe((state) => states.push(state));
      end(given);
      given.tell({ kind: 'job-ended', id: 1 });
      given.die();
      expect(states).toEqual([{ kind: 'running' }, ended({ kind } as never)]);
    }
  });

  it('is lost with its adapter, also if another takes its place', async () => {
    const serial = new TestSerial();
    const [first, second] = [serial.plug(FTDI), serial.plug(FTDI)];
    const { bus, sessions } = bare({ serial });
    await bus.open(first!);
    sessions[0]?.tell({ kind: 'state', state: LOST });
    bus.start(POLL, () => {});
    await bus.open(second!);
    expect(bus.job('poll').value).toEqual(ended({ kind: 'lost' }));
  });

  it('is stopped as often as it is asked to, until it has ended', () => {
    const { bus, tell, begin, commands } = connected();
    begin();
    bus.stop('poll');
    bus.stop('poll');
    tell({ kind: 'job-ended', id: 1 });
    bus.stop('poll');
    expect(commands.slice(1)).toEqual([
      { kind: 'stop-job', id: 1 },
      { kind: 'stop-job', id: 1 },
    ]);
  });

  it('begins as it was asked about when somebody says yes', () => {
    const { bus, tell, begin, commands } = connected();
    begin();
    tell({ kind: 'ask-job', id: 1, order: POLL, why: 'broadcast', once: false });
    bus.answer(true);
    expect(commands.at(-1)).toEqual({ kind: 'start-job', id: 1, order: POLL, confirmed: true });
  });

  it.each([
    ['open', [CLOSED, OPENING, OPEN], 'begun'],
    ['still being opened', [{ kind: 'closing', adapter: VIRTUAL }, CLOSED, OPENING], 'waiting'],
    ['taken', [OPENING, { kind: 'taken', adapter: VIRTUAL, by: 'other-program' }], 'over'],
    ['failed', [OPENING, { kind: 'failed', adapter: VIRTUAL, settings: defaultSettings, message: '' }], 'over'],
    ['refused', [{ kind: 'refused', why: 'cancelled' }], 'over'],
    ['lost', [OPENING, LOST], 'over'],
  ] as const)('waits for a line that is being opened, and then is %s', (_, states, what) => {
    const { bus, commands, tell, begin } = connected(OPENING);
    begin();
    expect(bus.job('poll').value).toEqual({ kind: 'running' });
    for (const state of states) tell({ kind: 'state', state });
    expect(commands.filter(({ kind }) => kind === 'start-job')).toHaveLength(what === 'begun' ? 1 : 0);
    expect(bus.job('poll').value.kind).toBe(what === 'over' ? 'ended' : 'running');
    expect(bus.opening.value).toBe(what === 'waiting');
  });

  it('does not wait beyond the end of its session', () => {
    const { bus, die, begin } = connected(OPENING);
    begin();
    die();
    expect([bus.job('poll').value.kind, bus.opening.value]).toEqual(['ended', false]);
  });

  it('is disconnected at once if there is no session', () => {
    const { bus } = bare();
    bus.start(POLL, () => {});
    expect(bus.job('poll').value).toEqual(ended({ kind: 'disconnected' }));
  });
});

describe('what the session tells', () => {
  it('stands in the signals', () => {
    const { bus, tell } = connected(CLOSED);
    const inputs = { cts: true, dsr: false, dcd: false, ri: false };
    tell({ kind: 'signals', signals: inputs, set: false });
    expect(bus.signals.value).toEqual({ inputs, taken: false });
    tell({ kind: 'state', state: OPEN });
    expect([bus.link.value, bus.signals.value]).toEqual([OPEN, { taken: true }]);
    tell({ kind: 'errors', errors: { ...noErrors, parity: 3 } });
    expect(bus.errors.value.parity).toBe(3);
  });

  it('is nothing more when the session is gone', () => {
    const { bus, tell, commands, die } = connected();
    bus.send(READ, 'rtu');
    tell({ kind: 'serving', on: true });
    tell({ kind: 'ask', id: 2, request: WRITE, why: 'first-write', once: true });
    die();
    expect([bus.sending.value, bus.question.value, bus.serving.value]).toEqual([false, undefined, false]);
    bus.stopAll();
    expect(commands).toHaveLength(1);
  });
});

describe('the virtual devices', () => {
  it('are told to the session with what goes wrong and what is watched', () => {
    const { bus, commands } = connected();
    const [first] = bus.virtual.devices.value;
    bus.virtual.setDevices([first!]);
    bus.virtual.watch({ kind: 'watch', id: first!.id, table: 'holding-register', from: 0, count: 8 });
    commands.length = 0;
    bus.serve(true);
    expect(commands.map((command) => (command.kind === 'virtual' ? command.order.kind : command.kind))).toEqual([
      'devices',
      'faults',
      'watch',
      'serve',
    ]);
    commands.length = 0;
    bus.serve(false);
    expect(commands).toEqual([{ kind: 'serve', on: false }]);
  });

  it('show what stands in the device that is watched, and in no other', () => {
    const { bus, tell } = connected();
    const cells = { id: 1, table: 'holding-register', from: 0, count: 8 } as never;
    bus.virtual.watch({ kind: 'watch', id: 1, table: 'holding-register', from: 0, count: 8 });
    tell({ kind: 'virtual', news: { kind: 'watched', cells } });
    expect(bus.virtual.cells.value).toBe(cells);
    bus.virtual.watch({ kind: 'watch', id: 2, table: 'holding-register', from: 0, count: 8 });
    tell({ kind: 'virtual', news: { kind: 'watched', cells } });
    expect(bus.virtual.cells.value).toBeUndefined();
  });

  it('are kept in the browser; those that cannot be read are counted until the devices are changed', () => {
    const browser = new TestBrowser();
    const { virtual } = bare({ browser }).bus;
    const all = virtual.devices.value;
    expect(virtual.lost.value).toBe(0);
    virtual.setDevices(all.slice(1));
    const again = bare({ browser }).bus.virtual;
    expect(again.devices.value).toEqual(all.slice(1));
    browser.store(
      'framewright.virtual-devices',
      JSON.stringify([...JSON.parse(browser.texts.get('framewright.virtual-devices')!), 7]),
    );
    const broken = bare({ browser }).bus.virtual;
    expect(broken.lost.value).toBe(1);
    broken.setDevices(all);
    expect(broken.lost.value).toBe(0);
  });
});
