import type { PacketSink } from './packet.ts';

const HEADER = 24;
const RECORD = 16;
const LINK_MASK = 0x0fffffff;
const SECOND = 1_000_000;
const NANOSECONDS = 1000;
const MICROSECOND_MAGIC = 0xa1b2c3d4;
const NANOSECOND_MAGIC = 0xa1b23c4d;

/** How the numbers of a pcap file are written; `undefined` if the bytes are not one. */
export function pcapForm(view: DataView): { readonly little: boolean; readonly nanoseconds: boolean } | undefined {
  if (view.byteLength < HEADER) return undefined;
  for (const little of [true, false]) {
    const magic = view.getUint32(0, little);
    if (magic === MICROSECOND_MAGIC || magic === NANOSECOND_MAGIC) {
      return { little, nanoseconds: magic === NANOSECOND_MAGIC };
    }
  }
  return undefined;
}

/** The packets of a pcap file (draft-ietf-opsawg-pcap); it may end anywhere. */
export function readPcap(
  view: DataView,
  { little, nanoseconds }: { little: boolean; nanoseconds: boolean },
  sink: PacketSink,
): void {
  const link = view.getUint32(20, little) & LINK_MASK;
  const end = view.byteLength;
  let number = 0;
  for (let at = HEADER; at < end; ) {
    if (at + RECORD > end) {
      sink.problem({ code: 'cut-off', place: { kind: 'bytes', from: at, to: end } });
      return;
    }
    const seconds = view.getUint32(at, little);
    const fraction = view.getUint32(at + 4, little);
    const length = view.getUint32(at + 8, little);
    const wire = view.getUint32(at + 12, little);
    const from = at + RECORD;
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
