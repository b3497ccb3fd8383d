import { crc16, type Transport } from '../../../modbus/index.ts';
import { type Case, wholesOf } from '../../case.ts';
import { CRC_BITS } from '../../evidence.ts';
import type { Offer } from '../../finding.ts';
import { hasErrors, join } from '../../frames.ts';
import type { Hypothesis } from '../../hypothesis.ts';
import { bodyOf, carriedBy } from '../../request.ts';

const MBAP = 7;
const BEFORE_UNIT = 6;

/** A frame of one transport on a line of another. */
export const transports: Hypothesis = {
  codes: ['mbap-on-serial', 'rtu-on-tcp', 'rtu-on-ascii', 'crc-on-tcp', 'hex-of-ascii-frame'],
  offer: (item) => [...elsewhere(item), ...crcBehindMbap(item)],
};

type Code = 'mbap-on-serial' | 'rtu-on-tcp' | 'rtu-on-ascii' | 'hex-of-ascii-frame';

/** The finding for a frame of one transport where another was expected. */
const NAMES: Readonly<Partial<Record<Transport, Partial<Record<Transport, Code>>>>> = {
  rtu: { tcp: 'mbap-on-serial', ascii: 'hex-of-ascii-frame' },
  ascii: { tcp: 'mbap-on-serial', rtu: 'rtu-on-ascii' },
  tcp: { rtu: 'rtu-on-tcp', ascii: 'hex-of-ascii-frame' },
};

function elsewhere({ bytes, transport, request, cut }: Case): Offer[] {
  const others = Object.entries((transport && NAMES[transport]) ?? {}) as [Transport, Code][];
  if (transport === undefined || cut) return [];
  return others.flatMap(([other, code]): Offer[] => {
    const whole = wholesOf(bytes, other, request).find(({ reading }) => !hasErrors(reading));
    const body = whole && bodyOf(whole.reading, bytes);
    if (!body) return [];
    const { transactionId = 0 } = whole.reading;
    const asked = request?.reading.transactionId ?? 0;
    const place = { from: 0, to: bytes.length, repaired: [carriedBy(transport, body, asked)], bits: whole.bits };
    switch (code) {
      case 'mbap-on-serial':
        return [{ code, ...place, to: MBAP, transactionId }];
      case 'hex-of-ascii-frame':
        return [{ code, ...place, text: String.fromCharCode(...bytes), inMbap: false }];
      default:
        return [{ code, ...place }];
    }
  });
}

/** An MBAP header in front, but a CRC at the end. */
function crcBehindMbap({ bytes, transport, request, cut }: Case): Offer[] {
  const { length } = bytes;
  const end = length - 2;
  if (cut || (transport !== undefined && transport !== 'tcp') || end < MBAP + 1 || bytes[2] !== 0 || bytes[3] !== 0)
    return [];
  const got = (bytes[end] as number) | ((bytes[end + 1] as number) << 8);
  if (got !== crc16(bytes, BEFORE_UNIT, end) && got !== crc16(bytes, 0, end)) return [];
  const frame = join(bytes.subarray(0, 4), [0, end - BEFORE_UNIT], bytes.subarray(BEFORE_UNIT, end));
  return wholesOf(frame, 'tcp', request)
    .filter(({ reading }) => !hasErrors(reading))
    .map(({ bits }) => ({ code: 'crc-on-tcp', from: end, to: length, repaired: [frame], bits: bits + CRC_BITS - 8 }));
}
