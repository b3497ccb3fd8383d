import { decodeFrame } from '../../../modbus/index.ts';
import type { Case } from '../../case.ts';
import { likeness } from '../../evidence.ts';
import type { Offer } from '../../finding.ts';
import { DIRECTIONS, isSound } from '../../frames.ts';
import type { Hypothesis } from '../../hypothesis.ts';
import { bodyOf, carriedBy } from '../../request.ts';

const COST = 4;

/** The checksum or length holds, but some bytes belong to no field. */
export const extraBytes: Hypothesis = {
  codes: ['extra-bytes'],
  offer: (item) => [...behindPdu(item), ...inside(item)],
};

const inside = (item: Case): Offer[] =>
  item.wholes.flatMap(({ reading, bits }): Offer[] => {
    const rest = reading.spans.find(({ name }) => name === 'rest');
    if (rest === undefined || !reading.problems.some(({ code }) => code === 'pdu-rest')) return [];
    const { from, to } = rest;
    const repaired = without(item, reading.transport, reading.direction);
    const bytes = reading.transport === 'ascii' ? (to - from) / 2 : to - from;
    return [
      {
        code: 'extra-bytes',
        from,
        to,
        bytes,
        repaired,
        bits: bits - COST - Math.log2(bytes) - (repaired.length > 0 ? 0 : 4),
      },
    ];
  });

/** A bare PDU ends only where its fields end. */
function behindPdu({ bytes, transport }: Case): Offer[] {
  if (transport !== 'pdu') return [];
  return DIRECTIONS.flatMap((direction): Offer[] => {
    const reading = decodeFrame(bytes, { transport, direction });
    const { outcome } = reading;
    if (outcome.kind !== 'extra') return [];
    const from = bytes.length - outcome.bytes;
    const repaired = [bytes.slice(0, from)].filter((pdu) => isSound(pdu, [transport]));
    const bits = likeness(reading, undefined, undefined) - Math.log2(outcome.bytes);
    return [{ code: 'extra-bytes', from, to: bytes.length, bytes: outcome.bytes, repaired, bits }];
  });
}

/** The frame without the bytes that belong to no field. */
function without(
  { bytes }: Case,
  ...[transport, direction]: ['rtu' | 'tcp' | 'ascii' | 'pdu', 'request' | 'response']
): Uint8Array[] {
  const reading = decodeFrame(bytes, { transport, direction });
  const rest = reading.spans.find(({ name }) => name === 'rest');
  const body = bodyOf(reading, bytes);
  if (rest === undefined || body === undefined) return [];
  const bytesOfRest = (rest.to - rest.from) / (transport === 'ascii' ? 2 : 1);
  const frame = carriedBy(transport, body.subarray(0, body.length - bytesOfRest), reading.transactionId);
  return isSound(frame, [transport]) ? [frame] : [];
}
