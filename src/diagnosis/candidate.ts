import { CrcWindows, type Direction, type FrameAt, framesAt, nextPlace, rtuEndAt } from '../modbus/index.ts';

/** Bytes that may be a frame: its checksum holds where its fields end. */
export interface Candidate {
  readonly transport: FrameAt['transport'];
  readonly from: number;
  readonly to: number;
  /** The directions in which it may be one. */
  readonly directions: readonly Direction[];
}

const REQUEST: readonly Direction[] = ['request'];
const RESPONSE: readonly Direction[] = ['response'];
const EITHER: readonly Direction[] = ['request', 'response'];

/**
 * What may be frames of this transport, in the order of their beginnings. Inside of those that adjoin another nothing is
 * looked for.
 */
export function candidates(bytes: Uint8Array, transport: FrameAt['transport']): Candidate[] {
  const found: Candidate[] = [];
  const windows = transport === 'rtu' ? new CrcWindows(bytes) : undefined;
  let chained = 0;
  let at = 0;
  for (;;) {
    at = nextPlace(bytes, at, transport, windows);
    if (at >= bytes.length) return found;
    const before = found.length;
    if (windows) addRtu(found, bytes, at, windows);
    else addOther(found, bytes, at, transport);
    const to = found.length === before + 1 ? (found[before] as Candidate).to : 0;
    if (to > 0 && (at === chained || (windows ? begins(bytes, to, windows) : false))) {
      chained = to;
      at = to;
    } else at++;
  }
}

const begins = (bytes: Uint8Array, at: number, windows: CrcWindows) =>
  rtuEndAt(bytes, at, 'request', windows) > 0 || rtuEndAt(bytes, at, 'response', windows) > 0;

function addRtu(found: Candidate[], bytes: Uint8Array, from: number, windows: CrcWindows): void {
  const transport = 'rtu';
  const asked = rtuEndAt(bytes, from, 'request', windows);
  const answered = rtuEndAt(bytes, from, 'response', windows);
  if (asked > 0) found.push({ transport, from, to: asked, directions: asked === answered ? EITHER : REQUEST });
  if (answered > 0 && answered !== asked) found.push({ transport, from, to: answered, directions: RESPONSE });
}

function addOther(found: Candidate[], bytes: Uint8Array, from: number, transport: FrameAt['transport']): void {
  // One end for both directions: that of the MBAP's length, or CR LF.
  const frames = framesAt(bytes, from, bytes.length, transport);
  const first = frames[0];
  if (first === undefined) return;
  const directions = frames[1] === undefined ? (first.direction === 'request' ? REQUEST : RESPONSE) : EITHER;
  found.push({ transport, from, to: first.to, directions });
}

/** The judgement of what a candidate's fields hold, for each of its directions. */
export const judged = (bytes: Uint8Array, { transport, from, to, directions }: Candidate): readonly FrameAt[] =>
  framesAt(bytes, from, to, transport).filter((frame) => frame.to === to && directions.includes(frame.direction));
