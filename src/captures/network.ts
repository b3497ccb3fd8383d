import { hexDigits } from '../modbus/index.ts';

/** Where the payload of a transport protocol lies, and between whom it went. */
export interface Datagram {
  protocol: number;
  from: number;
  to: number;
  /** Where the payload ends by the length in the header, which may be more than was captured. */
  whole: number;
  /** The two addresses: where they lie in `bytes`, and how long they are. */
  source: number;
  destination: number;
  width: number;
  bytes: Uint8Array;
  /** The packets of its fragments; absent if it came in one. */
  packets: readonly number[] | undefined;
}

const IPV4 = 0x0800;
const IPV6 = 0x86dd;
const TAGS: ReadonlySet<number> = new Set([0x8100, 0x88a8, 0x9100, 0x9200]);
const SNAP = 0xaaaa03;
const LEAST_TYPE = 0x600;
const PPPOE = 0x8864;
const PPPOE_HEADER = 6;
/** IPv4 and IPv6 as PPP numbers them. */
const PPP: ReadonlySet<number> = new Set([0x0021, 0x0057]);
const MPLS: ReadonlySet<number> = new Set([0x8847, 0x8848]);
const PPI = 192;
const PPI_HEADER = 8;

/** What is behind the link's header: where an IP packet begins; −1 if none does. */
export type LinkReader = (bytes: Uint8Array, at: number, end: number) => number;

export const u16 = (bytes: Uint8Array, at: number): number => ((bytes[at] as number) << 8) | (bytes[at + 1] as number);

/** From a type of Ethernet on, through the tags of VLANs. */
function behindType(bytes: Uint8Array, typeAt: number, end: number): number {
  let at = typeAt;
  while (at + 2 <= end && TAGS.has(u16(bytes, at))) at += 4;
  if (at + 2 > end) return -1;
  const type = u16(bytes, at);
  if (type === IPV4 || type === IPV6) return at + 2;
  if (type === PPPOE) return behindPpp(bytes, at + 2 + PPPOE_HEADER, end);
  if (MPLS.has(type)) return behindLabels(bytes, at + 2, end);
  // IEEE 802.3 with a length, LLC and SNAP.
  const isSnap = type < LEAST_TYPE && at + 10 <= end && ((bytes[at + 2] as number) << 16) + u16(bytes, at + 3) === SNAP;
  return isSnap && (u16(bytes, at + 8) === IPV4 || u16(bytes, at + 8) === IPV6) ? at + 10 : -1;
}

/** Behind the header of PPP, which may lack its address and the first byte of its protocol (RFC 1661, 6.5 and 6.6). */
function behindPpp(bytes: Uint8Array, from: number, end: number): number {
  const at = bytes[from] === 0xff && bytes[from + 1] === 0x03 ? from + 2 : from;
  const protocol = at + 2 <= end ? u16(bytes, at) : 0;
  if (PPP.has(protocol)) return at + 2;
  return PPP.has(protocol >> 8) ? at + 1 : -1;
}

/** Behind the labels of MPLS, the last of which says so (RFC 3032, 2.1). */
function behindLabels(bytes: Uint8Array, from: number, end: number): number {
  let at = from;
  while (at + 4 < end && ((bytes[at + 2] as number) & 1) === 0) at += 4;
  return at + 4 < end ? at + 4 : -1;
}

/** Behind a header that says its length and the type of the link (PPI). */
function behindPpi(bytes: Uint8Array, at: number, end: number): number {
  if (at + PPI_HEADER > end) return -1;
  const little = (place: number) => (bytes[place] as number) | ((bytes[place + 1] as number) << 8);
  const link = little(at + 4);
  return link === PPI ? -1 : (networkLinks.get(link)?.(bytes, at + little(at + 2), end) ?? -1);
}

const behind =
  (header: number): LinkReader =>
  (_bytes, at, end) =>
    at + header < end ? at + header : -1;

/** The types of links that carry IP (the list of link-layer header types), each with what finds the packet. */
export const networkLinks: ReadonlyMap<number, LinkReader> = new Map<number, LinkReader>([
  [0, behind(4)],
  [1, (bytes, at, end) => behindType(bytes, at + 12, end)],
  [9, behindPpp],
  [12, behind(0)],
  [14, behind(0)],
  [50, behindPpp],
  [51, (bytes, at, end) => behindPpp(bytes, at + PPPOE_HEADER, end)],
  [101, behind(0)],
  [108, behind(4)],
  [113, (bytes, at, end) => behindType(bytes, at + 14, end)],
  [PPI, behindPpi],
  [228, behind(0)],
  [229, behind(0)],
  [
    276,
    (bytes, at, end) => (u16(bytes, at) === IPV4 || u16(bytes, at) === IPV6 ? at + 20 : behindTags276(bytes, at, end)),
  ],
]);

/** In Linux cooked 2 the tags of a VLAN stand behind the header. */
function behindTags276(bytes: Uint8Array, at: number, end: number): number {
  if (!TAGS.has(u16(bytes, at))) return -1;
  let tag = at + 20;
  while (tag + 4 <= end && TAGS.has(u16(bytes, tag + 2))) tag += 4;
  const type = tag + 4 <= end ? u16(bytes, tag + 2) : 0;
  return type === IPV4 || type === IPV6 ? tag + 4 : -1;
}

const V4_HEADER = 20;
const V6_HEADER = 40;
const MORE = 0x2000;
const OFFSET_MASK = 0x1fff;
const FRAGMENT = 44;
const AUTHENTICATION = 51;
/** Extension headers whose second byte is their length in eight bytes, less one: hop by hop, routing, destination, mobility. */
const EXTENSIONS: ReadonlySet<number> = new Set([0, 43, 60, 135]);
const MOST_FRAGMENTED = 1024;

interface Fragments {
  readonly pieces: { readonly offset: number; readonly bytes: Uint8Array; readonly packet: number }[];
  end: number | undefined;
  header: Datagram;
}

/** Reads IP packets, and puts fragments together. One datagram is used again and again. */
export class Network {
  readonly #out: Datagram = {
    protocol: 0,
    from: 0,
    to: 0,
    whole: 0,
    source: 0,
    destination: 0,
    width: 4,
    bytes: new Uint8Array(0),
    packets: undefined,
  };
  readonly #fragments = new Map<string, Fragments>();

  /** The datagram in the IP packet at `at`; `undefined` if there is none, or if it is a fragment that others still miss. */
  read(bytes: Uint8Array, at: number, end: number, packet: number): Datagram | undefined {
    const version = at < end ? (bytes[at] as number) >> 4 : 0;
    if (version === 4) return this.#readV4(bytes, at, end, packet);
    if (version === 6) return this.#readV6(bytes, at, end, packet);
    return undefined;
  }

  #readV4(bytes: Uint8Array, at: number, end: number, packet: number): Datagram | undefined {
    const header = ((bytes[at] as number) & 0x0f) * 4;
    if (header < V4_HEADER || at + header > end) return undefined;
    const total = u16(bytes, at + 2);
    // A length of 0 is that of a packet which the network card will cut into pieces.
    const whole = total === 0 ? end : at + total;
    if (whole < at + header) return undefined;
    const out = this.#out;
    out.protocol = bytes[at + 9] as number;
    out.from = at + header;
    out.to = Math.min(whole, end);
    out.whole = whole;
    out.source = at + 12;
    out.destination = at + 16;
    out.width = 4;
    out.bytes = bytes;
    const flags = u16(bytes, at + 6);
    if ((flags & (MORE | OFFSET_MASK)) === 0) return out;
    return this.#fragment(u16(bytes, at + 4), (flags & OFFSET_MASK) * 8, (flags & MORE) !== 0, packet);
  }

  #readV6(bytes: Uint8Array, at: number, end: number, packet: number): Datagram | undefined {
    if (at + V6_HEADER > end) return undefined;
    const length = u16(bytes, at + 4);
    const whole = length === 0 ? end : at + V6_HEADER + length;
    const out = this.#out;
    out.source = at + 8;
    out.destination = at + 24;
    out.width = 16;
    out.bytes = bytes;
    out.whole = whole;
    out.to = Math.min(whole, end);
    let next = bytes[at + 6] as number;
    let from = at + V6_HEADER;
    let piece: { id: number; offset: number; more: boolean } | undefined;
    while (EXTENSIONS.has(next) || next === FRAGMENT || next === AUTHENTICATION) {
      if (from + 8 > out.to) return undefined;
      const size =
        next === FRAGMENT
          ? 8
          : ((bytes[from + 1] as number) + (next === AUTHENTICATION ? 2 : 1)) * (next === AUTHENTICATION ? 4 : 8);
      if (next === FRAGMENT) {
        const flags = u16(bytes, from + 2);
        const offset = flags & 0xfff8;
        const more = (flags & 1) !== 0;
        if (offset !== 0 || more) piece = { id: u16(bytes, from + 4) * 65536 + u16(bytes, from + 6), offset, more };
      }
      next = bytes[from] as number;
      from += size;
      // Behind the header of a fragment that is not the first stands its payload.
      if (piece !== undefined && piece.offset > 0) break;
    }
    if (from > out.to) return undefined;
    out.protocol = next;
    out.from = from;
    return piece === undefined ? out : this.#fragment(piece.id, piece.offset, piece.more, packet);
  }

  #fragment(id: number, offset: number, more: boolean, packet: number): Datagram | undefined {
    const { bytes, source, destination, width, from, to, protocol } = this.#out;
    const addresses = `${bytes.subarray(source, source + width).join()}>${bytes.subarray(destination, destination + width).join()}`;
    const key = `${addresses} ${id}`;
    let all = this.#fragments.get(key);
    if (all === undefined) {
      all = {
        pieces: [],
        end: undefined,
        header: {
          ...this.#out,
          bytes: bytes.slice(source, destination + width),
          source: 0,
          destination: destination - source,
        },
      };
      this.#fragments.set(key, all);
      if (this.#fragments.size > MOST_FRAGMENTED) this.#fragments.delete(this.#fragments.keys().next().value as string);
    }
    if (offset === 0) all.header = { ...all.header, protocol };
    all.pieces.push({ offset, bytes: bytes.subarray(from, to), packet });
    if (!more) all.end = offset + to - from;
    if (all.end === undefined) return undefined;
    const joined = new Uint8Array(all.end);
    const pieces = all.pieces.sort((a, b) => a.offset - b.offset);
    let covered = 0;
    for (const piece of pieces) {
      if (piece.offset > covered) return undefined;
      const left = piece.bytes.subarray(0, Math.max(0, all.end - piece.offset));
      joined.set(left, piece.offset);
      covered = Math.max(covered, piece.offset + left.length);
    }
    if (covered < all.end) return undefined;
    this.#fragments.delete(key);
    const { header } = all;
    const names = header.bytes;
    const out = new Uint8Array(names.length + joined.length);
    out.set(names);
    out.set(joined, names.length);
    const packets = pieces.map((piece) => piece.packet).sort((a, b) => a - b);
    return { ...header, bytes: out, from: names.length, to: out.length, whole: out.length, packets };
  }
}

/** An IP address as text. */
export function addressText(bytes: Uint8Array, at: number, width: number): string {
  if (width === 4) return bytes.subarray(at, at + 4).join('.');
  const groups = Array.from({ length: 8 }, (_, group) => u16(bytes, at + 2 * group));
  // The longest run of zeros is left out (RFC 5952).
  let [run, best, bestAt] = [0, 1, -1];
  groups.forEach((group, index) => {
    run = group === 0 ? run + 1 : 0;
    if (run > best) [best, bestAt] = [run, index - run + 1];
  });
  const text = (list: readonly number[]) => list.map((group) => hexDigits(group, 1).toLowerCase()).join(':');
  return bestAt < 0 ? text(groups) : `${text(groups.slice(0, bestAt))}::${text(groups.slice(bestAt + best))}`;
}
