// A day of polling without a window: the session, the poll, the log and the trace that shows it, on a clock that does not wait.
import { signal } from '@preact/signals-core';
import { Session, sourceSetups } from '../../src/bus/index.ts';
import { plainRegister } from '../../src/devices/index.ts';
import { fromHex } from '../../src/modbus/index.ts';
import { Bus, KeptLog, Line, Poll, TraceView } from '../../src/store/index.ts';
import { TraceDesk } from '../../src/workbench/index.ts';
import { VirtualClock } from '../../tests/unit/bus/virtual-clock.ts';
import { linePage, TestBrowser } from '../../tests/unit/store/window.ts';

const HOUR = 3_600_000;
/** Half a second, so that the limits of what is kept are reached in the first half of the day. */
export const INTERVAL = 500;

/** Two registers of the drive that is unit 6 of the virtual bus. */
const value = (at) => ({
  name: `P068${at + 1}`,
  place: '',
  register: { ...plainRegister, name: '', table: 'holding-register', address: 681 + at, type: 'u16' },
  where: { read: 0, at, size: 1 },
});
const source = {
  title: 'WEG',
  transport: 'rtu',
  requests: [fromHex('060302A900021424')],
  reads: [{ quantity: 2, width: 1 }],
  values: [value(0), value(1)],
  unreadable: [],
};

/**
 * @param {number} hours
 * @param {(hour: number, rounds: number) => void} each called at the beginning and after each two hours
 */
export async function dayOfPolling(hours, each) {
  const clock = new VirtualClock();
  const storage = new TestBrowser().tab();
  const trace = new TraceView({
    start(take) {
      const desk = new TraceDesk(
        (answer) => take(structuredClone(answer)),
        (act) => act(),
      );
      return { post: (task) => desk.take(structuredClone(task)), end: () => undefined };
    },
    show: () => undefined,
  });
  const bus = new Bus({
    link: signal({ kind: 'closed' }),
    line: new Line(linePage(), storage, signal(undefined), signal(false)),
    serial: undefined,
    inWorker(tell) {
      const session = new Session({ clock, portLink: async () => undefined, tell });
      return { post: (command) => void session.take(command), end: () => undefined };
    },
    inWindow: () => ({ post: () => undefined, end: () => undefined }),
    trace,
    storage,
  });
  const texts = new Map();
  const kept = new KeptLog(bus.log, () => ({
    getItem: (key) => texts.get(key) ?? null,
    setItem: (key, text) => void texts.set(key, text),
    removeItem: (key) => void texts.delete(key),
  }));
  bus.virtual.setDevices(sourceSetups());
  bus.openVirtual();
  await clock.advance(100);
  const poll = new Poll(bus, storage);
  poll.settings.value = { ...poll.settings.value, interval: INTERVAL };
  poll.start(source);
  const tell = (hour) => each(hour, poll.polled.value.samples.rounds);
  await clock.advance(1000);
  tell(0);
  for (let hour = 0; hour < hours; hour += 2) {
    await clock.advance(2 * HOUR);
    // The window is hidden and seen again.
    kept.keep();
    trace.row(trace.rowsKept.value - 1);
    tell(hour + 2);
  }
  if (poll.polled.value.failed > 0) throw new Error('A reply did not come.');
}
