import { crc16 } from '../../../modbus/index.ts';
import { type Case, type WrongCrc, wrongCrcs } from '../../case.ts';
import { partsOf } from '../../checksum-match.ts';
import type { FindingData, Offer } from '../../finding.ts';
import { join, swapWord, withMbap } from '../../frames.ts';
import type { Hypothesis } from '../../hypothesis.ts';
import { aboutCrc, explainedBits } from './explained.ts';

type Over = Pick<FindingData['crc-span'], 'over' | 'first' | 'last'>;

/** The CRC was calculated over too many bytes, or too few. */
export const span: Hypothesis = {
  codes: ['crc-span'],
  offer: (item) =>
    wrongCrcs(item).flatMap((wrong) => {
      const offerOf = ({ tried, over, sure, cost }: Found): Offer => {
        const bits = explainedBits(wrong, tried, cost);
        return { code: 'crc-span', ...aboutCrc(item, wrong), ...over, bits, guess: !sure };
      };
      return [...mistaken(item, wrong), ...cutShort(item, wrong), ...anywhere(item, wrong)].map(offerOf);
    }),
};

/** A span that has this CRC, one of `tried`. It is not `sure` if it does not end where a field ends. */
interface Found {
  readonly over: Over;
  readonly tried: number;
  readonly sure: boolean;
  /** How rare the mistake is, in bits, if it is rarer than others. */
  readonly cost?: number;
}

const isEither = ({ got }: WrongCrc) => {
  const swapped = swapWord(got);
  return (value: number) => value === got || value === swapped;
};

const part = (first: number, last: number): Over => ({ over: 'part', first, last });

/** The spans of the usual mistakes: a few bytes left out, room for the CRC included, another header in front. */
function mistaken({ bytes }: Case, wrong: WrongCrc): Found[] {
  const { end, expected } = wrong;
  const body = bytes.subarray(0, end);
  const whole = (over: Over['over'], value: number) => ({ over: { over, first: 0, last: end }, value });
  const spans: readonly { readonly over: Over; readonly value: number }[] = [
    ...partsOf(end)
      .filter(({ from, to }) => to - from < end)
      .map(({ from, to }) => ({ over: part(from, to), value: crc16(bytes, from, to) })),
    // The buffer already had room for the CRC: zeros, ones, or the right CRC.
    whole('with-checksum', crc16(join(body, [0, 0]))),
    whole('with-checksum', crc16(join(body, [0]))),
    whole('with-checksum', crc16(join(body, [0xff, 0xff]))),
    whole('with-checksum', crc16(join(body, [expected & 0xff]))),
    whole('with-length', crc16(join([end], body))),
    whole('with-length', crc16(join([end + 2], body))),
    whole('with-mbap', crc16(withMbap(body, 0))),
    whole('with-mbap', crc16(withMbap(body, 1))),
  ];
  const ends = fieldEnds(wrong);
  const fits = isEither(wrong);
  return spans
    .filter(({ value }) => fits(value))
    .map(({ over }) => ({ over, tried: 2 * spans.length, sure: over.over !== 'part' || ends.has(over.last) }));
}

/** Where the fields of the body end, and so where a loop over them may have stopped. */
const fieldEnds = ({ reading, end }: WrongCrc): ReadonlySet<number> =>
  new Set([1, end, ...reading.spans.map(({ to }) => 1 + to)]);

/** Only the first bytes, as if the length of another frame had been used. */
function cutShort({ bytes }: Case, wrong: WrongCrc): Found[] {
  const ends = fieldEnds(wrong);
  const fits = isEither(wrong);
  const found: Found[] = [];
  let register = INITIAL;
  for (let to = 1; to < wrong.end; to++) {
    register = crc16(bytes, to - 1, to, register);
    if (fits(register)) found.push({ over: part(0, to), tried: 2 * wrong.end, sure: ends.has(to) });
  }
  return found;
}

const INITIAL = 0xffff;
/** Longer frames have so many spans that one of them has any CRC by chance (SL 2.5.1.2: 256 bytes at most). */
const MOST_BYTES = 256;

/** How rare it is, in bits, that a CRC is calculated over bytes that begin or end inside a field. */
const INSIDE_FIELD = 10;

/** Any other span, low byte first as sent. Those between ends of fields are few; of the others a long frame has too many. */
function anywhere({ bytes }: Case, wrong: WrongCrc): Found[] {
  const { end } = wrong;
  if (end > MOST_BYTES) return [];
  const ends = fieldEnds(wrong);
  const found: Found[] = [];
  for (let from = 1; from < end; from++) {
    let register = INITIAL;
    for (let to = from + 1; to <= end; to++) {
      register = crc16(bytes, to - 1, to, register);
      if (register !== wrong.got) continue;
      const over = part(from, to);
      if (ends.has(from) && ends.has(to)) found.push({ over, tried: ends.size ** 2, sure: true });
      else found.push({ over, tried: (end * (end + 1)) / 2, sure: false, cost: INSIDE_FIELD });
    }
  }
  return found;
}
