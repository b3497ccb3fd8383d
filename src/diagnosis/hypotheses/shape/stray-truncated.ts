import { crc16, MOST_TCP, sameBytes } from '../../../modbus/index.ts';
import { bodyAt } from '../../case.ts';
import { endsThere, tries } from '../../evidence.ts';
import type { Offer } from '../../finding.ts';
import { DIRECTIONS, withCrc } from '../../frames.ts';
import type { Hypothesis } from '../../hypothesis.ts';

const MOST_LEADING = 8;
const COST = 6;
/** The evidence of a right first byte of the CRC, in bits. */
const HALF_CRC = 8;

/** Bytes in front pushed the frame's end out of the buffer. */
export const strayTruncated: Hypothesis = {
  codes: ['stray-leading+truncated'],
  offer: ({ bytes, bodies, request, cut }) => {
    const { length } = bytes;
    if (cut || bodies.length === 0 || length > MOST_TCP) return [];
    const offers: Offer[] = [];
    for (let leading = 1; leading <= Math.min(MOST_LEADING, length - 3); leading++) {
      for (const direction of request ? (['response'] as const) : DIRECTIONS) {
        const { reading, end, bits } = bodyAt(bytes, leading, direction, request);
        const missing = end + 2 - length;
        if (missing < 1 || reading.open) continue;
        const whole = missing <= 2;
        const half = missing === 1 && bytes[end] === (crc16(bytes, leading, end) & 0xff);
        // Without the first byte of the CRC only the request shows that a frame begins here.
        if (!half && (request === undefined || missing === 1)) continue;
        const repaired = whole ? [withCrc(bytes.subarray(leading, end))] : [];
        // If the missing bytes stand in front, nothing is missing: the frame is rotated.
        const isTurned = missing === leading && repaired.some((frame) => isTail(bytes.subarray(0, leading), frame));
        if (isTurned) continue;
        offers.push({
          code: 'stray-leading+truncated',
          from: 0,
          to: length,
          leading,
          missing,
          repaired,
          bits: bits + (half ? HALF_CRC + endsThere(reading) : 0) - tries(2 * leading) - COST,
        });
      }
    }
    return offers;
  },
};

const isTail = (tail: Uint8Array, frame: Uint8Array) => sameBytes(tail, frame.subarray(frame.length - tail.length));
