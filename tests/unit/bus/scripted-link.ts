import {
  defaultSettings,
  type InputSignals,
  type LineError,
  type Link,
  type LinkEvent,
  type LinkSettings,
  type LinkState,
  noErrors,
} from '../../../src/bus/index.ts';
import { Listeners } from '../../../src/bus/listeners.ts';
import type { VirtualClock } from './virtual-clock.ts';

const adapter = { kind: 'virtual' } as const;

/** A link that plays what a test tells it to: bytes at times after each write. */
export class ScriptedLink implements Link {
  readonly errors = noErrors;
  readonly written: { bytes: Uint8Array; at: number }[] = [];
  /** What comes after each write, in the order of the writes: bytes, and milliseconds after the writing. */
  readonly replies: (readonly { readonly bytes: Uint8Array; readonly after: number }[])[] = [];
  /** How the next writes end; `true` once there are no more. */
  readonly writes: (boolean | Promise<boolean>)[] = [];
  state: LinkState;
  readonly #clock: VirtualClock;
  readonly #listeners = new Listeners<LinkEvent>();

  constructor(clock: VirtualClock, settings: LinkSettings = { ...defaultSettings, baud: 9600, parity: 'none' }) {
    this.#clock = clock;
    this.state = { kind: 'open', adapter, settings, since: 0 };
  }

  listen(listener: (event: LinkEvent) => void): () => void {
    return this.#listeners.add(listener);
  }

  async open(): Promise<LinkState> {
    return this.state;
  }

  async close(): Promise<void> {
    this.become({ kind: 'closed' });
  }

  async write(bytes: Uint8Array): Promise<boolean> {
    this.written.push({ bytes: bytes.slice(), at: this.#clock.now() });
    for (const { bytes, after } of this.replies.shift() ?? []) this.#clock.after(after, () => this.receive(bytes));
    return this.writes.shift() ?? true;
  }

  async setSignals(): Promise<boolean> {
    return false;
  }

  async getSignals(): Promise<InputSignals | undefined> {
    return undefined;
  }

  receive(bytes: Uint8Array): void {
    if (this.state.kind === 'open') this.#listeners.tell({ kind: 'received', bytes, at: this.#clock.now() });
  }

  error(error: LineError): void {
    this.#listeners.tell({ kind: 'line-error', error, at: this.#clock.now() });
  }

  become(state: LinkState): void {
    this.state = state;
    this.#listeners.tell({ kind: 'state', state });
  }

  lose(): void {
    this.become({ kind: 'lost', adapter, why: 'unplugged', at: this.#clock.now() });
  }
}
