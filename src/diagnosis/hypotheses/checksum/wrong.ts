import { wrongCrcs } from '../../case.ts';
import type { Hypothesis } from '../../hypothesis.ts';
import { aboutCrc } from './explained.ts';

/** How rare it is, in bits, that a CRC is wrong and nothing known explains it. */
const COST = 5;

/** A frame in every other way, and a CRC that is of nothing known. */
export const wrong: Hypothesis = {
  codes: ['crc-wrong'],
  offer: (item) =>
    wrongCrcs(item).map((found) => ({ code: 'crc-wrong', ...aboutCrc(item, found), bits: found.bits - COST })),
};
