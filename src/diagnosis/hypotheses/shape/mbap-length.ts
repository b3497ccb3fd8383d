import { MOST_TCP } from '../../../modbus/index.ts';
import { wholesOf } from '../../case.ts';
import { replaced, swapWord, word } from '../../frames.ts';
import type { Hypothesis } from '../../hypothesis.ts';

const AT = 4;
const BEFORE_UNIT = 6;
/** The bits that a right length would give, and how rare a wrong one is. */
const COST = 10;

/** The fields end with the bytes, but the MBAP length is different. */
export const mbapLength: Hypothesis = {
  codes: ['mbap-length'],
  offer: ({ bytes, transport, request, cut }) => {
    const { length } = bytes;
    if (cut || (transport !== undefined && transport !== 'tcp') || length < BEFORE_UNIT + 2 || length > MOST_TCP)
      return [];
    const got = word(bytes, AT);
    const expected = length - BEFORE_UNIT;
    if (got === expected) return [];
    const repaired = replaced(bytes, AT, 0, expected);
    const swapped = swapWord(got) === expected;
    return wholesOf(repaired, 'tcp', request)
      .filter(({ reading }) => !reading.open)
      .map(({ bits }) => ({
        code: 'mbap-length',
        from: AT,
        to: BEFORE_UNIT,
        got,
        expected,
        swapped,
        repaired: [repaired],
        bits: bits - COST + (swapped ? 8 : 0),
      }));
  },
};
