import { MOST_ASCII } from './ascii.ts';
import type { CrcWindows } from './crc-windows.ts';
import { crc16 } from './crc16.ts';
import { decodeFrame } from './decode-frame.ts';
import { hexDigit } from './hex.ts';
import { PduWalk, REQUEST, RESPONSE, type Side } from './pdu-walk.ts';
import type { Direction, Transport } from './reading.ts';
import { MOST_RTU } from './rtu.ts';
import { CRC } from './serial.ts';
import { MBAP } from './tcp.ts';

/** A frame that bytes hold, proved by its checksum, or on TCP by its MBAP, and by its fields ending just where it does. */
export interface FrameAt {
  readonly transport: Exclude<Transport, 'pdu'>;
  readonly direction: Direction;
  readonly from: number;
  readonly to: number;
  /** No field breaks a rule of its own, and none is left with bytes that make no whole item. */
  readonly legal: boolean;
  /** Something in it is reserved or against the specification's advice. */
  readonly warned: boolean;
  /** No byte tells where the PDU ends: the frame was taken to end with the bytes, or where such frames usually do. */
  readonly open: boolean;
}

const NONE: readonly FrameAt[] = Object.freeze([]);
const COLON = 0x3a;
const CR = 0x0d;
const LF = 0x0a;

const SIDES = [REQUEST, RESPONSE] as const;
const walk = new PduWalk();

/**
 * Every frame that may begin at `at` and ends at or before `end`: of each transport, or of one, in each direction, the
 * request first. A function whose length no byte tells is a candidate to `end` itself, and to the length it usually has.
 * Two candidates may end at different places: a reply that ends in 00 is a request too where the 00 before it closes one.
 * Never throws, and looks at no more bytes than the longest frame has, so that asking at every place is linear.
 */
export function framesAt(
  bytes: Uint8Array,
  at: number,
  end = bytes.length,
  transport?: FrameAt['transport'],
): readonly FrameAt[] {
  let found = NONE;
  if (transport === undefined || transport === 'ascii') found = addAscii(found, bytes, at, end);
  if (transport === undefined || transport === 'rtu') found = addRtu(found, bytes, at, end);
  if (transport === undefined || transport === 'tcp') found = addTcp(found, bytes, at, end);
  return found;
}

const add = (found: readonly FrameAt[], frame: FrameAt): readonly FrameAt[] =>
  found.length === 0 ? [frame] : [...found, frame];

/** Unit identifier, function code and CRC. */
const LEAST_RTU = 4;

function addRtu(before: readonly FrameAt[], bytes: Uint8Array, at: number, end: number): readonly FrameAt[] {
  if (at + LEAST_RTU > end) return before;
  let found = before;
  for (const side of SIDES) {
    let pdu = rtuPduEnd(side, bytes, at, end, 0, undefined);
    while (pdu > 0) {
      found = add(found, rtu(bytes, side, at, pdu));
      pdu = rtuPduEnd(side, bytes, at, end, pdu, undefined);
    }
  }
  return found;
}

/**
 * The first place from `from` on, before `bytes.length`, where `framesAt` may have an answer for this transport; for RTU
 * and TCP where it has one, but for a TCP frame whose fields do not fit. `bytes.length` where there is none. `windows`, of
 * the same bytes, make it faster over many places.
 */
export function nextPlace(
  bytes: Uint8Array,
  from: number,
  transport: FrameAt['transport'],
  windows?: CrcWindows,
): number {
  const end = bytes.length;
  switch (transport) {
    case 'rtu':
      return nextRtu(bytes, from, end, windows);
    case 'ascii': {
      const colon = bytes.indexOf(COLON, from);
      return colon < 0 ? end : colon;
    }
    case 'tcp':
      for (let at = from; at + MBAP < end; at++) if (isMbap(bytes, at)) return at;
      return end;
  }
}

function nextRtu(bytes: Uint8Array, from: number, end: number, windows: CrcWindows | undefined): number {
  // Up to here the longest frame ends before the bytes do, so that those that end with the bytes need not be thought of.
  const far = end - MOST_RTU;
  let at = from;
  for (; at < far; at++) {
    const functionCode = bytes[at + 1] as number;
    if (REQUEST.open[functionCode] === 0 && rtuPduEnd(REQUEST, bytes, at, end, 0, windows) > 0) return at;
    if (RESPONSE.open[functionCode] === 0 && rtuPduEnd(RESPONSE, bytes, at, end, 0, windows) > 0) return at;
  }
  for (; at + LEAST_RTU <= end; at++) {
    if (rtuPduEnd(REQUEST, bytes, at, end, 0, windows) > 0 || rtuPduEnd(RESPONSE, bytes, at, end, 0, windows) > 0)
      return at;
  }
  return end;
}

/**
 * Where the RTU frame of this direction ends that begins at `at`, by its fields and its CRC; 0 where none does. This is
 * `framesAt` without a judgement of what the fields hold, at a fraction of its time. Where two ends are possible, it is
 * the first.
 */
export function rtuEndAt(bytes: Uint8Array, at: number, direction: Direction, windows?: CrcWindows): number {
  const end = bytes.length;
  if (at + LEAST_RTU > end) return 0;
  const pdu = rtuPduEnd(direction === 'request' ? REQUEST : RESPONSE, bytes, at, end, 0, windows);
  return pdu > 0 ? pdu + CRC.width : 0;
}

/**
 * Where the PDU of an RTU frame that begins at `at` ends, by its fields and its CRC, beyond `past`; 0 where no such frame
 * is. Only an open PDU has more than one end.
 */
function rtuPduEnd(
  side: Side,
  bytes: Uint8Array,
  at: number,
  end: number,
  past: number,
  windows: CrcWindows | undefined,
): number {
  const near = end <= at + MOST_RTU;
  const functionCode = bytes[at + 1] as number;
  if (!near && side.open[functionCode] === 1) return 0;
  const last = (near ? end : at + MOST_RTU) - CRC.width;
  const width = side.widths[functionCode] as number;
  const pdu = width > 0 ? at + 1 + width : walk.end(side, bytes, at + 1, last);
  if (width === 0 && walk.usual > past && walk.usual < pdu && crcHolds(bytes, at, walk.usual, windows))
    return walk.usual;
  if (pdu > last || pdu <= past || (width === 0 && walk.open && !near)) return 0;
  return crcHolds(bytes, at, pdu, windows) ? pdu : 0;
}

const crcHolds = (bytes: Uint8Array, at: number, pdu: number, windows: CrcWindows | undefined): boolean =>
  windows === undefined
    ? crc16(bytes, at, pdu) === ((bytes[pdu] as number) | ((bytes[pdu + 1] as number) << 8))
    : windows.closes(at, pdu + CRC.width);

function rtu(bytes: Uint8Array, side: Side, at: number, pdu: number): FrameAt {
  walk.judge(side, bytes, at + 1, pdu);
  const { legal, warned, open } = walk;
  return { transport: 'rtu', direction: side.direction, from: at, to: pdu + CRC.width, legal, warned, open };
}

/** Whether the protocol identifier is 0 and the length below 256 (TG 3.1.3). */
const isMbap = (bytes: Uint8Array, at: number) => bytes[at + 2] === 0 && bytes[at + 3] === 0 && bytes[at + 4] === 0;

function addTcp(before: readonly FrameAt[], bytes: Uint8Array, at: number, end: number): readonly FrameAt[] {
  if (at + MBAP >= end || !isMbap(bytes, at)) return before;
  const to = at + 6 + (bytes[at + 5] as number);
  if (to > end || to <= at + MBAP) return before;
  let found = before;
  for (const side of SIDES) {
    if (walk.end(side, bytes, at + MBAP, to) !== to) continue;
    walk.judge(side, bytes, at + MBAP, to);
    const { legal, warned, open } = walk;
    found = add(found, { transport: 'tcp', direction: side.direction, from: at, to, legal, warned, open });
  }
  return found;
}

function addAscii(before: readonly FrameAt[], bytes: Uint8Array, at: number, end: number): readonly FrameAt[] {
  if (bytes[at] !== COLON) return before;
  const last = Math.min(end, at + MOST_ASCII);
  let digits = at + 1;
  while (digits < last && hexDigit(bytes[digits] as number) >= 0) digits++;
  // CR and the delimiter, which function 08 can change, or a lone LF.
  const to = digits + (bytes[digits] === CR ? 2 : 1);
  if (to > last || (bytes[digits] !== CR && bytes[digits] !== LF)) return before;
  let found = before;
  for (const { direction } of SIDES) {
    const { outcome, forced, problems, open } = decodeFrame(bytes.subarray(at, to), { transport: 'ascii', direction });
    if (outcome.kind !== 'whole' || forced['checksum'] !== undefined) continue;
    // Closed by its end, a frame is whole whatever its fields say; here they have to agree.
    if (problems.some(({ code }) => code === 'pdu-short' || code === 'pdu-rest')) continue;
    const legal = !problems.some(({ severity }) => severity === 'error');
    const warned = problems.some(({ severity }) => severity === 'warning');
    found = add(found, { transport: 'ascii', direction, from: at, to, legal, warned, open });
  }
  return found;
}
