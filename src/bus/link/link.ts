import type { SerialLine } from '../../modbus/index.ts';
import type { Adapter } from './adapters.ts';

/** How a port is opened. */
export interface LinkSettings extends SerialLine {
  readonly flowControl: 'none' | 'hardware';
  /** Bytes that the browser keeps until they are taken. */
  readonly bufferSize: number;
}

/** The default of the specification: 19200 baud, 8E1 (SL 3.2, SL 2.5.1). */
export const defaultSettings: LinkSettings = {
  baud: 19_200,
  dataBits: 8,
  parity: 'even',
  stopBits: 1,
  flowControl: 'none',
  bufferSize: 4096,
};

/** Whether speed and format are the same. */
export const isSameLine = (one: SerialLine, other: SerialLine): boolean =>
  one.baud === other.baud &&
  one.dataBits === other.dataBits &&
  one.parity === other.parity &&
  one.stopBits === other.stopBits;

/** Why a worker does nothing any more: its script did not come, it ended by itself, or this page may have none. */
export type WorkerEnd = 'not-loaded' | 'died' | 'forbidden';

/**
 * What a connection is, from the first look for one to its loss. `unsupported`, `choosing`, `refused`
 * and `no-session` are said without a link.
 */
export type LinkState =
  /** Nothing is connected. */
  | { readonly kind: 'closed' }
  /** The browser has no Web Serial, or hides it from a page that was loaded over an insecure connection. */
  | { readonly kind: 'unsupported'; readonly why: 'no-api' | 'insecure' }
  /** The browser's list of ports is open. */
  | { readonly kind: 'choosing' }
  /** No port was chosen; or the browser did not show the list: a policy forbids it, or nobody had pressed a button. */
  | { readonly kind: 'refused'; readonly why: 'cancelled' | 'policy' | 'no-gesture' }
  /** What works on the line did not load, has ended without being told to, or is forbidden by the browser. */
  | { readonly kind: 'no-session'; readonly why: WorkerEnd }
  | { readonly kind: 'opening'; readonly adapter: Adapter; readonly settings: LinkSettings }
  | { readonly kind: 'open'; readonly adapter: Adapter; readonly settings: LinkSettings; readonly since: number }
  /** The port does not open: another program or page has it, or it was pulled out after it was chosen. */
  | { readonly kind: 'taken'; readonly adapter: Adapter; readonly by: 'other-program' | 'this-page' }
  /** The port does not support these settings, or something unforeseen happened; `message` is the browser's. */
  | { readonly kind: 'failed'; readonly adapter: Adapter; readonly settings: LinkSettings; readonly message: string }
  | { readonly kind: 'closing'; readonly adapter: Adapter }
  /** `unplugged`: the browser says so. `gone`: the port failed for good. `at` is the clock's time. */
  | { readonly kind: 'lost'; readonly adapter: Adapter; readonly why: 'unplugged' | 'gone'; readonly at: number };

/** What a receiver notices in the characters themselves. */
export type LineError = (typeof lineErrors)[number];
export const lineErrors = ['parity', 'framing', 'overrun', 'break', 'unknown'] as const;
export type LineErrorCounts = Readonly<Record<LineError, number>>;

export type LinkEvent =
  /**
   * Bytes have come. `at` is when the adapter handed them over, which it does in lumps. The bytes belong to the
   * listener.
   */
  | { readonly kind: 'received'; readonly bytes: Uint8Array; readonly at: number }
  /** Reading continues after it. */
  | { readonly kind: 'line-error'; readonly error: LineError; readonly at: number }
  | { readonly kind: 'state'; readonly state: LinkState };

/** Lines that some adapters need set, to have power or to send. */
export interface OutputSignals {
  readonly dtr?: boolean;
  readonly rts?: boolean;
}
export interface InputSignals {
  readonly cts: boolean;
  readonly dsr: boolean;
  readonly dcd: boolean;
  readonly ri: boolean;
}

/** A way to a line: a port of the computer, or the virtual bus. Nothing here throws or rejects. */
export interface Link {
  readonly state: LinkState;
  /** Counted since it was opened. */
  readonly errors: LineErrorCounts;
  /** Opens it, even after it was lost; answers the state that it has then. */
  open(settings: LinkSettings): Promise<LinkState>;
  close(): Promise<void>;
  /** Whether the adapter took the bytes. They may not have been sent yet. */
  write(bytes: Uint8Array): Promise<boolean>;
  /** Whether they were set: some adapters have no such lines. */
  setSignals(signals: OutputSignals): Promise<boolean>;
  /** `undefined` if the adapter has no such lines. */
  getSignals(): Promise<InputSignals | undefined>;
  /** Answers how to stop listening. */
  listen(listener: (event: LinkEvent) => void): () => void;
}

export const noErrors: LineErrorCounts = { parity: 0, framing: 0, overrun: 0, break: 0, unknown: 0 };
