import { wrongCrcs } from '../../case.ts';
import { swapWord } from '../../frames.ts';
import type { Hypothesis } from '../../hypothesis.ts';
import { aboutCrc, explainedBits } from './explained.ts';

/** The CRC's high byte was sent first: its value was written as a number. */
export const byteOrder: Hypothesis = {
  codes: ['crc-byte-order'],
  offer: (item) =>
    wrongCrcs(item)
      .filter(({ got, expected }) => got === swapWord(expected))
      .map((wrong) => ({ code: 'crc-byte-order', ...aboutCrc(item, wrong), bits: explainedBits(wrong, 1) })),
};
