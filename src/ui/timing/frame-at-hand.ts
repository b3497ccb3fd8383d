import { decodeFrame, type SerialMode } from '../../modbus/index.ts';
import type { ReplySource } from '../../words/index.ts';
import type { Draft } from '../../workbench/index.ts';
import { draftOf, type Evaluation, evaluate, expectReply, requestOf } from '../../workbench/index.ts';

type Frame = NonNullable<Evaluation['frame']>;

/** How long the frames of the exchange at hand are, in characters of a serial line. */
export interface FramesAtHand {
  readonly request: number | undefined;
  /** 0 where nobody answers. */
  readonly reply: number | undefined;
  readonly source: ReplySource;
}

/** The frame of a draft as a serial line carries it; one that is on a serial line already, with all that is forced. */
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

/** The exchange that the frame at hand belongs to. */
export function framesAtHand(draft: Draft, mode: SerialMode): FramesAtHand {
  const asked = requestDraft(draft);
  const request = asked && onLine(asked, mode);
  const length = request?.frame.bytes.length;
  if (draft.kind !== 'request') {
    const reply = onLine({ ...draft, answering: '' }, mode)?.frame.bytes.length;
    return { request: length, reply, source: reply === undefined ? 'none' : 'at-hand' };
  }
  if (request === undefined) return { request: undefined, reply: undefined, source: 'none' };
  const expected = expectReply(request.draft, request.frame.reading, request.frame.bytes);
  if (expected.kind === 'none') return { request: length, reply: 0, source: expected.why };
  const reply = expected.evaluation.frame?.bytes.length;
  return { request: length, reply, source: reply === undefined ? 'none' : expected.kind === 'open' ? 'open' : 'known' };
}
