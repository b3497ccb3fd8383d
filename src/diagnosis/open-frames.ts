import { crc16, describeFunction, framesAt, type Layout, MOST_RTU } from '../modbus/index.ts';
import type { Candidate } from './candidate.ts';

/** Unit identifier, function code and CRC (SL 2.5.1). */
const LEAST = 4;

const opens = ({ fields, then }: Layout): boolean =>
  fields.some(({ open }) => open) ||
  (then !== undefined && [...Object.values(then.cases), then.otherwise].some((layout) => opens(layout)));

/** By function code, whether its frames may have a length that no byte tells. */
const MAY_BE_OPEN = Array.from({ length: 256 }, (_, code) => opens(describeFunction(code, 'response').response));

/**
 * Adds frames whose length no byte tells. They are accepted only if one or several of them fill a whole gap: anywhere else
 * too many of them would end by chance.
 */
export function fillGaps(bytes: Uint8Array, frames: readonly Candidate[]): Candidate[] {
  const filled: Candidate[] = [];
  let at = 0;
  for (const frame of frames) {
    if (at < frame.from) fill(bytes, at, frame.from, filled);
    filled.push(frame);
    at = frame.to;
  }
  fill(bytes, at, bytes.length, filled);
  return filled;
}

/** Adds the open frames end to end from `from` to `to`; none if bytes are left over. */
function fill(bytes: Uint8Array, from: number, to: number, filled: Candidate[]): void {
  const before = filled.length;
  for (let at = from; at < to; ) {
    const frame = firstOpen(bytes, at, to);
    if (frame === undefined) {
      filled.length = before;
      return;
    }
    filled.push(frame);
    at = frame.to;
  }
}

/** The shortest open frame at `from` whose CRC holds. */
function firstOpen(bytes: Uint8Array, from: number, end: number): Candidate | undefined {
  if (from + LEAST > end || !MAY_BE_OPEN[bytes[from + 1] as number]) return undefined;
  const last = Math.min(end, from + MOST_RTU);
  let crc = crc16(bytes, from, from + LEAST - 1);
  for (let to = from + LEAST; to <= last; to++) {
    crc = crc16(bytes, to - 1, to, crc);
    if (crc !== 0) continue;
    const legal = framesAt(bytes, from, to, 'rtu').filter((frame) => frame.legal && frame.to === to);
    if (legal.length > 0) return { transport: 'rtu', from, to, directions: legal.map(({ direction }) => direction) };
  }
  return undefined;
}
