import { crc16, dictionary, MOST_RTU } from '../modbus/index.ts';
import { type Carriage, carriageOf, frameEnd } from './adus.ts';
import type { Conversation, Found } from './found.ts';

/** Packets between which a serial line was silent for so long do not hold one frame: t3.5 at 1200 baud, and a system's delay. */
const SILENCE = 50_000;
/** A conversation whose ends nobody tells apart. */
const NO_SERVER = 2;
const RTAC_HEADER = 12;
const RTAC_EVENT = 8;
const DATA_FROM_HERE: ReadonlySet<number> = new Set([1, 3]);
const DATA_TO_HERE: ReadonlySet<number> = new Set([2, 4]);

/** One wire of a serial line: its packets may hold a frame, several, or a part of one. */
export class SerialWire {
  readonly #found: Found;
  readonly #conversation: Conversation;
  readonly #side: 0 | 1;
  #rest: Uint8Array | undefined;
  #packets: number[] = [];
  #time = Number.NaN;

  constructor(found: Found, conversation: Conversation, side: 0 | 1) {
    this.#found = found;
    this.#conversation = conversation;
    this.#side = side;
  }

  take(bytes: Uint8Array, from: number, to: number, packet: number, time: number): void {
    const rest = this.#rest;
    if (rest !== undefined) {
      const together = new Uint8Array(rest.length + to - from);
      together.set(rest);
      together.set(bytes.subarray(from, to), rest.length);
      const silent = time - this.#time > SILENCE;
      const closed = !silent && together.length <= MOST_RTU && crc16(together) === 0;
      if (closed) {
        this.#add('rtu', together, 0, together.length, this.#time, [...this.#packets, packet]);
        this.#forget();
        return;
      }
      if (!silent && together.length <= MOST_RTU && !this.#isWhole(bytes, from, to)) {
        this.#rest = together;
        this.#packets.push(packet);
        return;
      }
      this.end();
    }
    let at = from;
    const carriage = carriageOf(bytes, from, to) ?? 'rtu';
    while (at < to) {
      const end = frameEnd(carriage, bytes, at, to);
      if (end < 0) break;
      this.#add(carriage, bytes, at, end, time, [packet]);
      at = end;
    }
    if (at === to) return;
    this.#rest = bytes.slice(at, to);
    this.#packets = [packet];
    this.#time = time;
  }

  #isWhole(bytes: Uint8Array, from: number, to: number): boolean {
    return carriageOf(bytes, from, to) !== undefined || frameEnd('rtu', bytes, from, to) >= 0;
  }

  #add(
    carriage: Carriage,
    bytes: Uint8Array,
    from: number,
    to: number,
    time: number,
    packets: readonly number[],
  ): void {
    this.#found.add(this.#conversation, this.#side, carriage, bytes, from, to, time, packets);
  }

  #forget(): void {
    this.#rest = undefined;
    this.#packets = [];
  }

  /** What no frame was made of stands as it was heard: a frame that was damaged. */
  end(): void {
    if (this.#rest !== undefined) this.#add('rtu', this.#rest, 0, this.#rest.length, this.#time, this.#packets);
    this.#forget();
  }
}

const RTAC = 250;
const FIRST_USER = 147;
const LAST_USER = 162;
const UPPER = 252;

export const isSerialLink = (link: number): boolean =>
  link === RTAC || link === UPPER || (link >= FIRST_USER && link <= LAST_USER);

const TAG = { end: 0, dissector: 12, sourcePort: 25, destinationPort: 26 } as const;
const MODBUS_PORT = 502;
const DISSECTORS: Readonly<Record<string, Carriage>> = dictionary({ mbrtu: 'rtu', mbtcp: 'tcp', modbus: 'rtu' });

/** The serial lines of a capture: one a link type, with a wire for each direction where the packets tell it. */
export class SerialLinks {
  readonly #found: Found;
  readonly #wires = new Map<number, SerialWire>();
  readonly #rtac: Conversation = { ends: ['RTAC', 'line'], server: -1 };
  readonly #line: Conversation = { ends: [undefined, undefined], server: NO_SERVER };
  readonly #upper: Conversation = { ends: [undefined, undefined], server: 1 };

  constructor(found: Found) {
    this.#found = found;
  }

  packet(link: number, bytes: Uint8Array, from: number, to: number, packet: number, time: number): void {
    if (link === RTAC) {
      const event = bytes[from + RTAC_EVENT] ?? 0;
      const data = from + RTAC_HEADER;
      if (data >= to) return;
      const side = DATA_FROM_HERE.has(event) ? 0 : DATA_TO_HERE.has(event) ? 1 : undefined;
      if (side !== undefined) this.#wire(2 * link + side, this.#rtac, side).take(bytes, data, to, packet, time);
    } else if (link === UPPER) this.#upperPdu(bytes, from, to, packet, time);
    else this.#wire(2 * link, this.#line, 0).take(bytes, from, to, packet, time);
  }

  #wire(key: number, conversation: Conversation, side: 0 | 1): SerialWire {
    let wire = this.#wires.get(key);
    if (wire === undefined) {
      wire = new SerialWire(this.#found, conversation, side);
      this.#wires.set(key, wire);
    }
    return wire;
  }

  /** An "upper PDU" of Wireshark: tags in front of the bytes, which name the dissector and the ports. */
  #upperPdu(bytes: Uint8Array, from: number, to: number, packet: number, time: number): void {
    let name = '';
    const ports = [0, 0];
    let at = from;
    for (;;) {
      if (at + 4 > to) return;
      const tag = ((bytes[at] as number) << 8) | (bytes[at + 1] as number);
      const length = ((bytes[at + 2] as number) << 8) | (bytes[at + 3] as number);
      const value = at + 4;
      at = value + length;
      if (at > to) return;
      if (tag === TAG.end) break;
      if (tag === TAG.dissector)
        name = String.fromCharCode(...bytes.subarray(value, at))
          .replaceAll('\0', '')
          .trim();
      if (tag === TAG.sourcePort) ports[0] = portAt(bytes, value);
      if (tag === TAG.destinationPort) ports[1] = portAt(bytes, value);
    }
    const carriage = DISSECTORS[name];
    if (carriage === undefined || at >= to) return;
    const told = ports.includes(MODBUS_PORT);
    const conversation = told ? this.#upper : this.#line;
    const side = told && ports[0] === MODBUS_PORT ? 1 : 0;
    this.#found.add(conversation, side, carriage, bytes, at, to, time, [packet]);
  }

  end(): void {
    for (const wire of this.#wires.values()) wire.end();
  }
}

const portAt = (bytes: Uint8Array, at: number): number => ((bytes[at + 2] as number) << 8) | (bytes[at + 3] as number);
