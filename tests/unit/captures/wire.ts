/** Captures made byte by byte, as the formats of pcap, pcapng, Ethernet, IP and TCP lay them down. */

export const hex = (text: string): Uint8Array =>
  Uint8Array.from(text.match(/[0-9a-f]{2}/gi) ?? [], (pair) => Number.parseInt(pair, 16));

export function joined(...parts: readonly (Uint8Array | readonly number[])[]): Uint8Array {
  const all = parts.flatMap((part) => [...part]);
  return Uint8Array.from(all);
}

const big = (value: number, width: number) =>
  Array.from({ length: width }, (_, i) => Math.floor(value / 256 ** (width - 1 - i)) % 256);
const little = (value: number, width: number) => big(value, width).reverse();
export const number = (value: number, width: number, isLittle: boolean): number[] =>
  (isLittle ? little : big)(value, width);

export interface Packet {
  readonly bytes: Uint8Array;
  readonly seconds?: number;
  /** Microseconds, or what the file counts. */
  readonly fraction?: number;
  /** Its length on the wire, if more than was kept. */
  readonly wire?: number;
}

/** A pcap file. */
export function pcap(packets: readonly Packet[], { link = 1, isLittle = true, nanoseconds = false } = {}): Uint8Array {
  const n = (value: number, width: number) => number(value, width, isLittle);
  return joined(
    n(nanoseconds ? 0xa1b23c4d : 0xa1b2c3d4, 4),
    n(2, 2),
    n(4, 2),
    n(0, 4),
    n(0, 4),
    n(65535, 4),
    n(link, 4),
    ...packets.flatMap(({ bytes, seconds = 0, fraction = 0, wire = bytes.length }) => [
      n(seconds, 4),
      n(fraction, 4),
      n(bytes.length, 4),
      n(wire, 4),
      bytes,
    ]),
  );
}

/** A block of pcapng; its body is padded to four bytes. */
export function block(type: number, body: Uint8Array, isLittle = true): Uint8Array {
  const padding = new Uint8Array((4 - (body.length % 4)) % 4);
  const length = number(12 + body.length + padding.length, 4, isLittle);
  return joined(number(type, 4, isLittle), length, body, padding, length);
}

export const section = (isLittle = true): Uint8Array =>
  block(
    0x0a0d0d0a,
    joined(
      number(0x1a2b3c4d, 4, isLittle),
      number(1, 2, isLittle),
      number(0, 2, isLittle),
      new Uint8Array(8).fill(0xff),
    ),
    isLittle,
  );

export const interfaceBlock = (link: number, options: readonly number[] = [], isLittle = true, snap = 0): Uint8Array =>
  block(1, joined(number(link, 2, isLittle), [0, 0], number(snap, 4, isLittle), options), isLittle);

/** An Enhanced Packet Block; `ticks` is its time stamp. */
export const enhanced = (bytes: Uint8Array, ticks: bigint, id = 0, isLittle = true): Uint8Array =>
  block(
    6,
    joined(
      number(id, 4, isLittle),
      number(Number(ticks >> 32n), 4, isLittle),
      number(Number(ticks & 0xffffffffn), 4, isLittle),
      number(bytes.length, 4, isLittle),
      number(bytes.length, 4, isLittle),
      bytes,
    ),
    isLittle,
  );

export interface Ends {
  readonly source?: readonly number[];
  readonly destination?: readonly number[];
  readonly from?: number;
  readonly to?: number;
}

export const CLIENT = [192, 0, 2, 1] as const;
export const SERVER = [192, 0, 2, 2] as const;
export const SYN = 0x02;
export const ACK = 0x10;

/** The client asks from port 49152, the server answers from 502. */
export const asks: Ends = { source: CLIENT, destination: SERVER, from: 49152, to: 502 };
export const answers: Ends = { source: SERVER, destination: CLIENT, from: 502, to: 49152 };

export const tcp = (
  { from = 49152, to = 502 }: Ends,
  seq: number,
  payload: Uint8Array,
  { flags = ACK, ack = 0 }: { flags?: number; ack?: number } = {},
): Uint8Array =>
  joined(big(from, 2), big(to, 2), big(seq, 4), big(ack, 4), [0x50, flags], [0x20, 0x00, 0, 0, 0, 0], payload);

export const udp = ({ from = 49152, to = 502 }: Ends, payload: Uint8Array): Uint8Array =>
  joined(big(from, 2), big(to, 2), big(8 + payload.length, 2), [0, 0], payload);

export interface V4 {
  readonly protocol?: number;
  readonly id?: number;
  /** Flags and offset. */
  readonly fragment?: number;
  /** Options, in whole words. */
  readonly options?: readonly number[];
}

export const ipv4 = (
  { source = CLIENT, destination = SERVER }: Ends,
  payload: Uint8Array,
  { protocol = 6, id = 1, fragment = 0, options = [] }: V4 = {},
): Uint8Array =>
  joined(
    [0x45 + options.length / 4, 0],
    big(20 + options.length + payload.length, 2),
    big(id, 2),
    big(fragment, 2),
    [64, protocol, 0, 0],
    source,
    destination,
    options,
    payload,
  );

export const V6_CLIENT = hex('20010db8000000000000000000000001');
export const V6_SERVER = hex('20010db8000000000000000000000002');

/** `headers` are extension headers, the first of the type `next`. */
export const ipv6 = (
  isAsking: boolean,
  payload: Uint8Array,
  next = 6,
  headers: Uint8Array = new Uint8Array(),
): Uint8Array =>
  joined(
    [0x60, 0, 0, 0],
    big(headers.length + payload.length, 2),
    [next, 64],
    isAsking ? V6_CLIENT : V6_SERVER,
    isAsking ? V6_SERVER : V6_CLIENT,
    headers,
    payload,
  );

export const ethernet = (payload: Uint8Array, type = 0x0800, tags: readonly number[] = []): Uint8Array =>
  joined(new Uint8Array(12), tags, big(type, 2), payload);

/** AP 6.3's request and reply as ADUs of TCP, transaction 1. */
export const REQUEST = hex('00 01 00 00 00 06 01 03 00 6B 00 03');
export const REPLY = hex('00 01 00 00 00 09 01 03 06 02 2B 00 00 00 64');
export const SECOND_REQUEST = hex('00 02 00 00 00 06 01 03 00 6B 00 03');
