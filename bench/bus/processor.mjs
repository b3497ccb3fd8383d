// The processor time that a transaction takes of all that works on it but the screen: of the session's worker, in which it is asked,
// matched, judged and logged; of the window, which keeps its lines and its values; and of the worker that holds the trace. What goes between
// them is written and read as messages are. The line answers at once and the clock is the benchmark's own, so that nothing is waited for.
import { MessageChannel, receiveMessageOnPort } from 'node:worker_threads';
import { signal } from '@preact/signals-core';
import { defaultRules, noErrors, Session } from '../../src/bus/index.ts';
import { plainRegister } from '../../src/devices/index.ts';
import { crc16, fromHex } from '../../src/modbus/index.ts';
import { Bus, Line as LineSettings, Poll, TraceView } from '../../src/store/index.ts';
import { TraceDesk } from '../../src/workbench/index.ts';
import { linePage, TestBrowser } from '../../tests/unit/store/window.ts';

/** Read holding registers 0 to 9 of unit 1, and the reply. */
const REQUEST = fromHex('01030000000AC5CD');
const VALUES = fromHex('01031403E803E903EA03EB03EC03ED03EE03EF03F003F1');
const REPLY = Uint8Array.of(...VALUES, crc16(VALUES) & 0xff, crc16(VALUES) >> 8);
const QUANTITY = 10;
const WARM_UP = 20_000;
const ROUNDS = 10;
const EACH = 10_000;
/** Rows of the log that are in sight. */
const IN_SIGHT = 12;
/** Steps of a promise that follow each other before the next event comes. */
const TURNS = 6;
export const MOST = 40;

/** Events in the order of their times. */
class Clock {
  origin = 0;
  #now = 0;
  #events = [];
  now = () => this.#now;
  after(delay, then) {
    const event = { at: this.#now + Math.max(delay, 0.001), then };
    const behind = this.#events.findLastIndex(({ at }) => at <= event.at);
    this.#events.splice(behind + 1, 0, event);
    return () => {
      this.#events = this.#events.filter((other) => other !== event);
    };
  }
  next() {
    const event = this.#events.shift();
    if (event === undefined) throw new Error('Nothing waits.');
    this.#now = event.at;
    event.then();
  }
}

class Line {
  state = { kind: 'closed' };
  errors = noErrors;
  #listeners = new Set();
  constructor(clock) {
    this.clock = clock;
  }
  #tell(event) {
    for (const listener of this.#listeners) listener(event);
  }
  async open(settings) {
    this.state = { kind: 'open', adapter: { kind: 'port' }, settings, since: 0 };
    this.#tell({ kind: 'state', state: this.state });
    return this.state;
  }
  async close() {}
  async write() {
    this.clock.after(1, () => this.#tell({ kind: 'received', bytes: REPLY.slice(), at: this.clock.now() }));
    return true;
  }
  listen(listener) {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }
}

const source = {
  title: '',
  transport: 'rtu',
  requests: [REQUEST],
  reads: [{ quantity: QUANTITY, width: 1 }],
  values: Array.from({ length: QUANTITY }, (_, at) => ({
    name: `${at}`,
    place: '',
    register: { ...plainRegister, name: '', table: 'holding-register', address: at, type: 'u16' },
    where: { read: 0, at, size: 1 },
  })),
  unreadable: [],
};

/** The parts whose processor time is told. */
export const PARTS = ['session', 'window', 'trace', 'rows in sight'];

/**
 * Microseconds of a transaction: of each part, and of all, over as many as make the trace forget its oldest records twice.
 * @returns {Promise<{ of: readonly number[], sum: number }>}
 */
export async function processorTime() {
  /** How long each part has worked, in milliseconds: by it their processor time is shared out among them, which is asked for once a round. */
  const worked = new Map();
  let [mark, part] = [performance.now(), 'session'];
  /** From now on it is this part that works. */
  const turn = (next) => {
    const now = performance.now();
    worked.set(part, (worked.get(part) ?? 0) + now - mark);
    [mark, part] = [now, next];
  };
  const { port1, port2 } = new MessageChannel();
  /** Sends a message from the part that works to another, which takes it at once. */
  const send = (message, to, take) => {
    const from = part;
    port1.postMessage(message);
    turn(to);
    take(receiveMessageOnPort(port2).message);
    turn(from);
  };

  const clock = new Clock();
  const line = new Line(clock);
  const later = [];
  const trace = new TraceView({
    start(take) {
      const desk = new TraceDesk(
        (answer) => {
          // The window draws what has come: it asks for the rows that it does not have.
          send(answer, 'window', (one) => {
            take(one);
            isNews ||= one.kind === 'list' || one.kind === 'rows';
          });
        },
        (act) => later.push(act),
      );
      return {
        post: (task) => send(task, task.kind === 'rows' ? 'rows in sight' : 'trace', (one) => desk.take(one)),
        end: () => undefined,
      };
    },
    show: () => undefined,
  });
  let isNews = false;
  const draw = () => {
    isNews = false;
    const count = trace.rowsKept.value;
    for (let row = Math.max(0, count - IN_SIGHT); row < count; row++) trace.row(row);
  };
  const storage = new TestBrowser().tab();
  const port = { getInfo: () => ({}) };
  const bus = new Bus({
    link: signal({ kind: 'closed' }),
    line: new LineSettings(linePage(), storage, signal(undefined), signal(false)),
    serial: { addEventListener() {}, getPorts: async () => [port] },
    inWorker(tell) {
      const session = new Session({
        clock,
        portLink: async () => line,
        tell: (news) => send(news, 'window', tell),
      });
      return { post: (command) => void session.take(structuredClone(command)), end: () => undefined };
    },
    inWindow: () => ({ post: () => undefined, end: () => undefined }),
    trace,
    storage,
  });
  bus.setRules({ ...defaultRules, gap: 0 });
  await bus.open(port);
  while (!bus.connected.value) await undefined;
  const poll = new Poll(bus, storage);
  poll.settings.value = { ...poll.settings.value, interval: 0 };
  poll.start(source);
  const rounds = () => poll.polled.value?.samples.rounds ?? 0;
  const run = async (count) => {
    const before = rounds();
    while (rounds() < before + count) {
      for (let step = 0; step < TURNS; step++) await undefined;
      clock.next();
      if (!isNews && later.length === 0) continue;
      turn('trace');
      later.shift()?.();
      turn('window');
      if (isNews) draw();
      turn('session');
    }
    return rounds() - before;
  };
  await run(WARM_UP);
  const measured = [];
  for (let round = 0; round < ROUNDS; round++) {
    turn('session');
    worked.clear();
    const before = process.cpuUsage();
    const count = await run(EACH);
    const { user, system } = process.cpuUsage(before);
    turn('session');
    const each = (user + system) / count;
    const all = [...worked.values()].reduce((sum, one) => sum + one, 0);
    measured.push([...PARTS.map((one) => (each * (worked.get(one) ?? 0)) / all), each]);
  }
  port1.close();
  if (poll.polled.value.failed > 0) throw new Error('A reply is not good.');
  if (trace.summary.value.exchanges < EACH) throw new Error('The trace does not have what was said.');
  const [sum, ...of] = [PARTS.length, ...PARTS.keys()].map(
    (at) => measured.reduce((all, one) => all + one[at], 0) / ROUNDS,
  );
  return { of, sum };
}
