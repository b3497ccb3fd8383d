import { entityTables } from '../../devices/index.ts';
import { decodeFrame } from '../../modbus/index.ts';
import type { Clock } from '../clock.ts';
import { mayChange } from '../guard.ts';
import type { HeardBy, HeardFrame, VirtualNews, VirtualOrder, WatchedCells } from './bench-messages.ts';
import { type CellRun, type DeviceSetup, serverOf } from './devices.ts';
import type { VirtualServer } from './server.ts';
import { VirtualBus, type VirtualBusEvent } from './virtual-bus.ts';

/** How often a watcher is told, and how long after a change the values of devices are stored, in milliseconds. */
const WATCH = 150;
const KEEP = 1000;
/** The most frames that are told at once: the last ones. */
const MOST_HEARD = 50;

interface OnBench {
  setup: DeviceSetup;
  readonly server: VirtualServer;
}

/** The virtual bus of a window: devices are put on and taken off, watched and written to. */
export class VirtualBench {
  readonly bus: VirtualBus;
  readonly #clock: Clock;
  readonly #tell: (news: VirtualNews) => void;
  #devices: readonly OnBench[] = [];
  #watched: Extract<VirtualOrder, { kind: 'watch' }> | undefined;
  #offWatch = () => {};
  /** What was told last, as text. */
  #told = '';
  #frames: HeardFrame[] = [];
  #number = 0;
  #keeping = false;

  constructor(clock: Clock, tell: (news: VirtualNews) => void) {
    this.#clock = clock;
    this.#tell = tell;
    this.bus = new VirtualBus(clock);
    this.bus.listen((event) => this.#hear(event));
  }

  take(order: VirtualOrder): void {
    switch (order.kind) {
      case 'devices':
        this.#put(order.devices);
        return;
      case 'faults':
        this.bus.faults = order.faults;
        return;
      case 'write': {
        const server = this.#devices.find(({ setup }) => setup.id === order.id)?.server;
        server?.tables[order.table].write(order.from, order.values);
        this.#keepSoon();
        return;
      }
      case 'watch':
        this.#watched = order;
        this.#told = '';
        this.#watch();
        return;
      case 'unwatch':
        this.#watched = undefined;
        this.#frames = [];
        this.#offWatch();
        return;
    }
  }

  #put(setups: readonly DeviceSetup[]): void {
    this.#devices = setups.map((setup) => {
      const before = this.#devices.find((one) => one.setup.id === setup.id && one.setup.model === setup.model);
      if (before === undefined) return { setup, server: serverOf(setup) };
      before.server.unit = setup.unit;
      return { setup, server: before.server };
    });
    this.bus.servers = this.#devices.filter(({ setup }) => setup.on).map(({ server }) => server);
  }

  #hear(event: VirtualBusEvent): void {
    if (event.kind === 'request') {
      this.#number += 1;
      const time = this.#clock.origin + event.at;
      const { transport } = this.bus.settings;
      if (this.#watched) {
        this.#frames.push({ number: this.#number, time, transport, bytes: event.bytes, by: [] });
        if (this.#frames.length > MOST_HEARD) this.#frames.shift();
      }
      if (mayChange(decodeFrame(event.bytes, { transport, direction: 'request' }))) this.#keepSoon();
      return;
    }
    if (event.kind === 'reply' && event.fault) this.#tell({ kind: 'faults', faults: this.bus.faults });
    const last = this.#frames.pop();
    if (last === undefined) return;
    const { id = 0, unit = 0 } = this.#devices.find(({ server }) => server === event.server)?.setup ?? {};
    if (event.kind === 'heard') {
      const { does, why, exceptionCode } = event;
      this.#frames.push({ ...last, by: [...last.by, { id, unit, does, why, exceptionCode }] });
      return;
    }
    const { bytes: reply, fault } = event;
    const replied = (one: HeardBy) => (one.id === id ? { ...one, reply, fault: fault?.kind } : one);
    this.#frames.push({ ...last, by: last.by.map(replied) });
  }

  #watch(): void {
    const { id, table, from, count } = this.#watched ?? {};
    if (id === undefined || table === undefined || from === undefined || count === undefined) return;
    const frames = this.#frames;
    this.#frames = [];
    if (frames.length > 0) this.#tell({ kind: 'heard', frames });
    const device = this.#devices.find(({ setup }) => setup.id === id);
    if (device) {
      const { server, setup } = device;
      if (setup.on) server.refresh(this.#clock.now());
      const cells = server.tables[table];
      const values = cells.read(from, count).map((value, i) => (cells.has(from + i, 1) ? value : undefined));
      const { counts, eventCount, listenOnly } = server.counters;
      const watched: WatchedCells = { id, table, from, values, counts: { ...counts }, eventCount, listenOnly };
      const text = JSON.stringify(watched);
      if (text !== this.#told) this.#tell({ kind: 'watched', cells: watched });
      this.#told = text;
    }
    this.#offWatch();
    this.#offWatch = this.#clock.after(WATCH, () => this.#watch());
  }

  #keepSoon(): void {
    if (this.#keeping) return;
    this.#keeping = true;
    this.#clock.after(KEEP, () => {
      this.#keeping = false;
      const devices = this.#devices.map(({ setup, server }) => ({ id: setup.id, values: valuesOf(server) }));
      this.#tell({ kind: 'kept', devices });
    });
  }
}

/** All values of a device that are not 0; those that two tables share, once. */
const valuesOf = ({ tables }: VirtualServer): CellRun[] =>
  entityTables.flatMap((table, index) => {
    const isShared = entityTables.findIndex((other) => tables[other] === tables[table]) < index;
    return isShared ? [] : tables[table].runs().map((run) => ({ table, ...run }));
  });
