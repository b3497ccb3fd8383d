import {
  type DeviceSetup,
  type FaultRule,
  type HeardFrame,
  Listeners,
  sourceSetups,
  type VirtualNews,
  type VirtualOrder,
  type WatchedCells,
} from '../../bus/index.ts';
import { KeptChoice } from '../../store/index.ts';
import { type Pace, readSetups, withKeptValues } from '../../workbench/index.ts';
import { storage } from '../parts/store.ts';
import { bus } from './bus.ts';
import { paceMemory } from './memories.ts';

/** What could not be read of the devices that were kept. It is said until the devices are changed, which forgets it. */
let lost = 0;

const devicesMemory = new KeptChoice<readonly DeviceSetup[]>(
  storage,
  'virtual-devices',
  sourceSetups(),
  (stored) => {
    const reading = readSetups(stored);
    lost = reading?.bad ?? 0;
    return reading?.devices;
  },
  'tab',
);

/** Frames of which is kept who heard them. */
const MOST_FRAMES = 30;

export interface VirtualState {
  readonly pace: Pace;
  readonly devices: readonly DeviceSetup[];
  /** How many of the devices that were kept could not be read. */
  readonly lost: number;
  readonly faults: readonly FaultRule[];
  /** What stands in the device that is watched, once that is known. */
  readonly cells: WatchedCells | undefined;
  /** The last first. */
  readonly frames: readonly HeardFrame[];
}

/** The virtual devices as the window knows them; they live in the session. What stands in them is kept in the browser. */
class Virtual {
  readonly #listeners = new Listeners<VirtualState>();
  #watched: Extract<VirtualOrder, { kind: 'watch' }> | undefined;
  state: VirtualState = {
    pace: paceMemory.value,
    devices: devicesMemory.value,
    lost,
    faults: [],
    cells: undefined,
    frames: [],
  };

  constructor() {
    bus.news.add((news) => news.kind === 'virtual' && this.#take(news.news));
  }

  /** Answers how to stop listening. */
  listen(listener: (state: VirtualState) => void): () => void {
    return this.#listeners.add(listener);
  }

  /** Connects to the virtual bus. */
  open(): void {
    const { settings } = bus.state;
    bus.host([...this.#begin(), { kind: 'open-virtual', settings, pace: this.state.pace }]);
  }

  /** Lets the devices answer on the port that is connected, or no longer. */
  serve(on: boolean): void {
    for (const command of on ? this.#begin() : []) bus.command(command);
    bus.command({ kind: 'serve', on });
  }

  setPace(pace: Pace): void {
    paceMemory.value = pace;
    this.#set({ pace });
    if (bus.state.link.kind === 'open' && bus.state.link.adapter.kind === 'virtual') this.open();
  }

  setDevices(devices: readonly DeviceSetup[]): void {
    devicesMemory.value = devices;
    this.#set({ devices, lost: 0 });
    this.order({ kind: 'devices', devices });
  }

  setFaults(faults: readonly FaultRule[]): void {
    this.#set({ faults });
    this.order({ kind: 'faults', faults });
  }

  /** Watches a device from now on; nobody watches where it is `undefined`. */
  watch(order: Extract<VirtualOrder, { kind: 'watch' }> | undefined): void {
    this.#watched = order;
    this.#set({ cells: undefined });
    this.order(order ?? { kind: 'unwatch' });
  }

  forgetFrames(): void {
    this.#set({ frames: [] });
  }

  order(order: VirtualOrder): void {
    bus.command({ kind: 'virtual', order });
  }

  /** What a session is to know that may know nothing yet. */
  #begin() {
    const { devices, faults } = this.state;
    const orders: VirtualOrder[] = [
      { kind: 'devices', devices },
      { kind: 'faults', faults },
    ];
    if (this.#watched) orders.push(this.#watched);
    return orders.map((order) => ({ kind: 'virtual', order }) as const);
  }

  #set(change: Partial<VirtualState>): void {
    this.state = { ...this.state, ...change };
    this.#listeners.tell(this.state);
  }

  #take(news: VirtualNews): void {
    switch (news.kind) {
      case 'watched': {
        const { id, table, from } = news.cells;
        const wanted = this.#watched;
        if (wanted?.id === id && wanted.table === table && wanted.from === from) this.#set({ cells: news.cells });
        break;
      }
      case 'heard':
        this.#set({ frames: [...news.frames.toReversed(), ...this.state.frames].slice(0, MOST_FRAMES) });
        break;
      case 'faults':
        this.#set({ faults: news.faults });
        break;
      case 'kept': {
        const devices = withKeptValues(this.state.devices, news.devices);
        devicesMemory.value = devices;
        this.#set({ devices });
        break;
      }
    }
  }
}

export const virtual = new Virtual();
