import { MOST_ASCII } from './ascii.ts';
import { decodeFrame } from './decode-frame.ts';
import { demandWhole } from './demand.ts';
import { hexDigit } from './hex.ts';
import { JUDGED_ALIKE, PduWalk, REQUEST, RESPONSE, type Side } from './pdu-walk.ts';
import type { Direction, Transport } from './reading.ts';
import { LEAST_RTU, rtuPduEnd } from './rtu-end.ts';
import { CRC } from './serial.ts';
import { MBAP } from './tcp.ts';

/** A frame in some bytes, proved by its checksum, or on TCP by its MBAP, and by fields that end where the frame ends. */
export interface FrameAt {
  readonly transport: Exclude<Transport, 'pdu'>;
  readonly direction: Direction;
  readonly from: number;
  readonly to: number;
  /** No field breaks a rule of its own, and every list has whole items. */
  readonly legal: boolean;
  /** Something in it is reserved or against the specification's advice. */
  readonly warned: boolean;
  /** No byte says where the PDU ends: the frame was assumed to end with the bytes, or to have the usual length. */
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
 * request first. If no byte tells the length of a function, it is tried up to `end`, and with its usual length. Two candidates
 * may end at different places: a reply that ends in 00 is a request too if the 00 before it closes one. Looks at no more bytes
 * than the longest frame has, so that asking at every place is linear. Throws a `RangeError` for a place that is not a whole
 * number from 0; none of it needs to be in the bytes.
 */
export function framesAt(
  bytes: Uint8Array,
  at: number,
  end = bytes.length,
  transport?: FrameAt['transport'],
): readonly FrameAt[] {
  demandPlaces(at, end);
  let found = NONE;
  if (transport === undefined || transport === 'ascii') found = addAscii(found, bytes, at, end);
  if (transport === undefined || transport === 'rtu') found = addRtu(found, bytes, at, end);
  if (transport === undefined || transport === 'tcp') found = addTcp(found, bytes, at, end);
  return found;
}

function demandPlaces(from: number, to: number): void {
  demandWhole('place', from, 0, Number.MAX_SAFE_INTEGER);
  demandWhole('place', to, 0, Number.MAX_SAFE_INTEGER);
}

const add = (found: readonly FrameAt[], frame: FrameAt): readonly FrameAt[] =>
  found.length === 0 ? [frame] : [...found, frame];

function addRtu(before: readonly FrameAt[], bytes: Uint8Array, at: number, end: number): readonly FrameAt[] {
  if (at + LEAST_RTU > end) return before;
  let found = before;
  for (const side of SIDES) {
    let pdu = rtuPduEnd(side, bytes, at, end, 0);
    while (pdu > 0) {
      found = add(found, rtu(bytes, side, at, pdu));
      pdu = rtuPduEnd(side, bytes, at, end, pdu);
    }
  }
  return found;
}

/**
 * The first place from `from` on, before `bytes.length`, where a frame of this transport looks like one: a colon, or an
 * MBAP. `bytes.length` if there is no such place. For RTU, whose frames have no mark, see `RtuScan`.
 */
export function nextPlace(bytes: Uint8Array, from: number, transport: 'ascii' | 'tcp'): number {
  demandPlaces(from, 0);
  if (transport === 'ascii') {
    const colon = bytes.indexOf(COLON, from);
    return colon < 0 ? bytes.length : colon;
  }
  for (let at = from; at + MBAP < bytes.length; at++) if (isMbap(bytes, at)) return at;
  return bytes.length;
}

function rtu(bytes: Uint8Array, side: Side, at: number, pdu: number): FrameAt {
  walk.judge(side, bytes, at + 1, pdu);
  const { legal, warned, open } = walk;
  return { transport: 'rtu', direction: side.direction, from: at, to: pdu + CRC.width, legal, warned, open };
}

/**
 * How the rules of its function judge the RTU frame in `bytes[from, to)`, whose fields are known to end there and whose CRC to hold:
 * `legal` breaks none, `warned` has something reserved or against advice.
 */
export function judgeRtu(
  bytes: Uint8Array,
  from: number,
  to: number,
  direction: Direction,
): 'legal' | 'warned' | 'illegal' {
  walk.judge(direction === 'request' ? REQUEST : RESPONSE, bytes, from + 1, to - CRC.width);
  return walk.legal ? (walk.warned ? 'warned' : 'legal') : 'illegal';
}

/** Whether RTU frames of this function are judged alike as requests and as replies, so that judging them tells no direction. */
export const areJudgedAlike = (functionCode: number): boolean => JUDGED_ALIKE[functionCode] === 1;

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
    // CR LF makes a frame whole whatever its fields say; here they must agree.
    if (problems.some(({ code }) => code === 'pdu-short' || code === 'pdu-rest')) continue;
    const legal = !problems.some(({ severity }) => severity === 'error');
    const warned = problems.some(({ severity }) => severity === 'warning');
    found = add(found, { transport: 'ascii', direction, from: at, to, legal, warned, open });
  }
  return found;
}
