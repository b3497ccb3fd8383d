import { Found } from './found.ts';
import { addressText, type Datagram, Network, networkLinks } from './network.ts';
import type { CaptureProblem, PacketSink } from './packet.ts';
import { isSerialLink, SerialLinks } from './serial-links.ts';
import { Stream } from './stream.ts';
import { tunnelled } from './tunnels.ts';

const TCP = 6;
const UDP = 17;
const TCP_HEADER = 20;
const UDP_HEADER = 8;
const PORTS = 65_536;
/** The most tunnels one in another. */
const DEEPEST = 4;

/** Puts the packets of a capture together to the frames they carry. */
export class Packets implements PacketSink {
  readonly found = new Found();
  readonly problems: CaptureProblem[] = [];
  /** How many packets there were. */
  count = 0;
  readonly #bytes: Uint8Array;
  readonly #network = new Network();
  readonly #serial = new SerialLinks(this.found);
  /** By the two ends, the lower first: numbers where they are short enough, which is quicker. */
  readonly #streams = new Map<number | string, Map<number | string, Stream>>();
  readonly #unknownLinks = new Map<number, number>();

  constructor(bytes: Uint8Array) {
    this.#bytes = bytes;
  }

  problem = (problem: CaptureProblem): void => {
    this.problems.push(problem);
  };

  packet(number: number, link: number, from: number, to: number, wire: number, time: number): void {
    this.count++;
    const reader = networkLinks.get(link);
    if (reader === undefined) {
      if (isSerialLink(link)) this.#serial.packet(link, this.#bytes, from, to, number, time);
      else this.#unknownLinks.set(link, (this.#unknownLinks.get(link) ?? 0) + 1);
      return;
    }
    const at = reader(this.#bytes, from, to);
    const datagram = at < 0 ? undefined : this.#network.read(this.#bytes, at, to, number);
    // What the file has not of a packet does not count beyond what was on the wire.
    if (datagram !== undefined) this.#datagram(datagram, number, time, wire - (to - from));
  }

  #datagram(datagram: Datagram, number: number, time: number, unseen: number, depth = 0): void {
    const { protocol, bytes, from, to, whole } = datagram;
    const inner = protocol === TCP || depth === DEEPEST ? -1 : tunnelled(datagram);
    if (inner >= 0) {
      const carried = this.#network.read(bytes, inner, to, number);
      if (carried !== undefined) this.#datagram(carried, number, time, unseen, depth + 1);
      return;
    }
    if (protocol === TCP) {
      if (from + TCP_HEADER > to) return;
      const header = ((bytes[from + 12] as number) >> 4) * 4;
      const data = from + header;
      if (header < TCP_HEADER || data > to) return;
      const [stream, side] = this.#stream(datagram, TCP);
      const missing = unseen > 0 ? Math.max(0, whole - to) : 0;
      const segment = { seq: u32(bytes, from + 4), bytes, from: data, to, missing, packet: number, time };
      stream.segment(side, bytes[from + 13] as number, segment, u32(bytes, from + 8));
    } else if (protocol === UDP) {
      if (from + UDP_HEADER >= to) return;
      const length = ((bytes[from + 4] as number) << 8) | (bytes[from + 5] as number);
      const end = length >= UDP_HEADER ? Math.min(to, from + length) : to;
      const [stream, side] = this.#stream(datagram, UDP);
      stream.datagram(side, bytes, from + UDP_HEADER, end, datagram.packets ?? [number], time);
    }
  }

  #stream(datagram: Datagram, protocol: number): readonly [Stream, 0 | 1] {
    const { bytes, from } = datagram;
    const sourcePort = ((bytes[from] as number) << 8) | (bytes[from + 1] as number);
    const destinationPort = ((bytes[from + 2] as number) << 8) | (bytes[from + 3] as number);
    const source = endKey(datagram, datagram.source, sourcePort, protocol);
    const destination = endKey(datagram, datagram.destination, destinationPort, protocol);
    const side = source < destination ? 0 : 1;
    const [low, high] = side === 0 ? [source, destination] : [destination, source];
    let others = this.#streams.get(low);
    if (others === undefined) {
      others = new Map();
      this.#streams.set(low, others);
    }
    let stream = others.get(high);
    if (stream === undefined) {
      const names = [
        endText(datagram, datagram.source, sourcePort),
        endText(datagram, datagram.destination, destinationPort),
      ] as const;
      const ports = [sourcePort, destinationPort] as const;
      stream =
        side === 0
          ? new Stream(names, ports, this.found, this.problem)
          : new Stream([names[1], names[0]], [ports[1], ports[0]], this.found, this.problem);
      others.set(high, stream);
    }
    return [stream, side];
  }

  /** Takes what still waits, and says what could not be read at all. */
  end(): void {
    for (const others of this.#streams.values()) for (const stream of others.values()) stream.end();
    this.#serial.end();
    this.found.finish();
    for (const [link, packets] of this.#unknownLinks) this.problem({ code: 'link-unknown', link, packets });
  }
}

function endKey({ bytes, width }: Datagram, at: number, port: number, protocol: number): number | string {
  // UDP and TCP have ports of their own.
  if (width === 4 && protocol === TCP) return u32(bytes, at) * PORTS + port;
  return `${protocol} ${addressText(bytes, at, width)} ${port}`;
}

function endText({ bytes, width }: Datagram, at: number, port: number): string {
  const address = addressText(bytes, at, width);
  return width === 4 ? `${address}:${port}` : `[${address}]:${port}`;
}

const u32 = (bytes: Uint8Array, at: number): number =>
  (bytes[at] as number) * 0x1000000 +
  (((bytes[at + 1] as number) << 16) | ((bytes[at + 2] as number) << 8) | (bytes[at + 3] as number));
