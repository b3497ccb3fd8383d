import type { PacketSink } from './packet.ts';

const SECTION = 0x0a0d0d0a;
const INTERFACE = 1;
const OLD_PACKET = 2;
const SIMPLE = 3;
const ENHANCED = 6;
const BYTE_ORDER = 0x1a2b3c4d;
const RESOLUTION = 9;
const OFFSET = 14;
const LEAST_BLOCK = 12;
const SECOND = 1_000_000;
const WORD = 2 ** 32;
const POWER_OF_TWO = 0x80;
const MICROSECONDS = 6;
/** The most decimals of a second with which exact whole numbers are enough. */
const MOST_DECIMALS = 12;

interface Interface {
  readonly link: number;
  readonly snap: number;
  /** Microseconds of a time stamp in two words. */
  readonly time: (high: number, low: number) => number;
}

export const isPcapng = (view: DataView): boolean =>
  view.byteLength >= LEAST_BLOCK &&
  view.getUint32(0) === SECTION &&
  (view.getUint32(8, true) === BYTE_ORDER || view.getUint32(8, false) === BYTE_ORDER);

/** The packets of a pcapng file (draft-ietf-opsawg-pcapng): several sections, blocks of any kind; it may end anywhere. */
export function readPcapng(view: DataView, sink: PacketSink): void {
  const end = view.byteLength;
  let little = true;
  let interfaces: Interface[] = [];
  let number = 0;
  for (let at = 0; at < end; ) {
    if (at + LEAST_BLOCK > end) {
      cut(at);
      return;
    }
    const isSection = view.getUint32(at) === SECTION;
    if (isSection) {
      const swapped = view.getUint32(at + 8, false) === BYTE_ORDER;
      if (!swapped && view.getUint32(at + 8, true) !== BYTE_ORDER) {
        broken(at);
        return;
      }
      little = !swapped;
      interfaces = [];
    }
    const type = view.getUint32(at, little);
    const length = view.getUint32(at + 4, little);
    if (length < LEAST_BLOCK || length % 4 !== 0) {
      broken(at);
      return;
    }
    if (at + length > end) {
      if (type === ENHANCED || type === SIMPLE || type === OLD_PACKET) number++;
      cut(at);
      return;
    }
    const body = at + 8;
    const last = at + length - 4;
    if (type === INTERFACE && last - body >= 8) interfaces.push(readInterface(view, body, last, little));
    else if (type === ENHANCED && last - body >= 20) {
      packet(view.getUint32(body, little), body + 4, body + 12, last);
    } else if (type === OLD_PACKET && last - body >= 20) {
      packet(view.getUint16(body, little), body + 4, body + 12, last);
    } else if (type === SIMPLE && last - body >= 4) {
      number++;
      const wire = view.getUint32(body, little);
      const [first] = interfaces;
      if (first === undefined)
        sink.problem({ code: 'interface-unknown', place: { kind: 'packet', numbers: [number] } });
      else {
        const kept = Math.min(wire, first.snap || wire, last - body - 4);
        sink.packet(number, first.link, body + 4, body + 4 + kept, wire, Number.NaN);
      }
    }
    at += length;
  }

  function packet(id: number, stamp: number, lengths: number, last: number): void {
    number++;
    const known = interfaces[id];
    const kept = view.getUint32(lengths, little);
    const from = lengths + 8;
    if (known === undefined || from + kept > last) {
      const code = known === undefined ? 'interface-unknown' : 'block-broken';
      sink.problem({ code, place: { kind: 'packet', numbers: [number] } });
      return;
    }
    const time = known.time(view.getUint32(stamp, little), view.getUint32(stamp + 4, little));
    sink.packet(number, known.link, from, from + kept, view.getUint32(lengths + 4, little), time);
  }

  function cut(at: number): void {
    sink.problem({ code: 'cut-off', place: { kind: 'bytes', from: at, to: end } });
  }

  function broken(at: number): void {
    sink.problem({ code: 'block-broken', place: { kind: 'bytes', from: at, to: end } });
  }
}

function readInterface(view: DataView, body: number, last: number, little: boolean): Interface {
  let resolution = MICROSECONDS;
  let offset = 0;
  for (let at = body + 8; at + 4 <= last; ) {
    const code = view.getUint16(at, little);
    const length = view.getUint16(at + 2, little);
    const value = at + 4;
    if (code === 0 || value + length > last) break;
    if (code === RESOLUTION && length >= 1) resolution = view.getUint8(value);
    if (code === OFFSET && length >= 8) offset = Number(view.getBigInt64(value, little)) * SECOND;
    at = value + length + ((4 - (length % 4)) % 4);
  }
  const count = ticks(resolution);
  return {
    link: view.getUint16(body, little),
    snap: view.getUint32(body + 4, little),
    time: (high, low) => count(high, low) + offset,
  };
}

/** Microseconds of a count of ticks: of a power of ten of a second, or of a power of two if the highest bit is set. */
function ticks(resolution: number): Interface['time'] {
  if (resolution === MICROSECONDS) return (high, low) => high * WORD + low;
  const isBinary = (resolution & POWER_OF_TWO) !== 0;
  if (!isBinary && resolution > MICROSECONDS && resolution <= MOST_DECIMALS) {
    const each = 10 ** (resolution - MICROSECONDS);
    // In two steps, so that no number passes 2⁵³.
    return (high, low) => Math.floor(high / each) * WORD + Math.floor(((high % each) * WORD + low) / each);
  }
  const second = isBinary ? 1n << BigInt(resolution & ~POWER_OF_TWO) : 10n ** BigInt(resolution);
  return (high, low) => Number((((BigInt(high) << 32n) | BigInt(low)) * BigInt(SECOND)) / second);
}
