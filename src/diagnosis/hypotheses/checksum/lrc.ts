import { crc16, lrc } from '../../../modbus/index.ts';
import { endsThere, LRC_BITS } from '../../evidence.ts';
import { withCrc } from '../../frames.ts';
import type { Hypothesis } from '../../hypothesis.ts';

const COST = 3;

/** The checksum of ASCII frames stands behind the binary bytes of an RTU frame. */
export const lrcForCrc: Hypothesis = {
  codes: ['lrc-instead-of-crc'],
  offer: ({ bytes, bodies, cut }) => {
    const end = bytes.length - 1;
    const got = bytes[end];
    if (cut || end < 2 || got === undefined || got !== lrc(bytes, 0, end)) return [];
    return bodies
      .filter(({ end: own, reading }) => own === end && !reading.open)
      .map(({ reading, bits }) => ({
        code: 'lrc-instead-of-crc',
        from: end,
        to: end + 1,
        got,
        expected: crc16(bytes, 0, end),
        repaired: [withCrc(bytes.subarray(0, end))],
        bits: bits + endsThere(reading) + LRC_BITS - COST,
      }));
  },
};
