import { exceptionCodes, lrc } from '../../../modbus/index.ts';
import { wrongCrcs } from '../../case.ts';
import { CRC_BITS } from '../../evidence.ts';
import type { FindingData } from '../../finding.ts';
import { word } from '../../frames.ts';
import type { Hypothesis } from '../../hypothesis.ts';
import { aboutCrc, explainedBits } from './explained.ts';

type As = FindingData['crc-is-something-else']['as'];

/** What the two bytes are, and how many pairs of bytes would be that. */
interface Else {
  readonly as: As;
  readonly pairs: number;
  /** Data may end like this too, so it proves little if no byte tells the end of the data. */
  readonly common?: true;
  is(first: number, second: number, body: Uint8Array): boolean;
}

const reasons = new Set<number>(exceptionCodes.map(({ code }) => code));

const ELSES: readonly Else[] = [
  {
    as: 'exception',
    pairs: reasons.size,
    is: (first, second, body) => first === ((body[1] as number) | 0x80) && reasons.has(second),
  },
  {
    as: 'line-end',
    pairs: 2,
    is: (first, second) => (first === 0x0d && second === 0x0a) || (first === 0x0a && second === 0x0d),
  },
  { as: 'ones', pairs: 1, common: true, is: (first, second) => first === 0xff && second === 0xff },
  {
    as: 'lrc',
    pairs: 3,
    is: (first, second, body) => {
      const sum = lrc(body);
      return (first === sum && (second === 0 || second === sum)) || (first === 0 && second === sum);
    },
  },
  {
    as: 'length',
    pairs: 2,
    common: true,
    is: (first, second, body) => first === 0 && (second === body.length || second === body.length + 2),
  },
  {
    as: 'last-data',
    pairs: 1,
    common: true,
    is: (first, second, body) => body.length >= 6 && word(body, body.length - 2) === ((first << 8) | second),
  },
];
/** The bits that such a pair of bytes loses at the end of data of any length. */
const ENDS_OF_DATA = CRC_BITS - 2;
const TRIED = ELSES.reduce((sum, { pairs }) => sum + pairs, 0);

/** The two bytes are another part of the frame, or the end of a frame of another protocol. */
export const somethingElse: Hypothesis = {
  codes: ['crc-is-something-else'],
  offer: (item) =>
    wrongCrcs(item).flatMap((wrong) => {
      const { bytes } = item;
      const body = bytes.subarray(0, wrong.end);
      const found = ELSES.find(({ is }) => is(bytes[wrong.end] as number, bytes[wrong.end + 1] as number, body));
      if (found === undefined) return [];
      const bits = explainedBits(wrong, TRIED) - (found.common && wrong.reading.open ? ENDS_OF_DATA : 0);
      return [{ code: 'crc-is-something-else', ...aboutCrc(item, wrong), as: found.as, bits }];
    }),
};
