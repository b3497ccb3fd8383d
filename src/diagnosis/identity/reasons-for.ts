import {
  againstRequest,
  codeRange,
  type Direction,
  isAgainstRequest,
  type ProblemCode,
  type Reading,
  type Transport,
} from '../../modbus/index.ts';
import type { Reason } from './reason.ts';

const BEFORE_LENGTH = 6;
const COLON = 0x3a;
/** Colon, CR and LF: what stands around the digits of an ASCII frame. */
const AROUND: ReadonlySet<number> = new Set([COLON, 0x0d, 0x0a]);
/** A unit identifier and a function code at least (TG 3.1.3). */
const LEAST_LENGTH = 2;

/** What is known besides the bytes. */
export interface IdentifyContext {
  /** The request they may answer, of the same transport. */
  readonly request?: Uint8Array | undefined;
  readonly direction?: Direction | undefined;
  readonly transport?: Transport | undefined;
}

/** What in the bytes speaks for this reading, and against it. */
export function evidence(reading: Reading, bytes: Uint8Array): Reason[] {
  return [...envelope(reading, bytes), ...functionOf(reading), ...fields(reading)];
}

function envelope(reading: Reading, bytes: Uint8Array): Reason[] {
  switch (reading.transport) {
    case 'rtu':
      return checksum(reading);
    case 'ascii':
      return [...characters(bytes), ...checksum(reading)];
    case 'tcp':
      return [mbap(reading, bytes)];
    case 'pdu':
      return [{ code: 'bare-pdu', fits: isFlawless(reading) }];
  }
}

function checksum({ transport, checksum: got, forced }: Reading): Reason[] {
  if (got === undefined) return [];
  const algorithm = transport === 'rtu' ? 'crc' : 'lrc';
  return [{ code: forced['checksum'] === undefined ? 'checksum-holds' : 'checksum-wrong', algorithm }];
}

function mbap({ protocolId, length = 0, outcome }: Reading, bytes: Uint8Array): Reason {
  if (protocolId !== 0) return { code: 'no-mbap' };
  const there = Math.max(0, bytes.length - BEFORE_LENGTH);
  // What follows a frame that ends by its length field may be the next frame.
  const end = outcome.kind === 'extra' ? there - outcome.bytes : there;
  return length === end && length >= LEAST_LENGTH
    ? { code: 'mbap-fits', length }
    : { code: 'mbap-length-differs', got: length, expected: there };
}

function characters(bytes: Uint8Array): Reason[] {
  let digits = 0;
  let others = 0;
  for (const byte of bytes) {
    if (isDigit(byte)) digits++;
    else if (!AROUND.has(byte)) others++;
  }
  const start: Reason = { code: bytes.includes(COLON) ? 'colon' : 'no-colon' };
  return [start, others === 0 && digits > 0 ? { code: 'hex-digits' } : { code: 'other-characters', others }];
}

const isDigit = (character: number): boolean =>
  (character >= 0x30 && character <= 0x39) || ((character & 0xdf) >= 0x41 && (character & 0xdf) <= 0x46);

function functionOf({ functionCode, direction, problems }: Reading): Reason[] {
  if (functionCode === undefined) return [];
  if (problems.some(({ code }) => code === 'function-serial-only')) {
    return [{ code: 'function-serial-only', functionCode }];
  }
  const known = codeRange(direction === 'response' ? functionCode & 0x7f : functionCode) === 'public';
  return [{ code: known ? 'known-function' : 'unknown-function', functionCode }];
}

/** Problems that other reasons cover. */
const APART: ReadonlySet<ProblemCode> = new Set<ProblemCode>([
  'checksum-wrong',
  'frame-short',
  'frame-extra',
  'mbap-length-wrong',
  'mbap-length-out-of-range',
  'protocol-id-not-zero',
  'ascii-start',
  'ascii-end',
  'ascii-character',
  'ascii-lower-case',
]);
/** The fields do not end where the frame ends. */
const MISFITS: ReadonlySet<ProblemCode> = new Set<ProblemCode>([
  'pdu-short',
  'pdu-rest',
  'pdu-too-long',
  'count-wrong',
]);

function fields(reading: Reading): Reason[] {
  const { outcome, problems, checksum: end, forced } = reading;
  const reasons: Reason[] = [];
  const misfit = problems.some(({ code }) => MISFITS.has(code));
  if (misfit) reasons.push({ code: 'fields-do-not-fit' });
  // A frame that lacks only its line end has all its fields.
  else if (outcome.kind === 'whole' || (end !== undefined && forced['checksum'] === undefined)) {
    reasons.push(...fitting(reading));
  }
  if (outcome.kind === 'short') reasons.push({ code: 'length-short', missing: outcome.missing });
  if (outcome.kind === 'extra') reasons.push({ code: 'length-extra', bytes: outcome.bytes });
  let errors = 0;
  let warnings = 0;
  for (const { code, severity } of problems) {
    if (APART.has(code) || MISFITS.has(code) || againstRequest.has(code)) continue;
    if (severity === 'error') errors++;
    else if (severity === 'warning') warnings++;
  }
  if (errors > 0) reasons.push({ code: 'rules-broken', errors });
  if (warnings > 0) reasons.push({ code: 'against-advice', warnings });
  return reasons;
}

function fitting({ open, spans, count, fields: values }: Reading): Reason[] {
  // A field that takes all bytes fits any number of them.
  if (open) return [];
  if (!spans.some(({ kind }) => kind === 'count')) return [{ code: 'fields-fit' }];
  const list = spans.find(({ kind }) => kind === 'registers');
  const registers = list && values[list.name];
  return [{ code: 'byte-count-fits', got: count, registers: Array.isArray(registers) ? registers.length : undefined }];
}

/** The fewest bytes that show a truncated echo of the request. */
const TELLING = 4;

/** What in the context speaks for this reading, or against it. */
export function evidenceOfContext(reading: Reading, bytes: Uint8Array, context: IdentifyContext): Reason[] {
  const reasons: Reason[] = [];
  const { request } = context;
  if (request !== undefined) {
    if (reading.direction === 'request') {
      if (begins(bytes, request)) reasons.push({ code: 'repeats-request' });
    } else if (reading.functionCode !== undefined) {
      reasons.push({ code: isAgainstRequest(reading) ? 'answers-another' : 'answers-request' });
    }
  }
  if (context.direction === reading.direction) reasons.push({ code: 'direction-given' });
  if (context.transport === reading.transport) reasons.push({ code: 'transport-given' });
  return reasons;
}

const begins = (bytes: Uint8Array, request: Uint8Array): boolean =>
  bytes.length >= TELLING && bytes.length <= request.length && bytes.every((byte, i) => byte === request[i]);

/** Whether the bytes are exactly one frame that breaks no rule by itself. */
export const isFlawless = ({ outcome, problems }: Reading): boolean =>
  outcome.kind === 'whole' && !problems.some(({ code, severity }) => severity === 'error' && !againstRequest.has(code));
