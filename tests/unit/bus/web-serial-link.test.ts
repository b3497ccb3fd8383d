import { expect, test, vi } from 'vitest';
import {
  adapterOf,
  choosePort,
  defaultSettings,
  type LinkEvent,
  type LinkSettings,
  serialSupport,
  WebSerialLink,
} from '../../../src/bus/index.ts';
import { VirtualClock } from './virtual-clock.ts';

const named = (name: string, message = name) => Object.assign(new Error(message), { name });

/** A port as browsers have it: an error of the line ends its stream, and `readable` is another one from then on. */
class Port extends EventTarget {
  readable: ReadableStream<Uint8Array> | null = null;
  writable: WritableStream<Uint8Array> | null = null;
  readonly written: Uint8Array[] = [];
  opened: SerialOptions | undefined;
  refuses: Error | undefined;
  holdsBack = false;
  neverCloses = false;
  connected = true;
  #input: ReadableStreamDefaultController<Uint8Array> | undefined;

  getInfo() {
    return { usbVendorId: 0x0403, usbProductId: 0x6001 };
  }

  async open(options: SerialOptions) {
    if (this.refuses !== undefined) throw this.refuses;
    this.opened = options;
    this.#stream();
    this.writable = new WritableStream({
      write: (bytes, { signal }) => {
        this.written.push(bytes);
        if (!this.holdsBack) return undefined;
        return new Promise((_, reject) => signal.addEventListener('abort', () => reject(signal.reason)));
      },
    });
  }

  async close() {
    if (this.neverCloses) await new Promise<never>(() => {});
    if (this.readable?.locked || this.writable?.locked) throw new TypeError('locked');
    this.opened = undefined;
    this.readable = null;
    this.writable = null;
  }

  receive(...bytes: number[]) {
    this.#input?.enqueue(Uint8Array.from(bytes));
  }

  fail(name: string) {
    const input = this.#input;
    if (name === 'NetworkError') this.readable = null;
    else this.#stream();
    input?.error(named(name));
  }

  setSignals(): Promise<void> {
    return Promise.reject(named('NetworkError'));
  }

  getSignals(): Promise<SerialInputSignals> {
    return Promise.reject(named('NetworkError'));
  }

  #stream() {
    this.readable = new ReadableStream({
      start: (input) => {
        this.#input = input;
      },
    });
  }
}

async function opened() {
  const port = new Port();
  const clock = new VirtualClock();
  const link = new WebSerialLink(port as unknown as SerialPort, clock);
  const events: LinkEvent[] = [];
  link.listen((event) => events.push(event));
  await link.open({ ...defaultSettings, baud: 9600, parity: 'none', stopBits: 2 });
  return { port, link, clock, events };
}

const kinds = (events: readonly LinkEvent[]) =>
  events.map((event) => (event.kind === 'state' ? event.state.kind : event.kind));

/** What a setting becomes when a port is opened: a setting that is added has to be named here, and to get there. */
const OPENED: {
  readonly [K in keyof Required<LinkSettings>]: readonly [keyof SerialOptions, LinkSettings[K], LinkSettings[K]];
} = {
  baud: ['baudRate', 1200, 115_200],
  dataBits: ['dataBits', 7, 8],
  parity: ['parity', 'even', 'odd'],
  stopBits: ['stopBits', 1, 2],
  flowControl: ['flowControl', 'none', 'hardware'],
  bufferSize: ['bufferSize', 255, 65_536],
};

test('opens a port with each of its settings, and with nothing else', async () => {
  const names = Object.keys(OPENED) as (keyof LinkSettings)[];
  expect(names.toSorted()).toEqual(Object.keys(defaultSettings).toSorted());
  for (const name of names) {
    const [option, ...values] = OPENED[name];
    for (const value of values) {
      const port = new Port();
      await new WebSerialLink(port as unknown as SerialPort, new VirtualClock()).open({
        ...defaultSettings,
        [name]: value,
      });
      expect(port.opened?.[option], name).toBe(value);
      expect(Object.keys(port.opened ?? {})).toHaveLength(names.length);
    }
  }
});

test('opens with its settings, writes, reads and closes', async () => {
  const { port, link, events } = await opened();
  expect(port.opened).toEqual({
    baudRate: 9600,
    dataBits: 8,
    parity: 'none',
    stopBits: 2,
    flowControl: 'none',
    bufferSize: 4096,
  });
  expect(link.state).toMatchObject({ kind: 'open', adapter: { kind: 'usb', maker: 'FTDI', chip: 'FT232R' } });
  expect(await link.write(Uint8Array.of(1, 2))).toBe(true);
  expect(port.written).toEqual([Uint8Array.of(1, 2)]);
  port.receive(3, 4);
  await vi.waitFor(() => expect(events.at(-1)).toEqual({ kind: 'received', bytes: Uint8Array.of(3, 4), at: 0 }));
  await link.close();
  expect(port.opened).toBeUndefined();
  expect(kinds(events)).toEqual(['opening', 'open', 'received', 'closing', 'closed']);
  expect(await link.write(Uint8Array.of(1))).toBe(false);
});

test.each([
  ['ParityError', 'parity'],
  ['FramingError', 'framing'],
  ['BufferOverrunError', 'overrun'],
  ['BreakError', 'break'],
  ['UnknownError', 'unknown'],
] as const)('%s is counted, and reading goes on', async (name, error) => {
  const { port, link, events } = await opened();
  port.fail(name);
  await vi.waitFor(() => expect(link.errors[error]).toBe(1));
  port.receive(7);
  await vi.waitFor(() => expect(kinds(events)).toEqual(['opening', 'open', 'line-error', 'received']));
  expect(link.state.kind).toBe('open');
});

test('a port that is gone is lost, let go of, and opens again', async () => {
  const { port, link, events } = await opened();
  await link.write(Uint8Array.of(1));
  port.fail('NetworkError');
  await vi.waitFor(() => expect(link.state).toMatchObject({ kind: 'lost', why: 'gone' }));
  await vi.waitFor(() => expect(port.writable).toBeNull());
  expect(await link.open(defaultSettings)).toMatchObject({ kind: 'open' });
  expect(await link.write(Uint8Array.of(1))).toBe(true);
  expect(kinds(events)).toEqual(['opening', 'open', 'lost', 'opening', 'open']);
});

test('a port that is unplugged is lost although its stream goes on waiting', async () => {
  const { port, link } = await opened();
  port.dispatchEvent(new Event('disconnect'));
  expect(link.state).toMatchObject({ kind: 'lost', why: 'unplugged' });
  await vi.waitFor(() => expect(port.readable).toBeNull());
  await link.close();
  expect(link.state).toEqual({ kind: 'closed' });
});

test('a port that fails first and is reported as unplugged behind it says the latter', async () => {
  const { port, link, events } = await opened();
  port.fail('NetworkError');
  await vi.waitFor(() => expect(link.state).toMatchObject({ kind: 'lost', why: 'gone' }));
  port.dispatchEvent(new Event('disconnect'));
  expect(link.state).toMatchObject({ kind: 'lost', why: 'unplugged' });
  expect(kinds(events)).toEqual(['opening', 'open', 'lost', 'lost']);
});

test('closes although the adapter holds bytes back', async () => {
  const { port, link } = await opened();
  port.holdsBack = true;
  const written = link.write(Uint8Array.of(1));
  await link.close();
  expect(await written).toBe(false);
  expect(link.state).toEqual({ kind: 'closed' });
});

test('is closed although the browser never says that its port is', async () => {
  const { port, link, clock } = await opened();
  port.neverCloses = true;
  const closing = link.close();
  await clock.advance(4999);
  expect(link.state).toMatchObject({ kind: 'closing' });
  await clock.advance(1);
  await closing;
  expect(link.state).toEqual({ kind: 'closed' });
});

test('says why it does not open', async () => {
  const { port, link } = await opened();
  await link.close();
  port.refuses = named('NetworkError', 'Failed to open serial port.');
  expect(await link.open(defaultSettings)).toMatchObject({ kind: 'taken', by: 'other-program' });
  port.connected = false;
  expect(await link.open(defaultSettings)).toMatchObject({ kind: 'lost', why: 'unplugged' });
  port.connected = true;
  port.refuses = named('InvalidStateError');
  expect(await link.open(defaultSettings)).toMatchObject({ kind: 'taken', by: 'this-page' });
  port.refuses = new TypeError('baudRate');
  expect(await link.open(defaultSettings)).toMatchObject({ kind: 'failed', message: 'baudRate' });
  port.refuses = undefined;
  expect(await link.open(defaultSettings)).toMatchObject({ kind: 'open' });
});

test('an adapter without signals says so', async () => {
  const { link } = await opened();
  expect(await link.setSignals({ dtr: true })).toBe(false);
  expect(await link.getSignals()).toBeUndefined();
});

test('adapters have names by their USB numbers', () => {
  expect(adapterOf({ usbVendorId: 0x1a86, usbProductId: 0x7523 })).toMatchObject({ maker: 'WCH', chip: 'CH340' });
  expect(adapterOf({ usbVendorId: 0x10c4, usbProductId: 0xea60 })).toMatchObject({ chip: 'CP210x' });
  expect(adapterOf({ usbVendorId: 0x067b, usbProductId: 0x2303 })).toMatchObject({ chip: 'PL2303' });
  expect(adapterOf({ usbVendorId: 0x1234, usbProductId: 1 })).toEqual({ kind: 'usb', vendorId: 0x1234, productId: 1 });
  expect(adapterOf({})).toEqual({ kind: 'port' });
});

test('the chooser that shows nothing says why', async () => {
  const refusing = (error: Error) => choosePort({ requestPort: () => Promise.reject(error) } as unknown as Serial);
  expect(await refusing(named('NotFoundError', 'No port selected by the user.'))).toMatchObject({ why: 'cancelled' });
  const gesture = 'Must be handling a user gesture to show a permission request.';
  expect(await refusing(named('SecurityError', gesture))).toMatchObject({ why: 'no-gesture' });
  const policy = 'Access to the feature "serial" is disallowed by permissions policy.';
  expect(await refusing(named('SecurityError', policy))).toMatchObject({ why: 'policy' });
  expect(serialSupport({ isSecureContext: true, navigator: {} })).toMatchObject({ why: 'no-api' });
  expect(serialSupport({ isSecureContext: false, navigator: {} })).toMatchObject({ why: 'insecure' });
  expect(serialSupport({ isSecureContext: true, navigator: { serial: {} } })).toBeUndefined();
});
