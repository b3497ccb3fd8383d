import { wrongCrcs } from '../../case.ts';
import type { Hypothesis } from '../../hypothesis.ts';
import { aboutCrc } from './explained.ts';

/** How rare it is, in bits, that a CRC is wrong and unexplained. */
const COST = 5;

/** A frame in every other way, with a CRC that nothing known explains. */
export const wrong: Hypothesis = {
  codes: ['crc-wrong'],
  offer: (item) =>
    wrongCrcs(item).map((found) => ({ code: 'crc-wrong', ...aboutCrc(item, found), bits: found.bits - COST })),
};
