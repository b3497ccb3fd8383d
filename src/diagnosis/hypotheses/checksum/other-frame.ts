import { crc16, exceptionCodes } from '../../../modbus/index.ts';
import { type Case, type WrongCrc, wrongCrcs } from '../../case.ts';
import type { FindingData } from '../../finding.ts';
import type { Hypothesis } from '../../hypothesis.ts';
import { isOwnReply } from '../../request.ts';
import { aboutCrc, explainedBits } from './explained.ts';

type Of = FindingData['crc-of-other-frame']['of'];

/** The replies to these repeat the first six bytes of the request. */
const SHORT_REPLY = 6;

/** The CRC belongs to another frame of the same conversation. */
export const otherFrame: Hypothesis = {
  codes: ['crc-of-other-frame'],
  offer: (item) =>
    wrongCrcs(item).flatMap((wrong) => {
      const frames = framesNear(item, wrong);
      return frames
        .filter(({ value }) => value === wrong.got)
        .slice(0, 1)
        .map(({ of }) => ({
          code: 'crc-of-other-frame' as const,
          ...aboutCrc(item, wrong),
          of,
          bits: explainedBits(wrong, frames.length),
        }));
    }),
};

function framesNear(
  { bytes, request }: Case,
  { unitId, direction, reading, end }: WrongCrc,
): { of: Of; value: number }[] {
  if (direction === 'response') {
    // Where the reply repeats the request, its checksum is right, and something else is wrong.
    const distinct = request?.reading.transport === 'rtu' && !isOwnReply(request);
    const asked = distinct ? request.reading.checksum : undefined;
    return asked === undefined ? [] : [{ of: 'request', value: asked }];
  }
  const functionCode = reading.functionCode ?? 0;
  const refusals = exceptionCodes.map(({ code }) => ({
    of: 'exception' as const,
    value: crc16(Uint8Array.of(unitId, functionCode | 0x80, code)),
  }));
  return end > SHORT_REPLY ? [...refusals, { of: 'reply', value: crc16(bytes, 0, SHORT_REPLY) }] : refusals;
}
