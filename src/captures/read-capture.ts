import { splitStream } from '../diagnosis/index.ts';
import { fileText } from '../notation/index.ts';
import type { CaptureRecord } from '../trace/index.ts';
import type { PrintedClock } from './clock.ts';
import type { CaptureProblem } from './packet.ts';
import { Packets } from './packets.ts';
import { pcapForm, readPcap } from './pcap.ts';
import { isPcapng, readPcapng } from './pcapng.ts';
import { readLog, type UnframedPiece } from './text.ts';
import { readTraceJson } from './trace-json.ts';
import { readTraceTable } from './trace-table.ts';
import { readTshark } from './tshark.ts';

/** Records that are made when they are asked for, by index or one after another. */
export type Records = ArrayLike<CaptureRecord> & Iterable<CaptureRecord>;

/** The traffic of a file. */
export interface Capture {
  /** `pcap`, `pcapng`, `tshark-json`, `tshark-fields`, `json` or `csv` (our own), `text` or `bytes`; `''` if it is not known. */
  readonly format: string;
  /** In the order of time. */
  readonly records: Records;
  readonly problems: readonly CaptureProblem[];
  /** The bytes and the words of a text or a stream that are in no frame, as records of noise, in their order. */
  readonly pieces?: readonly UnframedPiece[];
  /** What a text prints for its times; without it, they are UTC since 1970, or count from the first record. */
  readonly clock?: PrintedClock | undefined;
}

const NOTHING: Records = Object.freeze([]);

/**
 * The frames in a file of traffic: a capture (pcap, pcapng), what tshark printed, a text as `readBytes` reads it, or the raw bytes
 * of a serial line. The records hold views of `bytes`, which is not to be changed as long as they are used. Never throws; takes
 * time linear in the number of bytes. A gzipped file is to be unpacked before: it has the problem `gzipped`. `tell` hears of a text
 * which part has been read, from 0 to 1.
 */
export function readCapture(bytes: Uint8Array, _name?: string, tell?: (done: number) => void): Capture {
  if (bytes.length === 0) return { format: '', records: NOTHING, problems: [{ code: 'empty' }] };
  if (isGzip(bytes)) return { format: '', records: NOTHING, problems: [{ code: 'gzipped' }] };
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const form = pcapForm(view);
  if (form !== undefined || isPcapng(view)) {
    const packets = new Packets(bytes);
    if (form !== undefined) readPcap(view, form, packets);
    else readPcapng(view, packets);
    packets.end();
    const { found, problems } = packets;
    if (packets.count > 0 && found.length === 0) packets.problem({ code: 'no-modbus', packets: packets.count });
    return {
      format: form === undefined ? 'pcapng' : 'pcap',
      records: lazily(found.length, (index) => found.record(index)),
      problems,
    };
  }
  const text = fileText(bytes);
  if (text === undefined) return { format: 'bytes', ...rawBytes(bytes) };
  const own = readTraceJson(text);
  if (own !== undefined) return { format: 'json', problems: [], ...own };
  const table = readTraceTable(text);
  if (table !== undefined) return { format: 'csv', problems: [], ...table };
  const tshark = readTshark(text);
  if (tshark === undefined) return { format: 'text', ...readLog(text, tell) };
  const { format, found, problems } = tshark;
  return { format, records: lazily(found.length, (index) => found.record(index)), problems };
}

/** Whether a file is neither a text nor a capture nor packed, by its first bytes: a kilobyte of them, or all there are. */
export function isBinary(beginning: Uint8Array): boolean {
  if (beginning.length === 0 || isGzip(beginning)) return false;
  const view = new DataView(beginning.buffer, beginning.byteOffset, beginning.byteLength);
  return pcapForm(view) === undefined && !isPcapng(view) && fileText(beginning) === undefined;
}

const isGzip = (bytes: Uint8Array): boolean => bytes[0] === 0x1f && bytes[1] === 0x8b;

/** What a serial line carried, without times. */
function rawBytes(bytes: Uint8Array): Pick<Capture, 'records' | 'problems' | 'pieces'> {
  const records: CaptureRecord[] = [];
  const pieces: UnframedPiece[] = [];
  for (const segment of splitStream(bytes)) {
    const { from, to } = segment;
    const place = { kind: 'bytes', from, to } as const;
    if (segment.kind === 'gap') {
      const known = { beside: 'noise', why: 'no-frame' } as const;
      const record = { bytes: bytes.subarray(from, to), transport: 'rtu', place, known } as const;
      pieces.push({ before: records.length, problem: { code: 'no-frame', place }, record });
    } else {
      const { transport, direction } = segment;
      records.push({ bytes: bytes.subarray(from, to), transport, place, ...(direction && { side: direction }) });
    }
  }
  return { records, problems: pieces.map(({ problem }) => problem), pieces };
}

/** An array whose elements are made when they are asked for. */
function lazily(length: number, make: (index: number) => CaptureRecord): Records {
  function* each(): Generator<CaptureRecord, void, undefined> {
    for (let index = 0; index < length; index++) yield make(index);
  }
  const known: Readonly<Record<PropertyKey, unknown>> = { length, [Symbol.iterator]: each };
  return new Proxy(known, {
    get(target, key) {
      if (typeof key === 'string' && WHOLE.test(key)) return Number(key) < length ? make(Number(key)) : undefined;
      return target[key];
    },
  }) as unknown as Records;
}

const WHOLE = /^(?:0|[1-9]\d{0,9})$/;
