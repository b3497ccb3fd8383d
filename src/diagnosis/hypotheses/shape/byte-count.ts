import { crc16, fieldsOf, type Reading, type Span } from '../../../modbus/index.ts';
import { type Case, isFrameAndZeros, wholesOf } from '../../case.ts';
import { CRC_BITS, endsThere, tries } from '../../evidence.ts';
import type { Offer } from '../../finding.ts';
import { hasErrors, join, replaced } from '../../frames.ts';
import type { Hypothesis } from '../../hypothesis.ts';
import { carriedBy } from '../../request.ts';

const COST = 4;
/** The count alone is wrong: with another the frame is sound. */
const MENDED = 12;
/** The bits if no other count makes the frame sound. */
const UNMENDED = -6;
/** Where byte counts stand in RTU frames: in replies, in writes, in the function that reads and writes. */
const PLACES = [2, 6, 10];

/** The byte count does not match the bytes, or is missing. */
export const byteCount: Hypothesis = {
  codes: ['byte-count'],
  offer: (item) => (item.cut ? [] : [...contradicted(item), ...notAsAsked(item), ...left(item)]),
};

/** The checksum holds, and the count does not. */
const contradicted = (item: Case): Offer[] =>
  item.wholes.flatMap(({ reading, bits }): Offer[] => {
    const span = reading.spans.find(({ kind }) => kind === 'count');
    const wrong = reading.problems.find(({ code }) => code === 'count-wrong' || code === 'count-contradicts-quantity');
    if (span === undefined || wrong === undefined || !('expected' in wrong)) return [];
    // The request asks for exactly this count, so bytes are missing.
    if (isAsAsked(item, reading, span)) return [];
    const { got, expected } = wrong as { got: number; expected: number };
    const frame = reading.transport === 'ascii' ? [] : withCount(item, reading, span, expected);
    return [
      {
        code: 'byte-count',
        from: span.from,
        to: span.to,
        got,
        expected,
        repaired: frame,
        bits: bits + (frame.length > 0 ? MENDED : UNMENDED),
      },
    ];
  });

/** Whether there is a request, and the count is the one that it asks for. */
function isAsAsked({ request }: Case, { direction, description, fields, problems }: Reading, { name }: Span): boolean {
  if (request === undefined || direction !== 'response' || description?.code !== request.functionCode) return false;
  if (problems.some(({ code }) => code === 'count-not-as-requested')) return false;
  for (const { field } of fieldsOf(description, direction, fields))
    if (field.name === name) return field.replyRules.length > 0;
  return false;
}

/** The frame with another count and the checksum for it. */
function withCount({ bytes, request }: Case, { transport }: Reading, { from, to }: Span, count: number): Uint8Array[] {
  if (count < 0 || count > 0xff) return [];
  const mended = replaced(bytes, to - 1, count);
  if (to - from > 1) mended[from] = 0;
  const frame = transport === 'rtu' ? carriedBy('rtu', mended.subarray(0, -2)) : mended;
  const sound = wholesOf(frame, transport, request).some(({ reading }) => !hasErrors(reading));
  return sound ? [frame] : [];
}

/** Without a valid checksum, the request tells what the count should be, and the bytes that it is too small. */
function notAsAsked(item: Case): Offer[] {
  const { bytes, request } = item;
  if (request === undefined || item.wholes.length > 0) return [];
  return item.bodies.flatMap(({ reading, end, bits }): Offer[] => {
    const span = reading.spans.find(({ kind }) => kind === 'count');
    const wrong = reading.problems.find(({ code }) => code === 'count-not-as-requested');
    if (span === undefined || wrong?.code !== 'count-not-as-requested' || end + 2 >= bytes.length) return [];
    const { got, expected } = wrong;
    const [from, to] = [1 + span.from, 1 + span.to];
    const frame = carriedBy('rtu', replaced(bytes, to - 1, expected & 0xff).subarray(0, -2));
    const sound = wholesOf(frame, 'rtu', request).some((whole) => !hasErrors(whole.reading));
    return [{ code: 'byte-count', from, to, got, expected, repaired: sound ? [frame] : [], bits: bits + 6 - COST }];
  });
}

/** The count was left out: with it inserted, everything fits. */
function left({ bytes, bodies, request }: Case): Offer[] {
  const end = bytes.length - 2;
  if (bodies.length === 0 || end < 3) return [];
  const holds = (frame: Uint8Array) => crc16(frame) === 0;
  return PLACES.flatMap((at) => {
    const expected = end - at;
    if (expected < 1 || expected > 0xff) return [];
    // The checksum was calculated before the count was lost, or after, or it is wrong and only the request tells.
    const complete = join(bytes.subarray(0, at), [expected], bytes.subarray(at));
    const proved = holds(complete) || (holds(bytes) && !isFrameAndZeros(bytes));
    if (!proved && request === undefined) return [];
    const repaired = carriedBy('rtu', complete.subarray(0, -2));
    return wholesOf(repaired, 'rtu', request).flatMap(({ reading, bits }): Offer[] => {
      const counted = reading.spans.some(({ kind, from }) => kind === 'count' && from === at);
      if (hasErrors(reading) || !counted) return [];
      // The count could be of any number of bytes, so the place where the frame ends is not evidence.
      const evidence = bits - endsThere(reading) - (proved ? 0 : CRC_BITS) - tries(2 * PLACES.length) - COST;
      return [
        { code: 'byte-count', from: at, to: at + 1, got: undefined, expected, repaired: [repaired], bits: evidence },
      ];
    });
  });
}
