import { crc16 } from '../../../modbus/index.ts';
import { type WrongCrc, wrongCrcs } from '../../case.ts';
import { breaksRule, CRC_BITS, endsThere } from '../../evidence.ts';
import { withCrc } from '../../frames.ts';
import type { Hypothesis } from '../../hypothesis.ts';
import { aboutCrc, explainedBits } from './explained.ts';

const COST = 1;
/** If no byte tells the end of the data, or a field breaks a rule, two zeros there are hardly rarer than any other data. */
const ZEROS_OF_DATA = 2;

/** There is no CRC: the bytes end where it belongs, or zeros keep its place. */
export const missing: Hypothesis = {
  codes: ['crc-missing'],
  offer: (item) => {
    const { bytes, bodies, cut } = item;
    const absent = bodies.filter(({ end, reading }) => end === bytes.length && end > 1 && !reading.open && !cut);
    const zero = wrongCrcs(item).filter(({ got }) => got === 0);
    return [
      ...absent.map(({ end, reading, bits }) => ({
        code: 'crc-missing' as const,
        from: 0,
        to: end,
        repaired: [withCrc(bytes)],
        zero: false,
        expected: crc16(bytes),
        bits: bits + endsThere(reading) - COST,
      })),
      ...zero.map((wrong) => {
        const { got: _, ...place } = aboutCrc(item, wrong);
        return { code: 'crc-missing' as const, ...place, zero: true, bits: bitsOf(wrong) };
      }),
    ];
  },
};

const bitsOf = (wrong: WrongCrc): number =>
  explainedBits(wrong, 2) - (wrong.reading.open || breaksRule(wrong.reading) ? CRC_BITS - ZEROS_OF_DATA : 0);
