import { decodeFrame } from '../../../modbus/index.ts';
import { type Case, wholesOf } from '../../case.ts';
import type { Offer } from '../../finding.ts';
import { hasErrors } from '../../frames.ts';
import type { Hypothesis } from '../../hypothesis.ts';
import { isOwnReply, type Request } from '../../request.ts';

/** The bits for a byte that is as in the request, and against one that is not. */
const SAME = 8;
const WRONG = 14;
const COST = 6;
/** Fewer bytes may also be the beginning of the reply. */
const LEAST = 4;

/** The request came back: the line hears its own sender. */
export const echo: Hypothesis = {
  codes: ['echo', 'truncated-echo'],
  offer: (item) => {
    const { bytes, request } = item;
    if (request === undefined || bytes.length < LEAST || isOwnReply(request) || mayBeReply(bytes, request)) return [];
    const { length } = request.bytes;
    const there = Math.min(bytes.length, length);
    let wrong = 0;
    for (let i = 0; i < there; i++) if (bytes[i] !== request.bytes[i]) wrong++;
    const bits = SAME * (there - wrong) - WRONG * wrong - COST;
    const rest = bytes.length - length;
    if (rest >= 0)
      return [{ code: 'echo', from: 0, to: length, wrong, rest, ...replyIn(item, length), bits: bits + 1 }];
    return [cutOff(bytes, -rest, wrong, bits)];
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

/** Whether the bytes are a good beginning of a reply, or all of it: the replies to writes begin as their requests do. */
function mayBeReply(bytes: Uint8Array, { bytes: asked, reading: { transport } }: Request): boolean {
  const reading = decodeFrame(bytes, { transport, direction: 'response', request: asked });
  return (
    reading.outcome.kind !== 'extra' &&
    reading.problems.every(({ code, severity }) => severity !== 'error' || OF_THE_END.has(code))
  );
}
const OF_THE_END = new Set(['frame-short', 'mbap-length-wrong']);

/** The reply behind the echo, if there is one. */
function replyIn({ bytes, request }: Case, from: number): { repaired: Uint8Array[] } {
  const behind = bytes.slice(from);
  const transport = request?.reading.transport ?? 'rtu';
  const replies = wholesOf(behind, transport, request).filter(
    ({ reading }) => reading.direction === 'response' && !hasErrors(reading),
  );
  return { repaired: replies.length > 0 ? [behind] : [] };
}
