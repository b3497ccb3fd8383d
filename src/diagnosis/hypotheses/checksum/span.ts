import { crc16 } from '../../../modbus/index.ts';
import { type Case, type WrongCrc, wrongCrcs } from '../../case.ts';
import { partsOf } from '../../checksum-match.ts';
import type { FindingData } from '../../finding.ts';
import { join, swapWord, withMbap } from '../../frames.ts';
import type { Hypothesis } from '../../hypothesis.ts';
import { aboutCrc, explainedBits } from './explained.ts';

type Over = Pick<FindingData['crc-span'], 'over' | 'first' | 'last'>;

/** The CRC was taken over too much or too little. */
export const span: Hypothesis = {
  codes: ['crc-span'],
  offer: (item) =>
    wrongCrcs(item).flatMap((wrong) => {
      const spans = spansOf(item, wrong);
      const other = swapWord(wrong.got);
      const bits = explainedBits(wrong, 2 * spans.length);
      return spans
        .filter(({ value }) => value === wrong.got || value === other)
        .map(({ value: _, ...over }) => ({ code: 'crc-span' as const, ...aboutCrc(item, wrong), ...over, bits }));
    }),
};

function spansOf({ bytes }: Case, { end, expected }: WrongCrc): (Over & { value: number })[] {
  const body = bytes.subarray(0, end);
  const part = (first: number, last: number) => ({
    over: 'part' as const,
    first,
    last,
    value: crc16(bytes, first, last),
  });
  const whole = (over: Over['over'], value: number) => ({ over, first: 0, last: end, value });
  return [
    ...partsOf(end)
      .filter(({ from, to }) => to - from < end)
      .map(({ from, to }) => part(from, to)),
    // Room for the CRC was in the buffer already: zeros, ones, or the right one.
    whole('with-checksum', crc16(join(body, [0, 0]))),
    whole('with-checksum', crc16(join(body, [0]))),
    whole('with-checksum', crc16(join(body, [0xff, 0xff]))),
    whole('with-checksum', crc16(join(body, [expected & 0xff]))),
    whole('with-length', crc16(join([end], body))),
    whole('with-length', crc16(join([end + 2], body))),
    whole('with-mbap', crc16(withMbap(body, 0))),
    whole('with-mbap', crc16(withMbap(body, 1))),
  ];
}
