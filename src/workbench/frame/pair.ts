import { type DecodeContext, decodeFrame, isAgainstRequest, type Reading, toHex } from '../../modbus/index.ts';
import { formatBytes } from '../../notation/index.ts';
import type { Draft } from './draft.ts';
import { draftOf } from './draft-of-reading.ts';
import { type Evaluation, evaluate, requestOf } from './evaluate.ts';

/** A frame and the draft that it was made of. */
export interface DraftedFrame {
  readonly draft: Draft;
  readonly bytes: Uint8Array;
  readonly reading: Reading;
}

/**
 * Why a reply belongs to its request: `transaction` on TCP, `exception` by the function that it refuses, `same-content` where a
 * write is answered by its own content, else `unit-function-length`. `differs`: it was said to answer it and does not.
 */
export type PairReason = 'transaction' | 'exception' | 'same-content' | 'unit-function-length' | 'differs';

/** A request and the reply to it. */
export interface Pair {
  readonly request: DraftedFrame;
  readonly reply: DraftedFrame;
  readonly why: PairReason;
}

const EXCEPTION = 0x80;

/** A draft without the other frame of its pair. */
export const alone = ({ partner: _partner, ...draft }: Draft): Draft => draft;

/** The pair that a draft is a frame of; `undefined` if it says of no other frame, or the reply does not answer the request. */
export function pairOf(draft: Draft, frame: Evaluation['frame']): Pair | undefined {
  if (frame === undefined) return undefined;
  const own = { draft, ...frame };
  if (draft.kind !== 'request') {
    const asked = requestOf(draft);
    const request = asked && requestFrame(draft, asked);
    return request && { request, reply: own, why: reasonOf(own.reading, request.reading) };
  }
  if (draft.partner === undefined) return undefined;
  const reply = { ...draft.partner, answering: formatBytes(frame.bytes) };
  const answer = evaluate(reply).frame;
  if (answer === undefined || !answers(answer.reading)) return undefined;
  return { request: own, reply: { draft: reply, ...answer }, why: reasonOf(answer.reading, frame.reading) };
}

/** The request that a reply answers, as it was typed if that is known. */
function requestFrame({ transport, partner }: Draft, bytes: Uint8Array): DraftedFrame {
  const typed = partner && evaluate(partner).frame;
  if (partner && typed && toHex(typed.bytes) === toHex(bytes)) return { draft: partner, ...typed };
  const reading = decodeFrame(bytes, { transport, direction: 'request' });
  return { draft: draftOf(reading, undefined), bytes, reading };
}

const answers = (reply: Reading): boolean => reply.outcome.kind === 'whole' && !isAgainstRequest(reply);

function reasonOf(reply: Reading, request: Reading): PairReason {
  if (!answers(reply)) return 'differs';
  if (reply.transport === 'tcp') return 'transaction';
  if ((reply.functionCode ?? 0) >= EXCEPTION) return 'exception';
  return request.description?.access === 'writes' ? 'same-content' : 'unit-function-length';
}

/** Whether a request can be answered: it is whole, and nothing in it is an error. */
export const isSoundRequest = ({ outcome, problems }: Reading): boolean =>
  outcome.kind === 'whole' && problems.every(({ severity }) => severity !== 'error');

/** The reply that bytes are to a request; `undefined` if unit, function, length, transaction or content do not agree. */
export function replyTo(
  { draft, bytes: request }: Pick<DraftedFrame, 'draft' | 'bytes'>,
  bytes: Uint8Array,
): Draft | undefined {
  const context: DecodeContext = { transport: draft.transport, direction: 'response', request };
  const reply = decodeFrame(bytes, context);
  return answers(reply) && reply.functionCode !== undefined
    ? { ...draftOf(reply, request), partner: alone(draft) }
    : undefined;
}

/** The draft of a request with the bytes that answer it, if they do. */
export function withReply(draft: Draft, reply: Uint8Array): Draft {
  const { frame } = evaluate(draft);
  const partner = frame && draft.kind === 'request' ? replyTo({ draft, bytes: frame.bytes }, reply) : undefined;
  return partner ? { ...draft, partner: { ...alone(partner), answering: '' } } : draft;
}

/** The draft of the request of a pair, which knows its reply. */
export const requestOfPair = ({ request, reply }: Pair): Draft => ({
  ...request.draft,
  partner: { ...alone(reply.draft), answering: '' },
});

/** The draft of the reply of a pair, which knows its request. */
export const replyOfPair = ({ request, reply }: Pair): Draft => ({
  ...reply.draft,
  answering: formatBytes(request.bytes),
  partner: alone(request.draft),
});

/** The draft as another kind of frame: the other frame of its pair if that is one, with all that was typed for it. */
export function withKind(draft: Draft, kind: Draft['kind'], pair: Pair | undefined): Draft {
  if (pair && kind === 'request' && draft.kind !== 'request') return requestOfPair(pair);
  if (pair && kind === pair.reply.draft.kind && draft.kind === 'request') return replyOfPair(pair);
  return { ...draft, kind };
}

/** The draft without the other frame of its pair. */
export const parted = (draft: Draft): Draft => ({ ...alone(draft), answering: '' });
