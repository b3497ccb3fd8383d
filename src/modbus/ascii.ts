import { hexDigit, toHex } from './hex.ts';
import type { Reading } from './reading.ts';
import { LRC, readSerial, reportShort } from './serial.ts';
import { Span } from './span.ts';

/** Most characters of an ASCII frame, from `:` to CR LF (SL 2.5.2.1). */
export const MOST_ASCII = 513;

const COLON = 0x3a;
const CR = 0x0d;
const LF = 0x0a;
const SECTION = 'SL 2.5.2.1';

/** Where the parts of an ASCII frame stand: `[0, body)` start, `[body, end)` characters, `[end, after)` CR LF. */
interface Parts {
  readonly body: number;
  readonly end: number;
  readonly after: number;
}

/**
 * Reads an ASCII frame: `:`, two upper-case hexadecimal digits a byte, CR LF (SL 2.5.2.1). Spans and counts are in
 * characters. What cannot be read as digits is skipped, reported, and kept verbatim as the forced `characters`.
 */
export function readAscii(reading: Reading, bytes: Uint8Array): void {
  const parts = split(bytes);
  const { binary, at } = readDigits(bytes, parts);
  readSerial(reading, binary, LRC, isTerminated(bytes, parts) ? 'come' : 'to-come');
  toCharacters(reading, parts, at);
  const inner = reading.forced['after'] !== undefined;
  addEnvelope(reading, bytes, parts);
  reportStart(reading, bytes, parts);
  const irregular = reportCharacters(reading, bytes, parts) || inner;
  reportEnd(reading, bytes, parts);
  forceCharacters(reading, bytes, parts, irregular);
  setOutcome(reading, bytes, parts, at);
}

function split(bytes: Uint8Array): Parts {
  const colon = bytes.indexOf(COLON);
  let body = colon + 1;
  // Without a colon the frame begins at the first digit.
  if (colon < 0) while (body < bytes.length && hexDigit(bytes[body] as number) < 0 && !isEnd(bytes, body)) body++;
  let end = body;
  while (end < bytes.length && !isEnd(bytes, end)) end++;
  // CR and the delimiter after it, which is LF if sub-function 03 of function 08 has not changed it (AP 6.8.1).
  const after = bytes[end] === CR ? Math.min(end + 2, bytes.length) : Math.min(end + 1, bytes.length);
  return { body, end, after };
}

/** Whether the frame's end has come: CR and the delimiter, or a lone LF. */
const isTerminated = (bytes: Uint8Array, { end, after }: Parts) =>
  after > end && !(after === end + 1 && bytes[end] === CR);

const isEnd = (bytes: Uint8Array, at: number) => bytes[at] === CR || bytes[at] === LF;

/** The bytes that the digits stand for, and the place of each byte's first character, then the end of the last. */
function readDigits(bytes: Uint8Array, { body, end }: Parts): { binary: Uint8Array; at: number[] } {
  const binary: number[] = [];
  const at: number[] = [];
  let high = -1;
  let start = body;
  for (let i = body; i < end; i++) {
    const digit = hexDigit(bytes[i] as number);
    if (digit < 0) continue;
    if (high < 0) {
      high = digit;
      start = i;
    } else {
      binary.push(16 * high + digit);
      at.push(start);
      high = -1;
    }
  }
  if (at.length > 0) at[0] = body;
  at.push(end);
  return { binary: Uint8Array.from(binary), at };
}

/** Turns the spans and problems of the binary frame into those of its characters. */
function toCharacters(reading: Reading, { body, end }: Parts, at: readonly number[]): void {
  const place = (span: Span) =>
    new Span(
      span.name,
      span.kind,
      at[Math.min(span.from, at.length - 1)] as number,
      at[Math.min(span.to, at.length - 1)] as number,
    );
  const { spans } = reading;
  const moved = new Map<Span, Span>();
  for (let i = 0; i < spans.length; i++) {
    const span = spans[i] as Span;
    const there = place(span);
    moved.set(span, there);
    spans[i] = there;
  }
  if (spans.length === 0 && end > body) spans.push(new Span('characters', 'rest', body, end));
  reading.problems = reading.problems
    .filter(({ code }) => code !== 'frame-short' && code !== 'frame-extra')
    .map((problem) => ({ ...problem, span: moved.get(problem.span) ?? place(problem.span) }));
}

/** Adds the spans around the digits. */
function addEnvelope({ spans }: Reading, bytes: Uint8Array, { body, end, after }: Parts): void {
  if (body > 0) spans.unshift(new Span('start', 'envelope', 0, body));
  if (after > end) spans.push(new Span('end', 'envelope', end, after));
  if (after < bytes.length) spans.push(new Span('after', 'rest', after, bytes.length));
}

function reportStart(reading: Reading, bytes: Uint8Array, { body }: Parts): void {
  if (body === 1 && bytes[0] === COLON) return;
  reading.force('start', toHex(bytes, 0, body));
  const span = reading.spans[0];
  if (span) reading.report({ code: 'ascii-start', severity: 'error', got: bytes[0], section: SECTION }, span);
}

/** Reports characters that are not upper-case digits; answers whether it found any. */
function reportCharacters(reading: Reading, bytes: Uint8Array, parts: Parts): boolean {
  const { body, end } = parts;
  let digits = 0;
  let wrong = -1;
  let lower = -1;
  for (let i = body; i < end; i++) {
    const character = bytes[i] as number;
    if (hexDigit(character) < 0) wrong = wrong < 0 ? i : wrong;
    else {
      digits++;
      if (character > 0x60 && lower < 0) lower = i;
    }
  }
  const spanAt = (at: number) =>
    reading.spans.find(({ from, to }) => from <= at && at < to) ?? new Span('frame', 'rest', at, at + 1);
  if (wrong >= 0) {
    reading.report(
      { code: 'ascii-character', severity: 'error', got: bytes[wrong] as number, section: SECTION },
      new Span('character', 'rest', wrong, wrong + 1),
    );
  }
  if (lower >= 0) {
    reading.report(
      { code: 'ascii-lower-case', severity: 'warning', got: bytes[lower] as number, section: SECTION },
      spanAt(lower),
    );
  }
  const odd = digits % 2 !== 0;
  // The second digit of a pair may still come if the frame has not ended and has room for it.
  if (odd && (isTerminated(bytes, parts) || reading.outcome.kind !== 'short')) {
    reading.report({ code: 'ascii-odd-digit', severity: 'error', got: digits, section: SECTION }, spanAt(end - 1));
  }
  return wrong >= 0 || lower >= 0 || odd;
}

function reportEnd(reading: Reading, bytes: Uint8Array, { end, after }: Parts): void {
  const got = toHex(bytes, end, after);
  if (got === '0D0A') return;
  reading.force('end', got);
  // A single CR may still be followed by its LF; nothing at all by both.
  if (got === '' || got === '0D') return;
  const severity = got.startsWith('0D') ? 'warning' : 'error';
  reading.report(
    { code: 'ascii-end', severity, got, section: SECTION },
    reading.spans.find(({ name }) => name === 'end') as Span,
  );
}

/** Keeps verbatim what the encoder would not write: irregular characters, and what follows CR LF. */
function forceCharacters(reading: Reading, bytes: Uint8Array, { body, end, after }: Parts, irregular: boolean): void {
  const { after: _inner, ...forced } = reading.forced;
  reading.forced = forced;
  if (irregular) reading.force('characters', toHex(bytes, body, end));
  if (after < bytes.length) reading.force('after', toHex(bytes, after));
}

/** Outcomes count characters: what the binary frame lacks, two a byte, and the CR LF. */
function setOutcome(reading: Reading, bytes: Uint8Array, parts: Parts, at: readonly number[]): void {
  const { body, end, after } = parts;
  const binary = reading.outcome;
  const { length } = bytes;
  const span = (name: string) => reading.spans.find((candidate) => candidate.name === name && candidate.to === length);
  if (after < length || binary.kind === 'extra') {
    const inner = binary.kind === 'extra' ? end - (at[at.length - 1 - binary.bytes] as number) : 0;
    const extra = inner + length - after;
    reading.outcome = { kind: 'extra', bytes: extra };
    const where = span('after') ?? (reading.spans.find(({ name }) => name === 'after') as Span);
    reading.report({ code: 'frame-extra', severity: 'error', bytes: extra, section: SECTION }, where);
    return;
  }
  const terminated = isTerminated(bytes, parts);
  const start = length === 0 ? 1 : 0;
  // A lone digit is half of the next byte.
  const half = bytes.subarray(body, end).filter((character) => hexDigit(character) >= 0).length % 2;
  const digits = binary.kind === 'short' ? 2 * binary.missing - half : 0;
  const missing = start + digits + (terminated ? 0 : 2 - (after - end));
  if (terminated && binary.kind === 'short') {
    // CR LF came too early: nothing more will come.
    reading.outcome = { kind: 'whole' };
    reading.report(
      { code: 'pdu-short', severity: 'error', missing: binary.missing, section: SECTION },
      reading.spans[Math.max(0, reading.spans.length - 2)] as Span,
    );
  } else if (missing > 0) {
    reportShort(reading, missing, length);
  } else {
    reading.outcome = { kind: 'whole' };
  }
}
