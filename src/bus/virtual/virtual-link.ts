import type { Clock } from '../clock.ts';
import {
  type InputSignals,
  type Link,
  type LinkEvent,
  type LinkSettings,
  type LinkState,
  noErrors,
} from '../link/link.ts';
import { Listeners } from '../listeners.ts';
import type { VirtualBus } from './virtual-bus.ts';

const adapter = { kind: 'virtual' } as const;

/** The plug of the virtual bus: a link like that of a real port, which can be pulled out. */
export class VirtualLink implements Link {
  readonly errors = noErrors;
  readonly #bus: VirtualBus;
  readonly #clock: Clock;
  readonly #listeners = new Listeners<LinkEvent>();
  #state: LinkState = { kind: 'closed' };

  constructor(bus: VirtualBus, clock: Clock) {
    this.#bus = bus;
    this.#clock = clock;
  }

  get state(): LinkState {
    return this.#state;
  }

  listen(listener: (event: LinkEvent) => void): () => void {
    return this.#listeners.add(listener);
  }

  async open(settings: LinkSettings): Promise<LinkState> {
    if (this.#state.kind === 'open') return this.#state;
    this.#become({ kind: 'opening', adapter, settings });
    return this.#become({ kind: 'open', adapter, settings, since: this.#clock.now() });
  }

  async close(): Promise<void> {
    if (this.#state.kind !== 'closed') this.#become({ kind: 'closed' });
  }

  async write(bytes: Uint8Array): Promise<boolean> {
    const opened = this.#state;
    if (opened.kind !== 'open') return false;
    this.#bus.send(bytes, opened.settings, (received) => {
      // Bytes for a link that has been closed since, and perhaps opened again, are lost.
      if (this.#state === opened) {
        this.#listeners.tell({ kind: 'received', bytes: received, at: this.#clock.now() });
      }
    });
    return true;
  }

  async setSignals(): Promise<boolean> {
    return false;
  }

  async getSignals(): Promise<InputSignals | undefined> {
    return undefined;
  }

  /** Pulls the plug, as if an adapter were taken out. */
  unplug(): void {
    if (this.#state.kind === 'open') this.#become({ kind: 'lost', adapter, why: 'unplugged', at: this.#clock.now() });
  }

  #become(state: LinkState): LinkState {
    this.#state = state;
    this.#listeners.tell({ kind: 'state', state });
    return state;
  }
}
