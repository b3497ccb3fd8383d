import type { PacketSink } from './packet.ts';

const HEADER = 24;
const RECORD = 16;
const LINK_MASK = 0x0fffffff;
const SECOND = 1_000_000;
const NANOSECONDS = 1000;
const MICROSECOND_MAGIC = 0xa1b2c3d4;
const NANOSECOND_MAGIC = 0xa1b23c4d;
/** Of a patched libpcap, whose packets have eight more bytes of header. */
const PATCHED_MAGIC = 0xa1b2cd34;
const PATCHED_RECORD = 24;
const LEAST = 4;

interface PcapForm {
  readonly little: boolean;
  readonly nanoseconds: boolean;
  /** Bytes before each packet. */
  readonly record: number;
}

/** How a pcap file is written; `undefined` if the bytes are not one. */
export function pcapForm(view: DataView): PcapForm | undefined {
  if (view.byteLength < LEAST) return undefined;
  for (const little of [true, false]) {
    const magic = view.getUint32(0, little);
    if (magic === MICROSECOND_MAGIC) return { little, nanoseconds: false, record: RECORD };
    if (magic === NANOSECOND_MAGIC) return { little, nanoseconds: true, record: RECORD };
    if (magic === PATCHED_MAGIC) return { little, nanoseconds: false, record: PATCHED_RECORD };
  }
  return undefined;
}

/** The packets of a pcap file (draft-ietf-opsawg-pcap); it may end anywhere. */
export function readPcap(view: DataView, { little, nanoseconds, record }: PcapForm, sink: PacketSink): void {
  if (view.byteLength < HEADER) {
    sink.problem({ code: 'cut-off', place: { kind: 'bytes', from: 0, to: view.byteLength } });
    return;
  }
  const link = view.getUint32(20, little) & LINK_MASK;
  const end = view.byteLength;
  let number = 0;
  for (let at = HEADER; at < end; ) {
    if (at + record > end) {
      sink.problem({ code: 'cut-off', place: { kind: 'bytes', from: at, to: end } });
      return;
    }
    const seconds = view.getUint32(at, little);
    const fraction = view.getUint32(at + 4, little);
    const length = view.getUint32(at + 8, little);
    const wire = view.getUint32(at + 12, little);
    const from = at + record;
    const to = from + length;
    number++;
    if (to > end) {
      sink.problem({ code: 'cut-off', place: { kind: 'packet', numbers: [number] } });
      return;
    }
    const time = seconds * SECOND + (nanoseconds ? Math.floor(fraction / NANOSECONDS) : fraction);
    sink.packet(number, link, from, to, wire, time);
    at = to;
  }
}
