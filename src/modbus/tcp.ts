import { toHex } from './hex.ts';
import { closePdu, MOST_PDU, readPdu } from './pdu.ts';
import type { Reading } from './reading.ts';
import { readAfter, reportShort } from './serial.ts';
import { Span } from './span.ts';
import { checkUnit } from './unit-rules.ts';

/** Transaction identifier, protocol identifier, length, unit identifier (TG 3.1.3). */
export const MBAP = 7;
/** Most bytes of a TCP frame (TG 3.1.3; AP 4.1). */
export const MOST_TCP = MBAP + MOST_PDU;
/** The bytes before those that the length field counts. */
const BEFORE_LENGTH = 6;
/** The length field counts the unit identifier and the PDU, which has at least a function code. */
const LENGTH = { least: 2, most: 1 + MOST_PDU } as const;

const header = [
  { name: 'transactionId', kind: 'envelope', from: 0, to: 2 },
  { name: 'protocolId', kind: 'envelope', from: 2, to: 4 },
  { name: 'length', kind: 'envelope', from: 4, to: 6 },
  { name: 'unitId', kind: 'unit', from: 6, to: 7 },
] as const;

/**
 * Reads a TCP frame. Two witnesses say where it ends: the MBAP length and the function's own fields. If they disagree and
 * the fields end exactly with the bytes, the MBAP length is wrong.
 */
export function readTcp(reading: Reading, bytes: Uint8Array): void {
  const { length: all } = bytes;
  if (all < MBAP) {
    readHeader(reading, bytes);
    reading.force('functionCode', '');
    const declared = reading.length;
    reportShort(reading, Math.max(MBAP + 1, BEFORE_LENGTH + (declared ?? 0)) - all, all);
    return;
  }
  const declared = BEFORE_LENGTH + (((bytes[4] as number) << 8) | (bytes[5] as number));
  let end = Math.min(declared, all);
  let pdu = readFrame(reading, bytes, end);
  if (declared < all && (reading.open || pdu !== end)) {
    // The length field may be what is wrong: do the fields end with the bytes?
    reading.reset();
    pdu = readFrame(reading, bytes, all);
    if (!reading.open && pdu === all) end = all;
    else if (declared >= MBAP) {
      reading.reset();
      pdu = readFrame(reading, bytes, end);
    } else end = Math.min(pdu, all);
  }
  const complete = !reading.open && pdu === end;
  const waiting = declared > all && !complete;
  closePdu(reading, bytes, MBAP, pdu, end, !waiting);
  finishHeader(reading, end, waiting);
  if (end < all) readAfter(reading, bytes, end);
  checkUnit(reading, reading.spans[3] as Span);
  if (waiting) reportShort(reading, declared - all, all);
}

function readFrame(reading: Reading, bytes: Uint8Array, end: number): number {
  readHeader(reading, bytes);
  return readPdu(reading, bytes, MBAP, Math.max(end, MBAP));
}

function readHeader(reading: Reading, bytes: Uint8Array): void {
  const there = bytes.length;
  for (const { name, kind, from, to } of header) {
    if (there > from) reading.spans.push(new Span(name, kind, from, Math.min(to, there)));
    if (there < to) {
      reading.force(name, toHex(bytes, Math.min(from, there), there));
      continue;
    }
    const value =
      to - from === 1 ? (bytes[from] as number) : ((bytes[from] as number) << 8) | (bytes[from + 1] as number);
    reading[name] = value;
  }
  const protocolId = reading.protocolId;
  if (protocolId !== undefined && protocolId !== 0) {
    reading.force('protocolId', protocolId);
    const code = 'protocol-id-not-zero';
    reading.report({ code, severity: 'error', got: protocolId, section: 'TG 3.1.3' }, reading.spans[1] as Span);
  }
  const length = reading.length;
  // Without a unit identifier and a PDU the encoder would write a length of 0.
  if (length !== undefined && there < MBAP && length !== 0) reading.force('length', length);
}

/** Compares the length field with the frame as it was taken to end. */
function finishHeader(reading: Reading, end: number, waiting: boolean): void {
  const got = reading.length as number;
  const expected = end - BEFORE_LENGTH;
  const span = reading.spans[2] as Span;
  if (got !== expected) reading.force('length', got);
  if (got < LENGTH.least || got > LENGTH.most) {
    reading.report({ code: 'mbap-length-out-of-range', severity: 'error', got, ...LENGTH, section: 'TG 3.1.3' }, span);
  } else if (got !== expected && !waiting) {
    reading.report({ code: 'mbap-length-wrong', severity: 'error', got, expected, section: 'TG 3.1.3' }, span);
  }
}
