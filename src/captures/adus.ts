import { crc16, decodeFrame, framesAt, MBAP, MOST_RTU } from '../modbus/index.ts';

/** How a stream carries Modbus. */
export type Carriage = 'tcp' | 'rtu' | 'ascii';

const COLON = 0x3a;
const LF = 0x0a;
const LEAST_LENGTH = 2;
/** Unit identifier and the longest PDU (TG 3.1.3). */
const MOST_LENGTH = 254;
const LENGTH_END = 6;
const LEAST_RTU = 4;
/** The most characters of an ASCII frame (SL 2.5.2.1). */
const MOST_ASCII = 513;

const lengthAt = (bytes: Uint8Array, at: number) => ((bytes[at + 4] as number) << 8) | (bytes[at + 5] as number);

/** Whether an MBAP may stand at `at`: protocol 0, and a length that a PDU can have (TG 3.1.3). */
export const isMbapAt = (bytes: Uint8Array, at: number, end: number): boolean =>
  at + LENGTH_END <= end &&
  bytes[at + 2] === 0 &&
  bytes[at + 3] === 0 &&
  lengthAt(bytes, at) >= LEAST_LENGTH &&
  lengthAt(bytes, at) <= MOST_LENGTH;

/** Where the ADU at `at` ends by its MBAP. */
export const aduEnd = (bytes: Uint8Array, at: number): number => at + LENGTH_END + lengthAt(bytes, at);

/** Whether the bytes are whole ADUs one after another: evidence enough on a port that is not Modbus' own. */
export function areAdus(bytes: Uint8Array, from: number, end: number): boolean {
  let at = from;
  while (at + MBAP < end && isMbapAt(bytes, at, end)) at = aduEnd(bytes, at);
  return at === end && from < end;
}

/** What the first bytes of a stream show that it carries; `undefined` if it may be anything. */
export function carriageOf(bytes: Uint8Array, from: number, end: number): Carriage | undefined {
  if (areAdus(bytes, from, end)) return 'tcp';
  const length = end - from;
  const mayBeAdu = length <= MBAP && couldBegin(bytes, from, end);
  if (length >= LEAST_RTU && length <= MOST_RTU && crc16(bytes, from, end) === 0 && !mayBeAdu) return 'rtu';
  if (bytes[from] === COLON && bytes[end - 1] === LF) {
    const ascii = bytes.subarray(from, end);
    const isFrame = directions.some(
      (direction) => decodeFrame(ascii, { transport: 'ascii', direction }).outcome.kind === 'whole',
    );
    if (isFrame) return 'ascii';
  }
  return undefined;
}

const directions = ['request', 'response'] as const;

/** Whether bytes are a frame that breaks no rule, in one direction at least. */
const isLegal = (transport: Carriage, bytes: Uint8Array, from: number, to: number): boolean =>
  directions.some((direction) => {
    const { outcome, problems } = decodeFrame(bytes.subarray(from, to), { transport, direction });
    return outcome.kind === 'whole' && problems.every(({ severity }) => severity !== 'error');
  });

/** Where the frame at `at` ends, or why that is not known. */
export const MORE = -1;
export const NO_FRAME = -2;

/** Where the frame at `at` ends: `MORE` if its end is still to come, `NO_FRAME` if no frame begins there. */
export function frameEnd(carriage: Carriage, bytes: Uint8Array, at: number, end: number): number {
  if (carriage === 'tcp') {
    if (at + LENGTH_END > end) return couldBegin(bytes, at, end) ? MORE : NO_FRAME;
    if (!isMbapAt(bytes, at, end)) return NO_FRAME;
    const to = aduEnd(bytes, at);
    return to <= end ? to : MORE;
  }
  if (carriage === 'ascii') {
    if (bytes[at] !== COLON) return NO_FRAME;
    const to = bytes.indexOf(LF, at);
    if (to >= 0 && to < end) return to + 1;
    return end - at < MOST_ASCII ? MORE : NO_FRAME;
  }
  // Serial frames come as they were heard, mostly one a segment.
  if (end - at <= MOST_RTU && end - at >= LEAST_RTU && crc16(bytes, at, end) === 0) return end;
  const first = framesAt(bytes, at, end, 'rtu').find(({ open }) => !open);
  if (first !== undefined) return first.to;
  return end - at < MOST_RTU ? MORE : NO_FRAME;
}

/**
 * The same where no frame before it tells that one begins there: it must be legal, and on TCP either `isSegment` says that nothing else
 * came with it, or another MBAP follows.
 */
export function sureEnd(carriage: Carriage, bytes: Uint8Array, at: number, end: number, isSegment: boolean): number {
  const to = frameEnd(carriage, bytes, at, end);
  if (to < 0) return to;
  if (!isLegal(carriage, bytes, at, to)) return NO_FRAME;
  if (carriage !== 'tcp' || isSegment) return to;
  if (to + LENGTH_END <= end) return isMbapAt(bytes, to, end) ? to : NO_FRAME;
  return couldBegin(bytes, to, end) ? MORE : NO_FRAME;
}

/** Whether the few bytes that are there may begin an MBAP. */
const couldBegin = (bytes: Uint8Array, at: number, end: number): boolean =>
  (at + 2 >= end || bytes[at + 2] === 0) &&
  (at + 3 >= end || bytes[at + 3] === 0) &&
  (at + 4 >= end || bytes[at + 4] === 0);

/** The first place behind `at` where a frame may begin again; `end` if there is none. */
export function nextFrame(carriage: Carriage, bytes: Uint8Array, at: number, end: number): number {
  for (let place = at + 1; place < end; place++) {
    if (
      carriage === 'ascii'
        ? bytes[place] === COLON
        : carriage === 'tcp'
          ? mayBegin(bytes, place, end)
          : frameEnd('rtu', bytes, place, end) >= 0
    ) {
      return place;
    }
  }
  return end;
}

/** An MBAP whose ADU ends with the bytes, or before another one, or goes on behind them; or what may be the beginning of one. */
function mayBegin(bytes: Uint8Array, at: number, end: number): boolean {
  if (at + LENGTH_END > end) return couldBegin(bytes, at, end);
  if (!isMbapAt(bytes, at, end)) return false;
  const to = aduEnd(bytes, at);
  return to >= end || frameEnd('tcp', bytes, to, end) !== NO_FRAME;
}
