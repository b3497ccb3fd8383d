import { decodeFrame, type SerialMode } from '../../modbus/index.ts';
import type { Draft } from '../frame/draft.ts';
import { draftOf } from '../frame/draft-of-reading.ts';
import { type Evaluation, evaluate, requestOf } from '../frame/evaluate.ts';
import { expectReply } from '../frame/expected-reply.ts';

/**
 * Where the length of a reply comes from: known from the request, open because only the device knows it, none for a
 * broadcast or a silent function, from a reply that is the current frame, typed, or unknown for lack of a frame.
 */
export type ReplySource = 'known' | 'open' | 'broadcast' | 'silent' | 'current' | 'typed' | 'none';

type Frame = NonNullable<Evaluation['frame']>;

/** How long the frames of the current exchange are, in characters of a serial line. */
export interface ExchangeSizes {
  readonly request: number | undefined;
  /** 0 if no device answers. */
  readonly reply: number | undefined;
  readonly source: ReplySource;
}

/** The frame of a draft as a serial line carries it; with all that is forced if it is on such a line already. */
function onLine(draft: Draft, mode: SerialMode): { draft: Draft; frame: Frame } | undefined {
  const carried = draft.transport === mode ? draft : { ...draft, transport: mode, force: {} };
  const { frame } = evaluate(carried);
  return frame && { draft: carried, frame };
}

/** The request that the draft is, or answers. */
function requestDraft(draft: Draft): Draft | undefined {
  if (draft.kind === 'request') return draft;
  const bytes = requestOf(draft);
  const { transport } = draft;
  return bytes && draftOf(decodeFrame(bytes, { transport, direction: 'request' }), undefined);
}

/** The exchange that the draft's frame belongs to. */
export function exchangeSizes(draft: Draft, mode: SerialMode): ExchangeSizes {
  const asked = requestDraft(draft);
  const request = asked && onLine(asked, mode);
  const length = request?.frame.bytes.length;
  if (draft.kind !== 'request') {
    const reply = onLine({ ...draft, answering: '' }, mode)?.frame.bytes.length;
    return { request: length, reply, source: reply === undefined ? 'none' : 'current' };
  }
  if (request === undefined) return { request: undefined, reply: undefined, source: 'none' };
  const expected = expectReply(request.draft, request.frame.reading, request.frame.bytes);
  if (expected.kind === 'none') return { request: length, reply: 0, source: expected.why };
  const reply = expected.evaluation.frame?.bytes.length;
  return { request: length, reply, source: reply === undefined ? 'none' : expected.kind === 'open' ? 'open' : 'known' };
}
