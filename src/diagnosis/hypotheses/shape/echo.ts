import { decodeFrame } from '../../../modbus/index.ts';
import { type Case, wholesOf } from '../../case.ts';
import type { Offer } from '../../finding.ts';
import { hasErrors, isWhole } from '../../frames.ts';
import type { Hypothesis } from '../../hypothesis.ts';
import type { Request } from '../../request.ts';

/** Evidence of a byte that is as in the request, and against it of one that is not. */
const SAME = 8;
const WRONG = 14;
const COST = 6;
/** Fewer bytes may as well be the beginning of the reply. */
const LEAST = 4;

/** The request came back: the line hears its own sender. */
export const echo: Hypothesis = {
  codes: ['echo', 'truncated-echo'],
  offer: (item) => {
    const { bytes, request } = item;
    if (request === undefined || bytes.length < LEAST || isOwnReply(request)) return [];
    const { length } = request.bytes;
    const there = Math.min(bytes.length, length);
    let wrong = 0;
    for (let i = 0; i < there; i++) if (bytes[i] !== request.bytes[i]) wrong++;
    const bits = SAME * (there - wrong) - WRONG * wrong - COST;
    const rest = bytes.length - length;
    if (rest >= 0)
      return [{ code: 'echo', from: 0, to: length, wrong, rest, ...replyIn(item, length), bits: bits + 1 }];
    return mayBeReply(item) ? [] : [cutOff(bytes, -rest, wrong, bits)];
  },
};

const cutOff = ({ length }: Uint8Array, missing: number, wrong: number, bits: number): Offer => ({
  code: 'truncated-echo',
  from: 0,
  to: length,
  missing,
  wrong,
  repaired: [],
  bits,
});

/** Whether a reply to this request has the same bytes, so that they are no echo. */
function isOwnReply({ bytes, reading: { transport } }: Request): boolean {
  const reading = decodeFrame(bytes, { transport, direction: 'response', request: bytes });
  return isWhole(reading) && !hasErrors(reading);
}

/** Whether the bytes are a good beginning of a reply, as the first bytes of a write are. */
const mayBeReply = ({ bytes, bodies }: Case) =>
  bodies.some(({ reading, end }) => end > bytes.length && reading.problems.every(({ code }) => code === 'frame-short'));

/** The reply behind the echo, if there is one. */
function replyIn({ bytes, request }: Case, from: number): { repaired: Uint8Array[] } {
  const behind = bytes.slice(from);
  const transport = request?.reading.transport ?? 'rtu';
  const replies = wholesOf(behind, transport, request).filter(
    ({ reading }) => reading.direction === 'response' && !hasErrors(reading),
  );
  return { repaired: replies.length > 0 ? [behind] : [] };
}
