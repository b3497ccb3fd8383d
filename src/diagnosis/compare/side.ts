import {
  crc16,
  type DecodeContext,
  decodeFrame,
  fromHex,
  lrc,
  partsOf,
  type Reading,
  Span,
} from '../../modbus/index.ts';

/** One of the two frames: its bytes, and what they say. Places are indices into `bytes`. */
export interface Side {
  readonly bytes: Uint8Array;
  /** The frame is `bytes[start, end)`; the bytes around it do not belong to it. */
  readonly start: number;
  readonly end: number;
  readonly reading: Reading;
  /** They cover every byte once, in order; those around the frame are `before` and `after`. Groups are replaced by their fields. */
  readonly spans: readonly Span[];
  /** For each byte, the index of its span. */
  readonly spanOf: Int32Array;
}

/** Reads `bytes[start, end)` as a frame; the bytes around it are `before` and `after` it. */
export function readSide(bytes: Uint8Array, context: DecodeContext, start = 0, end = bytes.length): Side {
  const frame = bytes.subarray(start, end);
  const reading = decodeFrame(frame, context);
  const spans = reading.spans
    .flatMap((span) => innerSpans(reading, frame, span))
    .map(({ name, kind, from, to }) => new Span(name, kind, from + start, to + start));
  if (start > 0) spans.unshift(new Span('before', 'rest', 0, start));
  if (end < bytes.length) spans.push(new Span('after', 'rest', end, bytes.length));
  const spanOf = new Int32Array(bytes.length);
  spans.forEach((span, index) => {
    spanOf.fill(index, span.from, span.to);
  });
  return { bytes, start, end, reading, spans, spanOf };
}

/** The fields inside a list of groups if they cover it; else the span itself. */
function innerSpans(reading: Reading, frame: Uint8Array, span: Span): readonly Span[] {
  if (span.kind !== 'groups') return [span];
  const inner = partsOf(reading, frame, span).flatMap(({ parts }) => parts);
  const covered = inner.reduce((sum, { from, to }) => sum + to - from, 0);
  return covered === span.to - span.from ? inner : [span];
}

/** The bytes that `[from, to)` stands for: in ASCII those that the digits make; `undefined` if they are not digits. */
export function binaryOf({ bytes, reading }: Side, from: number, to: number): Uint8Array | undefined {
  const slice = bytes.subarray(from, to);
  if (reading.transport !== 'ascii') return slice;
  // Blanks are not allowed in a frame, but `fromHex` skips them.
  return slice.some((character) => character <= 0x20) ? undefined : fromHex(String.fromCharCode(...slice));
}

/** A checksum as found, and as calculated from the bytes of the frame before it. */
export interface CheckValue {
  readonly algorithm: 'crc' | 'lrc';
  readonly got: number;
  readonly expected: number;
}

/** The checksum in `[from, to)`, whatever these bytes are in the frame's reading. */
export function checkAt(side: Side, from: number, to: number): CheckValue | undefined {
  const { transport } = side.reading;
  const check = binaryOf(side, from, to);
  if (transport === 'ascii') {
    const body = binaryOf(side, side.start + 1, from);
    if (body === undefined || check?.length !== 1) return undefined;
    return { algorithm: 'lrc', got: check[0] as number, expected: lrc(body) };
  }
  if (transport !== 'rtu' || check?.length !== 2) return undefined;
  const [low, high] = check as unknown as readonly [number, number];
  return { algorithm: 'crc', got: low | (high << 8), expected: crc16(side.bytes, side.start, from) };
}

/** A field of one side by its name. */
export const spanNamed = ({ spans }: Side, name: string): Span | undefined => spans.find((span) => span.name === name);
