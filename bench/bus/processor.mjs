// The processor time that a transaction takes of the session's worker: asked, matched, judged, logged, and told to the window.
// The line answers at once and the clock is the benchmark's own, so that nothing is waited for.
import { serialize } from 'node:v8';
import { defaultRules, defaultSettings, noErrors, Session } from '../../src/bus/index.ts';
import { crc16, fromHex } from '../../src/modbus/index.ts';
import { quantile } from '../quantile.mjs';

/** Read holding registers 0 to 9 of unit 1, and the reply. */
const REQUEST = fromHex('01030000000AC5CD');
const VALUES = fromHex('01031403E803E903EA03EB03EC03ED03EE03EF03F003F1');
const REPLY = Uint8Array.of(...VALUES, crc16(VALUES) & 0xff, crc16(VALUES) >> 8);
const WARM_UP = 20_000;
const ROUNDS = 8;
const EACH = 10_000;
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

/** Microseconds of a transaction: the median of some rounds. */
export async function processorTime() {
  const clock = new Clock();
  const link = new Line(clock);
  let done = 0;
  const tell = (news) => {
    serialize(news);
    if (news.kind !== 'jobs') return;
    if (news.news.some(({ news: { verdict } }) => verdict !== 'good')) throw new Error('A reply is not good.');
    done += news.news.length;
  };
  const session = new Session({ clock, portLink: async () => link, tell });
  await session.take({ kind: 'set-rules', rules: { ...defaultRules, gap: 0 } });
  await session.take({ kind: 'open-port', port: {}, settings: { ...defaultSettings, baud: 115_200 } });
  const order = { kind: 'poll', requests: [REQUEST], interval: 0 };
  void session.take({ kind: 'start-job', id: 1, order, confirmed: true });
  const run = async (count) => {
    const before = done;
    while (done < before + count) {
      for (let turn = 0; turn < TURNS; turn++) await undefined;
      clock.next();
    }
    return done - before;
  };
  await run(WARM_UP);
  const rounds = [];
  for (let round = 0; round < ROUNDS; round++) {
    const before = process.cpuUsage();
    const count = await run(EACH);
    const { user, system } = process.cpuUsage(before);
    rounds.push((user + system) / count);
  }
  return quantile(rounds, 0.5);
}
