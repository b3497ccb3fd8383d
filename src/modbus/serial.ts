import { crc16 } from './crc16.ts';
import { toHex } from './hex.ts';
import { lrc } from './lrc.ts';
import { closePdu, readPdu } from './pdu.ts';
import type { Section } from './problem.ts';
import type { Reading } from './reading.ts';
import { type FieldKind, Span } from './span.ts';
import { checkUnit } from './unit-rules.ts';

/** How a serial frame is checked. */
export interface Checksum {
  readonly algorithm: 'crc' | 'lrc';
  readonly width: 1 | 2;
  readonly section: Section;
  compute(bytes: Uint8Array, from: number, to: number): number;
  /** The checksum as it stands at `at`. */
  read(bytes: Uint8Array, at: number): number;
  write(out: Uint8Array, at: number, value: number): void;
}

/** Two bytes, the low one first (SL 2.5.1.2). */
export const CRC: Checksum = {
  algorithm: 'crc',
  width: 2,
  section: 'SL 2.5.1.2',
  compute: crc16,
  read: (bytes, at) => (bytes[at] as number) | ((bytes[at + 1] as number) << 8),
  write: (out, at, value) => {
    out[at] = value & 0xff;
    out[at + 1] = value >>> 8;
  },
};

export const LRC: Checksum = {
  algorithm: 'lrc',
  width: 1,
  section: 'SL 2.5.2.2',
  compute: lrc,
  read: (bytes, at) => bytes[at] as number,
  write: (out, at, value) => {
    out[at] = value;
  },
};

/**
 * What is known about a frame's end besides its fields and its checksum: it is the end of the bytes, it is still to come, or
 * nothing.
 */
export type Ending = 'come' | 'to-come' | 'unknown';

/** Unit identifier, PDU, checksum: the binary frame of RTU, and of ASCII once its characters are read. */
const UNIT = 1;
/** Unit identifier and function code. */
const LEAST_BODY = 2;

/**
 * Reads a serial frame. Its checksum is expected where the function's fields say that the frame ends, else at the end of the
 * bytes; if it holds there, a length is wrong and not the checksum. `ending` says what else is known about the frame's end.
 */
export function readSerial(reading: Reading, bytes: Uint8Array, checksum: Checksum, ending: Ending): void {
  const { length } = bytes;
  const { width } = checksum;
  const bodyEnd = length - width;
  if (bodyEnd >= LEAST_BODY) {
    readUnit(reading, bytes);
    const pdu = readPdu(reading, bytes, UNIT, bodyEnd);
    const waiting = ending === 'to-come' && reading.open && !holds(checksum, bytes, bodyEnd);
    if (pdu === bodyEnd && !waiting) {
      closePdu(reading, bytes, UNIT, pdu, pdu, true);
      readChecksum(reading, bytes, pdu, checksum);
      checkUnit(reading, reading.spans[0] as Span);
      return;
    }
    const extra =
      pdu < bodyEnd && (holds(checksum, bytes, pdu) || (ending !== 'come' && !holds(checksum, bytes, bodyEnd)));
    const early = ending === 'unknown' || (ending === 'to-come' && pdu < bodyEnd);
    if (extra || ending === 'come' || (early && holds(checksum, bytes, bodyEnd))) {
      const end = extra ? pdu : bodyEnd;
      closePdu(reading, bytes, UNIT, pdu, end, true);
      readChecksum(reading, bytes, end, checksum);
      if (extra) readAfter(reading, bytes, end + width);
      checkUnit(reading, reading.spans[0] as Span);
      return;
    }
    // No checksum anywhere: the bytes end before the frame does, and all of them may belong to its PDU.
    reading.reset();
  }
  readShort(reading, bytes, checksum);
}

const holds = ({ compute, read }: Checksum, bytes: Uint8Array, at: number) => compute(bytes, 0, at) === read(bytes, at);

function readUnit(reading: Reading, bytes: Uint8Array): void {
  reading.unitId = bytes[0] as number;
  reading.spans.push(new Span('unitId', 'unit', 0, UNIT));
}

function readChecksum(reading: Reading, bytes: Uint8Array, at: number, checksum: Checksum): void {
  const { algorithm, section, width } = checksum;
  const got = checksum.read(bytes, at);
  const expected = checksum.compute(bytes, 0, at);
  const span = new Span('checksum', 'checksum', at, at + width);
  reading.spans.push(span);
  reading.checksum = got;
  if (got === expected) return;
  reading.force('checksum', got);
  reading.report({ code: 'checksum-wrong', severity: 'error', algorithm, got, expected, section }, span);
}

/** Takes the bytes after the frame. */
export function readAfter(reading: Reading, bytes: Uint8Array, from: number): void {
  const span = new Span('after', 'rest', from, bytes.length);
  const extra = bytes.length - from;
  reading.spans.push(span);
  reading.force('after', toHex(bytes, from));
  reading.outcome = { kind: 'extra', bytes: extra };
  reading.report({ code: 'frame-extra', severity: 'error', bytes: extra, section: 'AP 4.1' }, span);
}

const UNFINISHED = new Set<FieldKind>(['registers', 'bits', 'bytes', 'list', 'groups', 'rest']);

/** Says that at least `missing` bytes are still to come. */
export function reportShort(reading: Reading, missing: number, end: number): void {
  reading.outcome = { kind: 'short', missing };
  const span = reading.spans[reading.spans.length - 1] ?? new Span('frame', 'rest', 0, end);
  // The last field is not complete yet, so that nothing is reported about it.
  if (UNFINISHED.has(span.kind)) reading.problems = reading.problems.filter((problem) => problem.span !== span);
  reading.report({ code: 'frame-short', severity: 'error', missing, section: 'AP 4.1' }, span);
}

function readShort(reading: Reading, bytes: Uint8Array, checksum: Checksum): void {
  const { length } = bytes;
  const { width } = checksum;
  if (length === 0) {
    for (const name of ['unitId', 'functionCode', 'checksum']) reading.force(name, '');
    reportShort(reading, LEAST_BODY + width, length);
    return;
  }
  readUnit(reading, bytes);
  const pdu = readPdu(reading, bytes, UNIT, length);
  const end = Math.min(pdu, length);
  closePdu(reading, bytes, UNIT, pdu, end, false);
  reading.force('checksum', toHex(bytes, end, length));
  if (end < length) reading.spans.push(new Span('checksum', 'checksum', end, length));
  checkUnit(reading, reading.spans[0] as Span);
  reportShort(reading, pdu + width - length, length);
}
