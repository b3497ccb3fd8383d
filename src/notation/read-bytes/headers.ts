import type { ByteText, Chunk, TextProblem, TextRange } from './types.ts';

/** The parts of a reading that headers are taken from. */
type Read = Pick<ByteText, 'bytes' | 'origin' | 'chunks' | 'problems'>;

/** What of a packet is not headers, and what its ports say. */
interface Payload {
  readonly from: number;
  readonly to: number;
  readonly direction: 'request' | 'response' | undefined;
}

/** The port of Modbus/TCP (TG 4.2.2). */
const MODBUS = 502;
const TCP = 6;
const UDP = 17;
/** Fewest bytes of the headers of IP and UDP. */
const LEAST = 28;
const MAC_HEADER = 14;
/** Ethernet pads what is shorter than its shortest packet with so many zeros at most. */
const MOST_PADDING = 46;

/**
 * The bytes without the headers of the packets in which a network carried them: Ethernet, if it is there, IP, and TCP or
 * UDP, told by their versions and lengths. What is left of a packet is a chunk, and its headers are a problem; a packet with
 * nothing behind its headers leaves no chunk. Where no chunk is a packet, what was read stays as it is.
 */
export function withoutHeaders(read: Read): Read {
  const { bytes } = read;
  const payloads = read.chunks.map(({ from, to }) => payloadOf(bytes.subarray(from, to)));
  if (payloads.every((payload) => payload === undefined)) return read;
  const chunks: Chunk[] = [];
  const origin: TextRange[] = [];
  const problems: TextProblem[] = [...read.problems];
  const kept: number[] = [];
  for (const [index, chunk] of read.chunks.entries()) {
    const payload = payloads[index];
    const from = chunk.from + (payload?.from ?? 0);
    const to = payload === undefined ? chunk.to : chunk.from + payload.to;
    const start = kept.length;
    for (let at = from; at < to; at++) {
      kept.push(bytes[at] as number);
      origin.push(read.origin[at] as TextRange);
    }
    if (payload !== undefined) {
      for (const [first, end] of [
        [chunk.from, from],
        [to, chunk.to],
      ] as const) {
        const place = { start: read.origin[first]?.start ?? 0, end: read.origin[end - 1]?.end ?? 0 };
        if (end > first) problems.push({ code: 'set-aside', ...place, why: 'headers' });
      }
    }
    if (kept.length === start) continue;
    const direction = chunk.direction ?? payload?.direction;
    chunks.push({ ...chunk, from: start, to: kept.length, ...(direction !== undefined && { direction }) });
  }
  return { bytes: Uint8Array.from(kept), origin, chunks, problems: problems.sort((a, b) => a.start - b.start) };
}

const word = (bytes: Uint8Array, at: number): number => ((bytes[at] ?? 0) << 8) | (bytes[at + 1] ?? 0);

/** Where a packet's own bytes lie; `undefined` if these are not a packet. */
function payloadOf(bytes: Uint8Array): Payload | undefined {
  const link = linkHeader(bytes);
  if (link === undefined || bytes.length < link + LEAST) return undefined;
  const version = (bytes[link] as number) >> 4;
  const [size, length, protocol] =
    version === 4
      ? [4 * ((bytes[link] as number) & 15), word(bytes, link + 2), bytes[link + 9]]
      : [40, 40 + word(bytes, link + 4), bytes[link + 6]];
  const end = link + length;
  if (size < 20 || end > bytes.length || bytes.length - end > MOST_PADDING || !isPadding(bytes, end)) return undefined;
  const at = link + size;
  const head = protocol === TCP ? 4 * ((bytes[at + 12] ?? 0) >> 4) : protocol === UDP ? 8 : 0;
  if (head < (protocol === TCP ? 20 : 8) || at + head > end) return undefined;
  if (protocol === UDP && word(bytes, at + 4) !== end - at) return undefined;
  const [source, destination] = [word(bytes, at), word(bytes, at + 2)];
  const direction = destination === MODBUS ? 'request' : source === MODBUS ? 'response' : undefined;
  return { from: at + head, to: end, direction };
}

const isPadding = (bytes: Uint8Array, end: number): boolean => bytes.subarray(end).every((byte) => byte === 0);

/** How many bytes stand before the header of IP: none, those of a loopback, of Ethernet with or without a VLAN, of Linux's `any`. */
function linkHeader(bytes: Uint8Array): number | undefined {
  if (isIp(bytes, 0)) return 0;
  const type = (at: number) => word(bytes, at) === 0x0800 || word(bytes, at) === 0x86dd;
  if (type(12) && isIp(bytes, MAC_HEADER)) return MAC_HEADER;
  if (word(bytes, 12) === 0x8100 && type(16) && isIp(bytes, 18)) return 18;
  if (type(14) && isIp(bytes, 16)) return 16;
  const isFamily = (bytes[0] === 2 || bytes[3] === 2) && (bytes[1] ?? 1) + (bytes[2] ?? 1) === 0;
  return isFamily && isIp(bytes, 4) ? 4 : undefined;
}

/** Whether a header of IP may begin at a place: version 4 and its length, or version 6 and one of the protocols. */
function isIp(bytes: Uint8Array, at: number): boolean {
  const first = bytes[at] ?? 0;
  const protocol = bytes[at + (first >> 4 === 6 ? 6 : 9)];
  if (protocol !== TCP && protocol !== UDP) return false;
  return first >> 4 === 6 || (first >= 0x45 && first <= 0x4f);
}
