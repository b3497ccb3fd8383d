import { crc16, type Direction, decodeFrame, lrc } from '../../../modbus/index.ts';
import { asciiText, textBits } from '../../ascii-text.ts';
import { bodyAt, type Case } from '../../case.ts';
import { endsThere, likeness } from '../../evidence.ts';
import type { Offer } from '../../finding.ts';
import { DIRECTIONS, isWhole, withCrc, word } from '../../frames.ts';
import type { Hypothesis } from '../../hypothesis.ts';
import { requestAs } from '../../request.ts';

const COST = 2;
const HALF_CRC = 8;
/** A protocol identifier of zero, and a length that is possible. */
const HEADER = 7;
const COLON = 0x3a;
const BEFORE_UNIT = 6;

/** The bytes stop before the frame does. */
export const truncated: Hypothesis = {
  codes: ['truncated'],
  offer: (item) => (item.cut ? [] : [...serial(item), ...tcp(item), ...ascii(item), ...pdu(item)]),
};

const missingFrom = (has: number, missing: number, bits: number, repaired: readonly Uint8Array[] = []): Offer => ({
  code: 'truncated',
  from: 0,
  to: has,
  has,
  missing,
  repaired,
  bits,
});

function serial({ bytes, bodies }: Case): Offer[] {
  const { length } = bytes;
  return bodies.flatMap(({ reading, end, bits }) => {
    const missing = end + 2 - length;
    // If exactly the CRC is missing, another finding says so.
    if (missing < 1 || missing === 2 || reading.open) return [];
    if (missing > 1) return [missingFrom(length, missing, bits - COST)];
    const half = bytes[end] === (crc16(bytes, 0, end) & 0xff);
    const repaired = half ? [withCrc(bytes.subarray(0, end))] : [];
    return [missingFrom(length, missing, bits + endsThere(reading) + (half ? HALF_CRC : -HALF_CRC) - COST, repaired)];
  });
}

function tcp({ bytes, transport, request }: Case): Offer[] {
  const { length } = bytes;
  const given = transport === 'tcp';
  if ((!given && transport !== undefined) || bytes[2] !== 0 || bytes[3] !== 0 || bytes[4] !== 0) return [];
  return (request ? (['response'] as const) : DIRECTIONS).flatMap((direction) => {
    const asked = requestAs(request, 'tcp', bytes);
    const reading = decodeFrame(bytes, { transport: 'tcp', direction, request: asked });
    if (reading.outcome.kind !== 'short' || !fits(bytes, direction)) return [];
    const bits = HEADER + likeness(reading, reading.unitId, direction === 'response' ? request : undefined) - COST;
    return [missingFrom(length, reading.outcome.missing, bits + (given ? 4 : 0))];
  });
}

/** Whether the fields stay within the MBAP length, and are not complete. */
function fits(bytes: Uint8Array, direction: Direction): boolean {
  if (bytes.length <= BEFORE_UNIT + 1) return true;
  const { reading, end } = bodyAt(bytes, BEFORE_UNIT, direction, undefined);
  return reading.open || (end > bytes.length && end <= BEFORE_UNIT + word(bytes, BEFORE_UNIT - 2));
}

function ascii({ bytes, transport }: Case): Offer[] {
  if ((transport !== undefined && transport !== 'ascii') || bytes[0] !== COLON) return [];
  // A frame that has its LRC lacks only the line end.
  const complete = asciiText(bytes);
  if (complete && lrc(complete.binary) === 0) return [];
  const found = complete ?? asciiText(bytes.subarray(0, -1));
  const readings = DIRECTIONS.map((direction) => decodeFrame(bytes, { transport: 'ascii', direction }));
  return readings.flatMap((reading) => {
    if (reading.outcome.kind !== 'short' || isWhole(reading)) return [];
    return [
      missingFrom(
        bytes.length,
        reading.outcome.missing,
        (found ? textBits(found) : 3) + likeness(reading, reading.unitId, undefined) - COST,
      ),
    ];
  });
}

function pdu({ bytes, transport }: Case): Offer[] {
  if (transport !== 'pdu') return [];
  return DIRECTIONS.flatMap((direction) => {
    const reading = decodeFrame(bytes, { transport: 'pdu', direction });
    return reading.outcome.kind === 'short'
      ? [missingFrom(bytes.length, reading.outcome.missing, likeness(reading, undefined, undefined) - COST)]
      : [];
  });
}
