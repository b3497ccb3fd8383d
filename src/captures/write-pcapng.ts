import { crc16, fromHex, joinBytes, lrc } from '../modbus/index.ts';
import type { CaptureRecord } from '../trace/index.ts';

/** A frame that is written into a capture. One without a time is a simple packet, or stands at the beginning of 1970. */
export interface WrittenRecord {
  readonly bytes: Uint8Array;
  readonly transport: CaptureRecord['transport'];
  readonly side?: CaptureRecord['side'];
  /** Microseconds since 1970. */
  readonly time?: number | undefined;
  /** Who spoke to whom; on TCP `192.0.2.1:49152`, and what is not such an address has one that stands for it. */
  readonly from?: string | undefined;
  readonly to?: string | undefined;
  readonly comment?: string | undefined;
}

/**
 * The capture format of Wireshark (pcapng, draft-ietf-opsawg-pcapng). Serial frames stand in it as "upper PDUs"
 * (LINKTYPE_WIRESHARK_UPPER_PDU), each with the name of the dissector that reads it, so that Wireshark decodes them without
 * any setting; and with ports, by which that dissector tells requests from replies. Those of TCP have headers of Ethernet, IP and TCP.
 */
const UPPER_PDU = 252;
const ETHERNET = 1;
const DISSECTOR = 'mbrtu';
const SERVER_PORT = 502;
const CLIENT_PORT = 49_152;

const SECTION_HEADER = 0x0a0d0d0a;
const BYTE_ORDER_MAGIC = 0x1a2b3c4d;
const INTERFACE = 1;
const SIMPLE_PACKET = 3;
const PACKET = 6;
const COMMENT = 1;
const WORD = 2 ** 32;
const TAG = { end: 0, dissector: 12, portType: 24, sourcePort: 25, destinationPort: 26 } as const;
const PORT_TYPE_UDP = 3;

/** Frames as a capture. Wireshark knows no ASCII mode: such frames stand in it as the RTU frames that say the same. */
export const writePcapng = (records: Iterable<WrittenRecord>): Uint8Array<ArrayBuffer> =>
  joinBytes([...pcapngBlocks(records)]);

/** Such a capture in parts: its head, and then the blocks of each frame. */
export function* pcapngBlocks(records: Iterable<WrittenRecord>): Generator<Uint8Array<ArrayBuffer>, void, undefined> {
  yield block(SECTION_HEADER, [u32(BYTE_ORDER_MAGIC), u16(1), u16(0), u32(0xffffffff), u32(0xffffffff)]);
  // A file of one kind of frame has one interface. Each stands before its first frame.
  const links: number[] = [];
  const connections = new Connections();
  const describe = (link: number) => {
    links.push(link);
    return block(INTERFACE, [u16(link), u16(0), u32(0)]);
  };
  for (const record of records) {
    const link = record.transport === 'tcp' ? ETHERNET : UPPER_PDU;
    const head = links.includes(link) ? undefined : describe(link);
    const own = link === ETHERNET ? connections.packet(record) : upperPdu(record);
    const written = packet(links.indexOf(link), own, record);
    yield head ? joinBytes([head, written]) : written;
  }
  if (links.length === 0) yield describe(UPPER_PDU);
}

/** The bytes of a packet: how many there are, and what writes them, with the view of all, at a place. */
interface Packed {
  readonly size: number;
  readonly write: (bytes: Uint8Array, view: DataView, at: number) => void;
}

function packet(on: number, { size, write }: Packed, { time, comment }: WrittenRecord): Uint8Array<ArrayBuffer> {
  // A simple packet has no time, and belongs to the first interface.
  const isSimple = time === undefined && on === 0 && comment === undefined;
  const said = comment === undefined ? undefined : characters(comment);
  const head = isSimple ? 12 : 28;
  const length = head + padded(size) + (said ? 8 + padded(said.length) : 0) + 4;
  const bytes = new Uint8Array(length);
  const view = new DataView(bytes.buffer);
  view.setUint32(0, isSimple ? SIMPLE_PACKET : PACKET, true);
  view.setUint32(4, length, true);
  view.setUint32(head - 4, size, true);
  if (!isSimple) {
    const microseconds = Math.max(0, Math.round(time ?? 0));
    view.setUint32(8, on, true);
    view.setUint32(12, Math.floor(microseconds / WORD), true);
    view.setUint32(16, microseconds % WORD, true);
    view.setUint32(20, size, true);
  }
  write(bytes, view, head);
  if (said) {
    const at = head + padded(size);
    view.setUint16(at, COMMENT, true);
    view.setUint16(at + 2, said.length, true);
    bytes.set(said, at + 4);
  }
  view.setUint32(length - 4, length, true);
  return bytes;
}

function upperPdu({ bytes, side, transport }: WrittenRecord): Packed {
  const own = transport === 'ascii' ? asRtu(bytes) : bytes;
  const tags = side === 'response' ? FROM_SERVER : TO_SERVER;
  return {
    size: tags.length + own.length,
    write: (to, _view, at) => {
      to.set(tags, at);
      to.set(own, at + tags.length);
    },
  };
}

const DIGITS = /^:((?:[0-9A-F]{2}){3,})\r?\n?$/i;

/** The frame of RTU that says what one of ASCII does, with a wrong CRC for a wrong LRC; what is not such a frame stays as it is. */
function asRtu(bytes: Uint8Array): Uint8Array {
  const [, digits = ''] = DIGITS.exec(String.fromCharCode(...bytes)) ?? [];
  const pairs = fromHex(digits);
  if (pairs === undefined || pairs.length === 0) return bytes;
  const end = pairs.length - 1;
  const crc = crc16(pairs, 0, end) ^ (lrc(pairs, 0, end) === pairs[end] ? 0 : WRONG);
  return Uint8Array.of(...pairs.subarray(0, end), crc & 0xff, crc >> 8);
}

const WRONG = 0xffff;

interface End {
  readonly address: number;
  readonly port: number;
  /** The number of its next byte. */
  sequence: number;
}

const MAC = { client: [2, 0, 0, 0, 0, 1], server: [2, 0, 0, 0, 0, 2] } as const;
/** 192.0.2.1 and what follows it, an address that documents use (RFC 5737). */
const STAND_IN = 0xc0000201;
const IPV4 = /^(\d{1,3})\.(\d{1,3})\.(\d{1,3})\.(\d{1,3}):(\d{1,5})$/;
const HEADERS = 40;
const LINK = 14;
const IP_VERSION_4 = 0x0800;
const DO_NOT_FRAGMENT = 0x4000;
/** 64 hops, and TCP. */
const HOPS_AND_TCP = 0x4006;
const TCP = 6;
const FIVE_WORDS = 0x5000;
const PSH_ACK = 0x18;
const WINDOW = 0xffff;
/** Bytes of one packet, so that its length fits. */
const MOST = 65_535 - HEADERS;

/** The TCP connections of a capture: each side goes on where it has ended before. */
class Connections {
  readonly #ends = new Map<string, [client: End, server: End]>();
  /** Addresses that stand for what is not written as one, by their text. */
  readonly #standIns = new Map<string, number>();

  /** An Ethernet packet with the headers of IPv4 (RFC 791) and TCP (RFC 9293), and their checksums. */
  packet({ bytes, side, from, to }: WrittenRecord): Packed {
    const payload = bytes.subarray(0, MOST);
    const isReply = side === 'response';
    const [client, server] = isReply ? [to, from] : [from, to];
    const key = `${client ?? ''}\n${server ?? ''}`;
    let ends = this.#ends.get(key);
    if (ends === undefined) {
      ends = [this.#end(client ?? 'client', CLIENT_PORT + this.#ends.size), this.#end(server ?? 'server', SERVER_PORT)];
      this.#ends.set(key, ends);
    }
    const [source, destination] = isReply ? [ends[1], ends[0]] : ends;
    const { sequence } = source;
    source.sequence = (source.sequence + payload.length) >>> 0;
    const [one, other] = isReply ? [MAC.client, MAC.server] : [MAC.server, MAC.client];
    return {
      size: LINK + HEADERS + payload.length,
      write: (to, view, at) => {
        to.set(one, at);
        to.set(other, at + 6);
        view.setUint16(at + 12, IP_VERSION_4);
        const ip = at + LINK;
        view.setUint16(ip, 0x4500);
        view.setUint16(ip + 2, HEADERS + payload.length);
        view.setUint16(ip + 6, DO_NOT_FRAGMENT);
        view.setUint16(ip + 8, HOPS_AND_TCP);
        view.setUint32(ip + 12, source.address);
        view.setUint32(ip + 16, destination.address);
        view.setUint16(ip + 10, sumOf(view, ip, ip + 20, 0));
        const tcp = ip + 20;
        view.setUint16(tcp, source.port);
        view.setUint16(tcp + 2, destination.port);
        view.setUint32(tcp + 4, sequence);
        view.setUint32(tcp + 8, destination.sequence);
        view.setUint16(tcp + 12, FIVE_WORDS | PSH_ACK);
        view.setUint16(tcp + 14, WINDOW);
        to.set(payload, tcp + 20);
        const end = tcp + 20 + payload.length;
        // The pseudo header has the addresses, the protocol and the length (RFC 9293 3.1).
        const pseudo = sumOf(view, ip + 12, tcp, TCP + end - tcp) ^ WINDOW;
        view.setUint16(tcp + 16, sumOf(view, tcp, end, pseudo));
      },
    };
  }

  #end(text: string, port: number): End {
    const found = IPV4.exec(text)?.slice(1).map(Number);
    if (found?.every((part, at) => part < (at === 4 ? 65_536 : 256))) {
      const [a = 0, b = 0, c = 0, d = 0, own = port] = found;
      return { address: ((a << 24) | (b << 16) | (c << 8) | d) >>> 0, port: own, sequence: 1 };
    }
    let address = this.#standIns.get(text);
    if (address === undefined) {
      address = STAND_IN + this.#standIns.size;
      this.#standIns.set(text, address);
    }
    return { address, port: Math.min(port, 65_535), sequence: 1 };
  }
}

/** The checksum of the Internet (RFC 1071) over the bytes `[from, to)`, begun with a sum. */
function sumOf(view: DataView, from: number, to: number, begun: number): number {
  let sum = begun;
  for (let at = from; at + 1 < to; at += 2) sum += view.getUint16(at);
  if ((to - from) % 2 === 1) sum += view.getUint8(to - 1) << 8;
  while (sum > 0xffff) sum = (sum & 0xffff) + Math.floor(sum / 0x10000);
  return sum ^ 0xffff;
}

/** A block: its type, its length at both ends, and its body between them. */
function block(type: number, parts: readonly Uint8Array[]): Uint8Array<ArrayBuffer> {
  const length = u32(parts.reduce((sum, part) => sum + part.length, 12));
  return joinBytes([u32(type), length, ...parts, length]);
}

/** A tag of an upper PDU; unlike the blocks around it, in network order. */
const tag = (type: number, value: Uint8Array): Uint8Array => joinBytes([big16(type), big16(value.length), value]);

/** A text of ASCII; other characters become question marks. */
const characters = (text: string) =>
  Uint8Array.from(text, (character) => (character < '\x7f' ? character.charCodeAt(0) : 0x3f));

const u16 = (value: number) => new Uint8Array(Uint16Array.of(value).buffer);
const u32 = (value: number) => new Uint8Array(Uint32Array.of(value).buffer);
const big16 = (value: number) => u16(value).reverse();
const big32 = (value: number) => u32(value).reverse();
/** A length with what fills it up to whole words. */
const padded = (length: number) => (length + 3) & ~3;

/** What stands before a frame to a server, and before one of a server. */
const tagsOf = (source: number, destination: number) =>
  joinBytes([
    tag(TAG.dissector, characters(DISSECTOR.padEnd(padded(DISSECTOR.length), '\0'))),
    tag(TAG.portType, big32(PORT_TYPE_UDP)),
    tag(TAG.sourcePort, big32(source)),
    tag(TAG.destinationPort, big32(destination)),
    tag(TAG.end, new Uint8Array(0)),
  ]);
const TO_SERVER = tagsOf(CLIENT_PORT, SERVER_PORT);
const FROM_SERVER = tagsOf(SERVER_PORT, CLIENT_PORT);
