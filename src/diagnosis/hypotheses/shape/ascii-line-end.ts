import { lrc } from '../../../modbus/index.ts';
import { asciiText, textBits } from '../../ascii-text.ts';
import { LRC_BITS } from '../../evidence.ts';
import type { Hypothesis } from '../../hypothesis.ts';
import { carriedBy } from '../../request.ts';

const CR_LF = '0D0A';

/** A whole ASCII frame that does not end with CR LF. */
export const asciiLineEnd: Hypothesis = {
  codes: ['ascii-line-end'],
  offer: ({ bytes, transport, cut }) => {
    if (cut || (transport !== undefined && transport !== 'ascii')) return [];
    const found = asciiText(bytes);
    if (!found?.colon || found.end === CR_LF || found.binary.length < 3) return [];
    const { binary, end: got } = found;
    const end = binary.length - 1;
    if (lrc(binary, 0, end) !== binary[end]) return [];
    const from = 1 + 2 * binary.length;
    const repaired = [carriedBy('ascii', binary.subarray(0, end))];
    return [
      {
        code: 'ascii-line-end',
        from: Math.min(from, bytes.length - 1),
        to: bytes.length,
        got,
        repaired,
        bits: textBits(found) + LRC_BITS - 2,
      },
    ];
  },
};
