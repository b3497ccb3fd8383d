import { type Direction, decodeFrame, type FrameAt, framesAt, MOST_ASCII, type Transport } from '../../modbus/index.ts';
import { splitStream } from '../split-stream.ts';
import { isFlawless } from './reasons-for.ts';

/** Bytes `[from, to)` that were read together, such as a line of a log, and what the text says of them. */
export interface ConversationChunk {
  readonly from: number;
  readonly to: number;
  readonly direction?: Direction | undefined;
  readonly transport?: Transport | undefined;
}

/** Bytes of one or more chunks: a whole frame, perhaps with stray bytes around it, or the bytes left between frames. */
export interface Piece {
  readonly from: number;
  readonly to: number;
  /** What the text says of its direction, and of its transport. */
  readonly hint: Direction | undefined;
  readonly given: Transport | undefined;
  readonly frame: PieceFrame | undefined;
}

/** A frame's bytes, `[from, to)`. */
export interface Place {
  readonly transport: Transport;
  readonly from: number;
  readonly to: number;
}

export interface PieceFrame extends Place {
  /** The directions in which it may be a frame. */
  readonly directions: readonly Direction[];
}

const DIRECTIONS: readonly Direction[] = ['request', 'response'];
const COLON = 0x3a;

/**
 * The frames of these chunks and what is left between them, in order. A chunk that is one frame stays one piece.
 * Adjacent chunks that are not frames are read as one stream: they may be parts of one frame, or hold several frames each.
 */
export function piecesOf(bytes: Uint8Array, chunks: readonly ConversationChunk[]): Piece[] {
  const tidy = inOrder(chunks, bytes.length);
  const wholes = tidy.map((chunk) => wholeFrames(bytes, chunk));
  const usual = usualTransport(wholes);
  const pieces: Piece[] = [];
  let run: ConversationChunk[] = [];
  const flush = () => {
    for (const piece of run.length > 0 ? split(bytes, run, usual) : []) pieces.push(piece);
    run = [];
  };
  tidy.forEach((chunk, i) => {
    const found = wholes[i] ?? [];
    const frame = found.find(({ transport }) => transport === usual) ?? found[0];
    if (frame !== undefined) {
      flush();
      pieces.push({ from: chunk.from, to: chunk.to, hint: chunk.direction, given: chunk.transport, frame });
      return;
    }
    const last = run[run.length - 1];
    if (last !== undefined && !belongTogether(last, chunk)) flush();
    run.push(chunk);
  });
  flush();
  return pieces;
}

/** The chunks without what lies outside the bytes, or in a chunk before. */
function inOrder(chunks: readonly ConversationChunk[], length: number): ConversationChunk[] {
  const tidy: ConversationChunk[] = [];
  let at = 0;
  for (const chunk of chunks) {
    const from = Math.max(at, chunk.from);
    const to = Math.min(length, chunk.to);
    if (!(from < to)) continue;
    tidy.push(from === chunk.from && to === chunk.to ? chunk : { ...chunk, from, to });
    at = to;
  }
  return tidy;
}

/** The frames that the whole chunk may be, one for each transport. */
function wholeFrames(bytes: Uint8Array, { from, to, transport: given }: ConversationChunk): PieceFrame[] {
  if (to - from > MOST_ASCII) return [];
  if (given === 'pdu') return decoded(bytes, from, to, 'pdu');
  const found = framesUpTo(bytes, from, to, given);
  if (found.length === 0) {
    if (bytes[from] === COLON) return decoded(bytes, from, to, 'ascii');
    return given === undefined || given === 'tcp' ? withWrongLength(bytes, from, to) : [];
  }
  const frames: PieceFrame[] = [];
  for (const { transport } of found) {
    if (frames[frames.length - 1]?.transport === transport) continue;
    frames.push({
      transport,
      from,
      to,
      directions: directionsOf(found.filter((frame) => frame.transport === transport)),
    });
  }
  return frames;
}

/** The shortest TCP frame (TG 3.1.3). A serial request for two items from address 0 looks like one, whatever its CRC. */
const SHORTEST_TCP = 8;

/** The frames of one transport, or of all, that end just at `to`. */
const framesUpTo = (bytes: Uint8Array, from: number, to: number, transport: FrameAt['transport'] | undefined) =>
  framesAt(bytes, from, to, transport).filter(
    (frame) =>
      frame.to === to && (frame.transport !== 'tcp' || to - from > SHORTEST_TCP || (frame.legal && !frame.open)),
  );

/** The longest frame on TCP, and what stands in front of its unit identifier (TG 3.1.3). */
const MOST_TCP = 260;
const BEFORE_UNIT = 6;

/** A frame on TCP whose fields end with the bytes, while its length says otherwise. */
function withWrongLength(bytes: Uint8Array, from: number, to: number): PieceFrame[] {
  const size = to - from;
  if (size <= SHORTEST_TCP || size > MOST_TCP || bytes[from + 2] !== 0 || bytes[from + 3] !== 0) return [];
  const mended = bytes.slice(from, to);
  mended[BEFORE_UNIT - 2] = 0;
  mended[BEFORE_UNIT - 1] = size - BEFORE_UNIT;
  const directions = DIRECTIONS.filter((direction) => {
    const reading = decodeFrame(mended, { transport: 'tcp', direction });
    return !reading.open && isFlawless(reading);
  });
  return directions.length > 0 ? [{ transport: 'tcp', from, to, directions }] : [];
}

/** If some break no rule, only those. */
function directionsOf(found: readonly FrameAt[]): readonly Direction[] {
  const legal = found.filter((frame) => frame.legal);
  return (legal.length > 0 ? legal : found).map(({ direction }) => direction);
}

/** A bare PDU; or an ASCII frame without its line end, which logs leave out and `framesAt` does not accept. */
function decoded(bytes: Uint8Array, from: number, to: number, transport: 'pdu' | 'ascii'): PieceFrame[] {
  const directions = DIRECTIONS.filter((direction) => {
    const reading = decodeFrame(bytes.subarray(from, to), { transport, direction });
    if (transport === 'pdu') return isFlawless(reading);
    const { checksum, forced, problems } = reading;
    return checksum !== undefined && !('checksum' in forced) && problems.every(({ code }) => code === 'frame-short');
  });
  return directions.length > 0 ? [{ transport, from, to, directions }] : [];
}

/** The transport in which the most bytes are whole frames: a pasted text has only one. */
function usualTransport(wholes: readonly PieceFrame[][]): Transport | undefined {
  const covered = new Map<Transport, number>();
  for (const frames of wholes) {
    for (const { transport, from, to } of frames) covered.set(transport, (covered.get(transport) ?? 0) + to - from);
  }
  return [...covered].sort(([, a], [, b]) => b - a)[0]?.[0];
}

/** Whether a frame may reach from one chunk into the next. */
const belongTogether = (before: ConversationChunk, after: ConversationChunk): boolean =>
  before.to === after.from &&
  (before.transport === after.transport || before.transport === undefined || after.transport === undefined) &&
  (before.direction === after.direction || before.direction === undefined || after.direction === undefined);

/** Unit identifier, function code, CRC: a line of fewer bytes is not a frame, but several may be parts of a broken one. */
const LEAST = 4;

/** The frames in adjacent chunks, and between them what is left of each chunk. */
function split(bytes: Uint8Array, run: readonly ConversationChunk[], usual: Transport | undefined): Piece[] {
  const start = run[0]?.from ?? 0;
  const found = framesIn(bytes, start, run[run.length - 1]?.to ?? start, run.length > 1);
  // Bytes may look like a frame of another transport by chance, above all without a checksum.
  const frames = found.filter((frame) => (usual ?? frame.transport) === frame.transport);
  const pieces: Piece[] = [];
  let next = 0;
  let at = start;
  /** Where the last piece began, if it is the rest of lines that are all too short for a frame. */
  let short = -1;
  const rest = (to: number, says: Pick<Piece, 'hint' | 'given'>) => {
    if (at >= to) return;
    const isShort = to - at < LEAST;
    const joins = isShort && short >= 0;
    if (joins) pieces.pop();
    const from = joins ? short : at;
    pieces.push({ from, to, ...says, frame: undefined });
    short = isShort ? from : -1;
    at = to;
  };
  for (const { from, to, direction, transport: given } of run) {
    const first = next;
    while ((frames[next]?.from ?? to) < to) next++;
    const here = frames.slice(first, next);
    const [only] = here;
    // Several frames in a line do not all have the line's direction.
    const says = { hint: here.length > 1 ? undefined : direction, given };
    const alone = only !== undefined && here.length === 1 && at <= from && only.to <= to && isMostOf(only, from, to);
    for (const frame of here) {
      if (!alone) rest(frame.from, says);
      const own = alone ? { from, to } : { from: frame.from, to: frame.to };
      pieces.push({ ...own, ...says, frame });
      at = own.to;
      short = -1;
    }
    rest(to, says);
  }
  return pieces;
}

/**
 * The frames in bytes that were read as one stream. In a chunk with several frames only the stream itself tells the
 * directions; for frames in parts, the frames before and after them may tell too.
 */
function framesIn(bytes: Uint8Array, start: number, end: number, inParts: boolean): PieceFrame[] {
  const frames: PieceFrame[] = [];
  for (const segment of splitStream(bytes.subarray(start, end))) {
    if (segment.kind !== 'frame') continue;
    const { transport, direction } = segment;
    const [from, to] = [start + segment.from, start + segment.to];
    const found = framesUpTo(bytes, from, to, transport);
    if (found.length === 0) continue;
    frames.push({ transport, from, to, directions: inParts || !direction ? directionsOf(found) : [direction] });
  }
  return frames;
}

/** Bytes around a frame that are fewer than its own are stray bytes, and not the rest of other frames. */
const isMostOf = (frame: PieceFrame, from: number, to: number) => to - from < 2 * (frame.to - frame.from);
