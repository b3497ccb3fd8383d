import type { Transport } from '../../../modbus/index.ts';
import { type Case, isClean, type WholeFrame, wholesOf } from '../../case.ts';
import type { Offer } from '../../finding.ts';
import type { Hypothesis } from '../../hypothesis.ts';

/** What it counts against a request that it stands where a reply was awaited. */
const NOT_AWAITED = 12;

/** A frame in which nothing is wrong. */
export const valid: Hypothesis = {
  codes: ['valid', 'valid-exception'],
  offer: (item) => {
    const bare = item.transport === undefined ? wholesOf(item.bytes, 'pdu', item.request) : [];
    const clean = [...item.wholes, ...bare].filter(isClean);
    const transports = new Set(clean.map(({ reading }) => reading.transport));
    return [...transports].flatMap((transport) => ofTransport(item, transport, clean));
  },
};

function ofTransport({ bytes, request }: Case, transport: Transport, clean: readonly WholeFrame[]): Offer[] {
  const wholes = clean.filter(({ reading }) => reading.transport === transport);
  const directions = wholes.map(({ reading }) => reading.direction);
  const best = wholes.reduce((a, b) => (b.bits > a.bits ? b : a));
  const { functionCode = 0, fields } = best.reading;
  const bits = best.bits - (request && !directions.includes('response') ? NOT_AWAITED : 0);
  const place = { from: 0, to: bytes.length, repaired: [], transport, bits };
  const exceptionCode = fields['exceptionCode'];
  return functionCode >= 0x80 && typeof exceptionCode === 'number'
    ? [{ code: 'valid-exception', ...place, functionCode: functionCode & 0x7f, exceptionCode }]
    : [{ code: 'valid', ...place, directions, functionCode }];
}
