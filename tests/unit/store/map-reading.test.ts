import { signal } from '@preact/signals-core';
import { describe, expect, it } from 'vitest';
import { type LinkState, type Port, Session, sourceSetups } from '../../../src/bus/index.ts';
import { builtInProfiles, type Profile, plainRegister, searchProfile } from '../../../src/devices/index.ts';
import { Bus, Line, MapReading } from '../../../src/store/index.ts';
import { defaultPoll, mapValues } from '../../../src/workbench/index.ts';
import { VirtualClock } from '../bus/virtual-clock.ts';
import { linePage, noTrace, TestBrowser } from './window.ts';

const profile = (id: string): Profile => builtInProfiles.find((each) => each.id === id)!;
const weg = profile('weg-drive');
const all = (of: Profile) => searchProfile(of, '');

/** A window on the virtual bus of the sources, on a clock that is moved by hand. */
async function connected(isOpen = true) {
  const clock = new VirtualClock();
  const storage = new TestBrowser().tab();
  const bus = new Bus<Port>({
    link: signal<LinkState>({ kind: 'closed' }),
    line: new Line(linePage(), storage, signal(undefined), signal(false)),
    serial: undefined,
    inWorker(tell) {
      const session = new Session({ clock, portLink: async () => undefined, tell });
      return { post: (command) => void session.take(command), end: () => undefined };
    },
    inWindow: () => ({ post: () => undefined, end: () => undefined }),
    trace: noTrace,
    storage,
  });
  bus.virtual.setDevices(sourceSetups());
  bus.openVirtual();
  if (isOpen) await clock.advance(100);
  const reading = new MapReading(bus, { value: defaultPoll });
  const shown = (of: Profile) =>
    all(of).map((found) => [
      found.register.name,
      ...mapValues(of, found, reading.map.value.cells).map((value) =>
        value.kind === 'value' ? value.raw : `exception ${value.failure.exceptionCode}`,
      ),
    ]);
  return { bus, clock, reading, shown };
}

describe('a map that is read from the bus', () => {
  it('has each value in its row, also where the device refuses the gap that the plan reads as well', async () => {
    const { clock, reading, shown } = await connected();
    expect(reading.unitOf(weg)).toBe(6);
    reading.start(weg, all(weg));
    expect(reading.running.value).toBe(true);
    await clock.advance(2000);
    expect([reading.running.value, reading.end.value]).toEqual([false, { kind: 'stopped' }]);
    // 681 to 685 is refused, because there is no 684; then 681 to 683, and 685.
    expect(reading.progress.value).toEqual({ done: 3, left: 0, read: 4, failed: 0, wanted: 4 });
    expect(shown(weg).map(([, ...values]) => values)).toEqual([[0], [0], [0], [0]]);
  });

  it('says of a row that the device does not have why, and reads the others', async () => {
    const { clock, reading, shown } = await connected();
    const other: Profile = {
      ...weg,
      id: 'own',
      registers: [
        ...weg.registers,
        { ...plainRegister, name: 'P0684', table: 'holding-register', address: 684 },
        { ...plainRegister, name: 'secret', table: 'holding-register', address: 686, access: 'w' },
      ],
    };
    reading.start(other, all(other));
    await clock.advance(3000);
    expect(shown(other).slice(-3)).toEqual([['P0685 direction', 0], ['P0684', 'exception 2'], ['secret']]);
    expect(reading.progress.value).toMatchObject({ read: 4, failed: 1, wanted: 5 });
  });

  it('keeps what was read while a row is read again, and of another device or unit nothing', async () => {
    const { clock, reading, shown, bus } = await connected();
    reading.start(weg, all(weg));
    await clock.advance(2000);
    bus.virtual.order({ kind: 'write', id: 2, table: 'holding-register', from: 682, values: [1] });
    reading.start(weg, all(weg).slice(0, 1));
    await clock.advance(1000);
    expect(shown(weg).every(([, value]) => value === 0)).toBe(true);
    const copy = { ...weg, id: 'copy' };
    reading.follow(weg, copy);
    expect(reading.map.value).toMatchObject({ of: 'copy', unit: 6 });
    expect(reading.unitOf(copy)).toBe(6);
    reading.chooseUnit(copy, 7);
    reading.start(copy, all(copy).slice(0, 1));
    expect(shown(copy).flatMap(([, ...values]) => values)).toEqual([]);
  });

  it('ends with its line, and reads nothing without one', async () => {
    const { clock, reading, bus, shown } = await connected();
    bus.disconnect();
    await clock.advance(100);
    reading.start(weg, all(weg));
    await clock.advance(100);
    expect(reading.end.value).toEqual({ kind: 'disconnected' });
    expect(shown(weg).flatMap(([, ...values]) => values)).toEqual([]);
  });

  it('waits for a line that is being opened', async () => {
    const { clock, reading, bus, shown } = await connected(false);
    expect([bus.connected.value, bus.opening.value]).toEqual([false, true]);
    reading.start(weg, all(weg));
    expect(reading.running.value).toBe(true);
    await clock.advance(3000);
    expect([bus.connected.value, bus.opening.value]).toEqual([true, false]);
    expect(reading.progress.value).toMatchObject({ read: 4, failed: 0, wanted: 4 });
    expect(shown(weg).map(([, ...values]) => values)).toEqual([[0], [0], [0], [0]]);
  });

  it('reads nothing if it is stopped, or the line given up, before that is open', async () => {
    for (const [giveUp, end] of [
      ['stop', 'stopped'],
      ['disconnect', 'disconnected'],
    ] as const) {
      const { clock, reading, bus, shown } = await connected(false);
      reading.start(weg, all(weg));
      if (giveUp === 'stop') reading.stop();
      else bus.disconnect();
      expect([reading.running.value, reading.end.value]).toEqual([false, { kind: end }]);
      await clock.advance(3000);
      expect(bus.log.records).toEqual([]);
      expect(shown(weg).flatMap(([, ...values]) => values)).toEqual([]);
    }
  });
});
