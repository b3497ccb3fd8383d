import type { Reading, Transport } from '../../../modbus/index.ts';
import { type Case, isClean, type WholeFrame, wholesOf } from '../../case.ts';
import { CRC_BITS } from '../../evidence.ts';
import type { Offer } from '../../finding.ts';
import type { Hypothesis } from '../../hypothesis.ts';

/** The bits against a request where a reply was expected. */
const NOT_AWAITED = 12;

/** How rare bare PDUs are, in bits, if the transport is not known. */
const BARE = 5;

/** A frame in which nothing is wrong. */
export const valid: Hypothesis = {
  codes: ['valid', 'valid-exception'],
  offer: (item) => {
    const alone = item.transport === undefined && item.wholes.length === 0;
    const bare = alone ? wholesOf(item.bytes, 'pdu', item.request) : [];
    const clean = [...item.wholes, ...bare].filter(isClean);
    const transports = new Set(clean.map(({ reading }) => reading.transport));
    return [...[...transports].flatMap((transport) => ofTransport(item, transport, clean)), ...tooFew(item)];
  },
};

function ofTransport(
  { bytes, request, transport: asked }: Case,
  transport: Transport,
  clean: readonly WholeFrame[],
): Offer[] {
  const wholes = clean.filter(({ reading }) => reading.transport === transport);
  const directions = wholes.map(({ reading }) => reading.direction);
  const best = wholes.reduce((a, b) => (b.bits > a.bits ? b : a));
  const { functionCode = 0, fields } = best.reading;
  const given = asked === transport || transport !== 'pdu';
  // A frame of an unknown function has little evidence, but nothing is wrong with it.
  const evidence = given ? Math.max(1, best.bits) : best.bits - BARE;
  const bits = evidence - (request && !directions.includes('response') ? NOT_AWAITED : 0);
  const place = { from: 0, to: bytes.length, repaired: [], transport, bits };
  const exceptionCode = fields['exceptionCode'];
  return functionCode >= 0x80 && typeof exceptionCode === 'number'
    ? [{ code: 'valid-exception', ...place, functionCode: functionCode & 0x7f, exceptionCode }]
    : [{ code: 'valid', ...place, directions, functionCode, fields: 'fit' }];
}

/** Two bytes and the CRC: a request with fields is longer. */
const FEW = 6;

/** A right CRC behind bytes that are not a complete frame, as when somebody tries out the calculation. */
function tooFew({ bytes, wholes, request }: Case): Offer[] {
  const [whole] = wholes.filter(({ reading }) => reading.transport === 'rtu');
  const tried =
    bytes.length === FEW &&
    request === undefined &&
    whole !== undefined &&
    wholes.every(({ reading }) => isTooFew(reading));
  if (!tried) return [];
  const { functionCode = 0 } = whole.reading;
  const place = { from: 0, to: bytes.length, repaired: [], bits: 2 * CRC_BITS };
  return [{ code: 'valid', ...place, transport: 'rtu', directions: [], functionCode, fields: 'too-few' }];
}

/** As a request it is too short; as a reply its count is zero. */
const isTooFew = ({ direction, problems }: Reading) =>
  problems.some((problem) =>
    direction === 'request' ? problem.code === 'pdu-short' : problem.code === 'count-out-of-range' && problem.got === 0,
  );
