import { crc16, MOST_RTU } from '../../../modbus/index.ts';
import { wholesOf } from '../../case.ts';
import { tries } from '../../evidence.ts';
import type { Offer } from '../../finding.ts';
import { hasErrors, join } from '../../frames.ts';
import type { Hypothesis } from '../../hypothesis.ts';

const COST = 5;

/** The frame's end stands in front of its beginning: bytes left in a buffer moved everything. */
export const rotated: Hypothesis = {
  codes: ['rotated'],
  offer: ({ bytes, bodies, request, cut }) => {
    const { length } = bytes;
    if (cut || bodies.length === 0 || length > MOST_RTU) return [];
    const offers: Offer[] = [];
    for (let by = 1; by < length; by++) {
      const turned = join(bytes.subarray(by), bytes.subarray(0, by));
      // A frame with its CRC behind it has a CRC of zero.
      if (crc16(turned) !== 0) continue;
      const whole = wholesOf(turned, 'rtu', request).find(({ reading }) => !hasErrors(reading) && !reading.open);
      if (whole === undefined) continue;
      offers.push({
        code: 'rotated',
        from: 0,
        to: by,
        by,
        repaired: [turned],
        bits: whole.bits - tries(length) - COST,
      });
    }
    return offers;
  },
};
