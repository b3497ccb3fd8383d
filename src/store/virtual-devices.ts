import { type Signal, signal } from '@preact/signals-core';
import {
  type DeviceSetup,
  type FaultRule,
  type HeardFrame,
  sourceSetups,
  type VirtualNews,
  type VirtualOrder,
  type WatchedCells,
} from '../bus/index.ts';
import { readSetups, withKeptValues } from '../workbench/index.ts';
import { KeptChoice, type PageStorage } from './storage.ts';

/** Frames of which is kept who heard them. */
const MOST_FRAMES = 30;

type Watch = Extract<VirtualOrder, { kind: 'watch' }>;

/** The virtual devices as the window knows them; they live in the session. What stands in them is kept in the browser. */
export class VirtualDevices {
  readonly devices: { readonly value: readonly DeviceSetup[] };
  readonly #devices: KeptChoice<readonly DeviceSetup[]>;
  /** How many of the devices that were kept could not be read; 0 once the devices are changed, which forgets them. */
  readonly lost: Signal<number>;
  readonly faults = signal<readonly FaultRule[]>([]);
  /** What stands in the device that is watched, once that is known. */
  readonly cells = signal<WatchedCells | undefined>(undefined);
  /** Who heard each of the last frames; the last first. */
  readonly frames = signal<readonly HeardFrame[]>([]);
  /** Gives an order to the session. */
  readonly order: (order: VirtualOrder) => void;
  #watched: Watch | undefined;

  constructor(storage: PageStorage, order: (order: VirtualOrder) => void) {
    this.order = order;
    let lost = 0;
    const read = (stored: unknown) => {
      const reading = readSetups(stored);
      lost = reading?.bad ?? 0;
      return reading?.devices;
    };
    this.devices = this.#devices = new KeptChoice(storage, 'virtual-devices', sourceSetups(), read, 'tab');
    this.lost = signal(lost);
  }

  setDevices(devices: readonly DeviceSetup[]): void {
    this.#devices.value = devices.map((device) => ({ ...device, version: 2 }));
    this.lost.value = 0;
    this.order({ kind: 'devices', devices });
  }

  setFaults(faults: readonly FaultRule[]): void {
    this.faults.value = faults;
    this.order({ kind: 'faults', faults });
  }

  /** Watches a device from now on; with `undefined`, none. */
  watch(order: Watch | undefined): void {
    this.#watched = order;
    this.cells.value = undefined;
    this.order(order ?? { kind: 'unwatch' });
  }

  forgetFrames(): void {
    this.frames.value = [];
  }

  /** Tells everything to a session that may know nothing yet. */
  tellAll(): void {
    this.order({ kind: 'devices', devices: this.#devices.value });
    this.order({ kind: 'faults', faults: this.faults.peek() });
    if (this.#watched) this.order(this.#watched);
  }

  /** Takes what the session tells of them. */
  take(news: VirtualNews): void {
    switch (news.kind) {
      case 'watched': {
        const { id, table, from } = news.cells;
        const wanted = this.#watched;
        if (wanted?.id === id && wanted.table === table && wanted.from === from) this.cells.value = news.cells;
        break;
      }
      case 'heard':
        this.frames.value = [...news.frames.toReversed(), ...this.frames.peek()].slice(0, MOST_FRAMES);
        break;
      case 'faults':
        this.faults.value = news.faults;
        break;
      case 'kept':
        this.#devices.value = withKeptValues(this.#devices.value, news.devices);
        break;
    }
  }
}
