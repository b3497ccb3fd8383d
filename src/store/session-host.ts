import { type Signal, signal } from '@preact/signals-core';
import {
  type LinkState,
  type Port,
  type Ports,
  portsLike,
  rememberedPorts,
  type SessionCommand,
  type SessionNews,
} from '../bus/index.ts';

/** A session that works somewhere. */
export interface RunningSession {
  post(command: SessionCommand): void;
  /** Ends it; nothing is heard of it afterwards. */
  end(): void;
}

type Tell = (news: SessionNews) => void;
type Why = Extract<LinkState, { kind: 'no-session' }>['why'];

/** Where sessions can work, and the ports of the window. */
export interface HostParts<P extends Port> {
  /** `undefined` if the window has no Web Serial. */
  readonly serial:
    | (Ports<P> & { addEventListener(type: 'connect' | 'disconnect', look: () => void): void })
    | undefined;
  /** Starts a session in a worker. `ended` is told why it ended, unless it was told to. */
  readonly inWorker: (tell: Tell, ended: (why: Why) => void) => RunningSession;
  /** Starts a session on this port in the window. */
  readonly inWindow: (port: P, tell: Tell) => RunningSession;
}

/** Who is told of sessions. */
interface HostEvents {
  readonly tell: Tell;
  readonly began: () => void;
  /** `why` if it was not told to end. */
  readonly gone: (why?: Why) => void;
}

/** Starts the session of this window: in a worker, or in the window if a worker could not tell its port from another. */
export class SessionHost<P extends Port> {
  /** The ports that were chosen before and are plugged in. */
  readonly ports: Signal<readonly P[]> = signal([]);
  readonly inWindow = signal(false);
  readonly #parts: HostParts<P>;
  readonly #events: HostEvents;
  #session: RunningSession | undefined;

  constructor(parts: HostParts<P>, events: HostEvents) {
    this.#parts = parts;
    this.#events = events;
    parts.serial?.addEventListener('connect', this.look);
    parts.serial?.addEventListener('disconnect', this.look);
  }

  get works(): boolean {
    return this.#session !== undefined;
  }

  post(command: SessionCommand): void {
    this.#session?.post(command);
  }

  /** Looks which ports are plugged in. */
  readonly look = async (): Promise<void> => {
    if (this.#parts.serial) this.ports.value = await rememberedPorts(this.#parts.serial);
  };

  /** Has a session that can open this port. */
  async startFor(port: P): Promise<void> {
    const { serial } = this.#parts;
    const twins = serial ? await portsLike(serial, port.getInfo()) : [];
    this.start(twins.length > 1 ? port : undefined);
  }

  /** Has a session: on this port in the window, or in a worker. */
  start(port?: P): void {
    if (this.works && port === undefined && !this.inWindow.peek()) return;
    const { tell, began, gone } = this.#events;
    const { inWindow, inWorker } = this.#parts;
    this.post({ kind: 'close' });
    this.#session?.end();
    this.#session = undefined;
    gone();
    this.inWindow.value = port !== undefined;
    this.#session = port
      ? inWindow(port, tell)
      : inWorker(tell, (why) => {
          this.#session = undefined;
          gone(why);
        });
    began();
  }
}
