import { decodeFrame, encodeFrame } from '../modbus/index.ts';
import type { CaptureRecord } from '../trace/index.ts';

/** A frame that is written into a capture. Without a time it stands at the beginning of 1970. */
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
const PACKET = 6;
const COMMENT = 1;
const TAG = { end: 0, dissector: 12, portType: 24, sourcePort: 25, destinationPort: 26 } as const;
const PORT_TYPE_UDP = 3;

/** Frames as a capture. Wireshark knows no ASCII mode: such frames stand in it as the RTU frames that say the same. */
export function writePcapng(records: Iterable<WrittenRecord>): Uint8Array<ArrayBuffer> {
  const packets: Uint8Array[] = [];
  // A file of one kind of frame has one interface.
  const links: number[] = [];
  const interfaceOf = (link: number) => {
    if (!links.includes(link)) links.push(link);
    return links.indexOf(link);
  };
  const connections = new Connections();
  for (const record of records) {
    const isTcp = record.transport === 'tcp';
    const data = isTcp ? connections.packet(record) : upperPdu(record);
    packets.push(packet(interfaceOf(isTcp ? ETHERNET : UPPER_PDU), data, record));
  }
  return joined([
    block(SECTION_HEADER, [u32(BYTE_ORDER_MAGIC), u16(1), u16(0), u32(0xffffffff), u32(0xffffffff)]),
    ...(links.length > 0 ? links : [UPPER_PDU]).map((link) => block(INTERFACE, [u16(link), u16(0), u32(0)])),
    ...packets,
  ]);
}

function packet(on: number, data: Uint8Array, { time = 0, comment }: WrittenRecord): Uint8Array {
  const microseconds = BigInt(Math.max(0, Math.round(time)));
  const said = characters(comment ?? '');
  return block(PACKET, [
    u32(on),
    u32(Number(microseconds >> 32n)),
    u32(Number(microseconds & 0xffffffffn)),
    u32(data.length),
    u32(data.length),
    padded(data),
    ...(comment === undefined ? [] : [u16(COMMENT), u16(said.length), padded(said), u32(0)]),
  ]);
}

function upperPdu({ bytes, side, transport }: WrittenRecord): Uint8Array {
  const isRequest = side !== 'response';
  const [source, destination] = isRequest ? [CLIENT_PORT, SERVER_PORT] : [SERVER_PORT, CLIENT_PORT];
  return joined([
    tag(TAG.dissector, padded(characters(DISSECTOR))),
    tag(TAG.portType, big32(PORT_TYPE_UDP)),
    tag(TAG.sourcePort, big32(source)),
    tag(TAG.destinationPort, big32(destination)),
    tag(TAG.end, new Uint8Array(0)),
    transport === 'ascii' ? asRtu(bytes, isRequest) : bytes,
  ]);
}

function asRtu(bytes: Uint8Array, isRequest: boolean): Uint8Array {
  const reading = decodeFrame(bytes, { transport: 'ascii', direction: isRequest ? 'request' : 'response' });
  return reading.outcome.kind === 'whole' ? encodeFrame({ ...reading, transport: 'rtu' }) : bytes;
}

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
const PSH_ACK = 0x18;
/** Bytes of one packet, so that its length fits. */
const MOST = 65_535 - HEADERS;

/** The TCP connections of a capture: each side goes on where it has ended before. */
class Connections {
  readonly #ends = new Map<string, [client: End, server: End]>();
  /** Addresses that stand for what is not written as one, by their text. */
  readonly #standIns = new Map<string, number>();

  /** An Ethernet packet with the headers of IPv4 (RFC 791) and TCP (RFC 9293), and their checksums. */
  packet({ bytes, side, from, to }: WrittenRecord): Uint8Array {
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
    const tcp = joined([
      big16(source.port),
      big16(destination.port),
      big32(source.sequence),
      big32(destination.sequence),
      Uint8Array.of(0x50, PSH_ACK),
      big16(0xffff),
      big32(0),
      payload,
    ]);
    const pseudo = joined([big32(source.address), big32(destination.address), Uint8Array.of(0, 6), big16(tcp.length)]);
    tcp.set(big16(sumOf(joined([pseudo, tcp]))), 16);
    const ip = joined([
      Uint8Array.of(0x45, 0),
      big16(HEADERS + payload.length),
      big32(0x4000),
      Uint8Array.of(64, 6, 0, 0),
      big32(source.address),
      big32(destination.address),
    ]);
    ip.set(big16(sumOf(ip)), 10);
    source.sequence = (source.sequence + payload.length) >>> 0;
    const [one, other] = isReply ? [MAC.client, MAC.server] : [MAC.server, MAC.client];
    return joined([Uint8Array.from([...one, ...other, 8, 0]), ip, tcp]);
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

/** The checksum of the Internet (RFC 1071). */
function sumOf(bytes: Uint8Array): number {
  let sum = 0;
  bytes.forEach((byte, at) => {
    sum += at % 2 === 0 ? byte << 8 : byte;
  });
  while (sum > 0xffff) sum = (sum & 0xffff) + Math.floor(sum / 0x10000);
  return sum ^ 0xffff;
}

/** A block: its type, its length at both ends, and its body between them. */
function block(type: number, parts: readonly Uint8Array[]): Uint8Array {
  const length = u32(parts.reduce((sum, part) => sum + part.length, 12));
  return joined([u32(type), length, ...parts, length]);
}

/** A tag of an upper PDU; unlike the blocks around it, in network order. */
const tag = (type: number, value: Uint8Array): Uint8Array => joined([big16(type), big16(value.length), value]);

/** A text of ASCII; other characters become question marks. */
const characters = (text: string) =>
  Uint8Array.from(text, (character) => (character < '\x7f' ? character.charCodeAt(0) : 0x3f));

const u16 = (value: number) => new Uint8Array(Uint16Array.of(value).buffer);
const u32 = (value: number) => new Uint8Array(Uint32Array.of(value).buffer);
const big16 = (value: number) => u16(value).reverse();
const big32 = (value: number) => u32(value).reverse();
const padded = (bytes: Uint8Array) => joined([bytes, new Uint8Array(-bytes.length & 3)]);

function joined(parts: readonly Uint8Array[]): Uint8Array<ArrayBuffer> {
  const all = new Uint8Array(parts.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const part of parts) {
    all.set(part, at);
    at += part.length;
  }
  return all;
}
