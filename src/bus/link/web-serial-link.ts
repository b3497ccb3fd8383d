import { dictionary } from '../../modbus/index.ts';
import type { Clock } from '../clock.ts';
import { Listeners } from '../listeners.ts';
import { type Adapter, adapterOf } from './adapters.ts';
import {
  type InputSignals,
  type LineError,
  type LineErrorCounts,
  type Link,
  type LinkEvent,
  type LinkSettings,
  type LinkState,
  noErrors,
  type OutputSignals,
} from './link.ts';

/** Errors that end the stream of bytes while the port stays open and offers another stream. */
/** A port that was pulled out is closed within this time, in milliseconds, or the browser has lost it. */
const LONGEST_CLOSING = 5000;

const LINE_ERRORS: Readonly<Record<string, LineError>> = dictionary({
  ParityError: 'parity',
  FramingError: 'framing',
  BufferOverrunError: 'overrun',
  BreakError: 'break',
  UnknownError: 'unknown',
});

const nameOf = (error: unknown): string => (error instanceof Error ? error.name : '');
const messageOf = (error: unknown): string => (error instanceof Error ? error.message : String(error));

/** A port of the computer, through Web Serial, in a window or a worker. */
export class WebSerialLink implements Link {
  readonly #port: SerialPort;
  readonly #clock: Clock;
  readonly #adapter: Adapter;
  readonly #listeners = new Listeners<LinkEvent>();
  #state: LinkState = { kind: 'closed' };
  #errors = noErrors;
  #reader: ReadableStreamDefaultReader<Uint8Array> | undefined;
  #writer: WritableStreamDefaultWriter<Uint8Array> | undefined;
  #reading: Promise<void> = Promise.resolve();
  #tidied: Promise<void> = Promise.resolve();

  constructor(port: SerialPort, clock: Clock) {
    this.#port = port;
    this.#clock = clock;
    this.#adapter = adapterOf(port.getInfo());
    port.addEventListener('disconnect', () => {
      const state = this.#state;
      if (state.kind === 'open' || state.kind === 'opening') this.#lose('unplugged');
      // On some systems the port fails first, and the reason comes a moment later.
      else if (state.kind === 'lost') this.#become({ ...state, why: 'unplugged' });
    });
  }

  get state(): LinkState {
    return this.#state;
  }

  get errors(): LineErrorCounts {
    return this.#errors;
  }

  listen(listener: (event: LinkEvent) => void): () => void {
    return this.#listeners.add(listener);
  }

  async open(settings: LinkSettings): Promise<LinkState> {
    if (['opening', 'open', 'closing'].includes(this.#state.kind)) return this.#state;
    const adapter = this.#adapter;
    this.#become({ kind: 'opening', adapter, settings });
    await this.#tidied;
    const { baud, dataBits, parity, stopBits, flowControl, bufferSize } = settings;
    try {
      await this.#port.open({ baudRate: baud, dataBits, parity, stopBits, flowControl, bufferSize });
    } catch (error) {
      if (this.state.kind !== 'opening') return this.state;
      return this.#become(this.#whyNot(error, settings));
    }
    if (this.state.kind !== 'opening') {
      this.#tidied = this.#tidy();
      return this.state;
    }
    this.#errors = noErrors;
    this.#become({ kind: 'open', adapter, settings, since: this.#clock.now() });
    this.#reading = this.#read();
    return this.state;
  }

  async close(): Promise<void> {
    if (this.#state.kind === 'closed' || this.#state.kind === 'closing') return;
    this.#become({ kind: 'closing', adapter: this.#adapter });
    await this.#tidied;
    await this.#tidy();
    this.#become({ kind: 'closed' });
  }

  async write(bytes: Uint8Array): Promise<boolean> {
    const { writable } = this.#port;
    if (this.#state.kind !== 'open' || writable === null) return false;
    try {
      this.#writer ??= writable.getWriter();
      await this.#writer.write(bytes);
      return true;
    } catch {
      this.#writer?.releaseLock();
      this.#writer = undefined;
      return false;
    }
  }

  async setSignals({ dtr, rts }: OutputSignals): Promise<boolean> {
    try {
      await this.#port.setSignals({
        ...(dtr !== undefined && { dataTerminalReady: dtr }),
        ...(rts !== undefined && { requestToSend: rts }),
      });
      return true;
    } catch {
      return false;
    }
  }

  async getSignals(): Promise<InputSignals | undefined> {
    try {
      const { clearToSend, dataSetReady, dataCarrierDetect, ringIndicator } = await this.#port.getSignals();
      return { cts: clearToSend, dsr: dataSetReady, dcd: dataCarrierDetect, ri: ringIndicator };
    } catch {
      return undefined;
    }
  }

  #become(state: LinkState): LinkState {
    this.#state = state;
    this.#listeners.tell({ kind: 'state', state });
    return state;
  }

  #whyNot(error: unknown, settings: LinkSettings): LinkState {
    const adapter = this.#adapter;
    switch (nameOf(error)) {
      case 'NetworkError':
        // Chromium has this since version 130. For the browser, a port that is plugged in again may be another one.
        return this.#port.connected === false
          ? { kind: 'lost', adapter, why: 'unplugged', at: this.#clock.now() }
          : { kind: 'taken', adapter, by: 'other-program' };
      case 'InvalidStateError':
        return { kind: 'taken', adapter, by: 'this-page' };
      default:
        return { kind: 'failed', adapter, settings, message: messageOf(error) };
    }
  }

  /** Reads until the port is closed or lost; a stream that ended with an error of the line is followed by the next. */
  async #read(): Promise<void> {
    let before: ReadableStream<Uint8Array> | undefined;
    while (this.#state.kind === 'open') {
      const { readable } = this.#port;
      if (readable === null || readable === before) break;
      before = readable;
      this.#reader = readable.getReader();
      try {
        for (;;) {
          const { value, done } = await this.#reader.read();
          if (done) break;
          if (value.length > 0) this.#listeners.tell({ kind: 'received', bytes: value, at: this.#clock.now() });
        }
      } catch (error) {
        const lineError = LINE_ERRORS[nameOf(error)];
        if (lineError === undefined) break;
        this.#errors = { ...this.#errors, [lineError]: this.#errors[lineError] + 1 };
        this.#listeners.tell({ kind: 'line-error', error: lineError, at: this.#clock.now() });
      } finally {
        this.#reader.releaseLock();
        this.#reader = undefined;
      }
    }
    if (this.#state.kind === 'open') this.#lose('gone');
  }

  #lose(why: 'unplugged' | 'gone'): void {
    this.#become({ kind: 'lost', adapter: this.#adapter, why, at: this.#clock.now() });
    this.#tidied = this.#tidy();
  }

  /** Releases the port, whatever happens, so that it can be opened again. A browser that does not answer is not waited for. */
  async #tidy(): Promise<void> {
    let cancel = () => {};
    const late = new Promise<void>((resolve) => {
      cancel = this.#clock.after(LONGEST_CLOSING, resolve);
    });
    await Promise.race([this.#release(), late]);
    cancel();
  }

  async #release(): Promise<void> {
    const writer = this.#writer;
    this.#writer = undefined;
    // Bytes that an adapter holds back for its flow control would keep the port from closing.
    await writer?.abort().catch(() => undefined);
    writer?.releaseLock();
    await this.#reader?.cancel().catch(() => undefined);
    // If the reading has noticed the loss, it ends after this.
    if (this.#reader !== undefined) await this.#reading;
    await this.#port.close().catch(() => undefined);
  }
}
