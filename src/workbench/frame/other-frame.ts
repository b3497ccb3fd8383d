import type { Draft } from './draft.ts';
import { type Evaluation, evaluate } from './evaluate.ts';
import { exceptionTo, expectReply } from './expected-reply.ts';
import { type PairReason, pairOf, replyOfPair, requestOfPair } from './pair.ts';

/** A frame that can be made the current one, by its draft. */
export interface OfferedFrame {
  readonly bytes: Uint8Array;
  readonly draft: Draft;
}

/** How much of an expected reply follows from its request: every byte, its length, or neither. */
export type ExpectedHow = 'exact' | 'layout' | 'open';

/** The other side of an exchange, as seen from one of its frames. */
export type OtherFrame =
  /** The request that a reply answers, or the reply that came to a request, and why they belong together. */
  | { readonly kind: 'request' | 'reply'; readonly frame: OfferedFrame; readonly why: PairReason }
  /** A reply whose request is not known. */
  | { readonly kind: 'no-request' }
  /** A request that nothing answers. */
  | { readonly kind: 'silence'; readonly why: 'broadcast' | 'silent' }
  /** What a request should get: a reply, of which `values` bytes are known by the device alone, or an exception. */
  | {
      readonly kind: 'expected';
      readonly how: ExpectedHow;
      readonly reply: OfferedFrame | undefined;
      readonly values: number;
      readonly exception: OfferedFrame | undefined;
    };

/** What a frame is answered with, or what it answers; of a pair the frame that is known, else what is to be expected. */
export function otherFrame(draft: Draft, frame: NonNullable<Evaluation['frame']>): OtherFrame {
  const pair = pairOf(draft, frame);
  if (draft.kind !== 'request') {
    if (pair === undefined) return { kind: 'no-request' };
    return { kind: 'request', frame: { bytes: pair.request.bytes, draft: requestOfPair(pair) }, why: pair.why };
  }
  if (pair) return { kind: 'reply', frame: { bytes: pair.reply.bytes, draft: replyOfPair(pair) }, why: pair.why };
  const { reading, bytes } = frame;
  const expected = expectReply(draft, reading, bytes);
  if (expected.kind === 'none') return { kind: 'silence', why: expected.why };
  const refusal = exceptionTo(draft, bytes);
  const reply = expected.evaluation.frame;
  const values = reply?.reading.spans.find(({ kind }) => kind === 'registers' || kind === 'bits');
  return {
    kind: 'expected',
    how: expected.kind,
    reply: reply && { bytes: reply.bytes, draft: expected.draft },
    values: values ? values.to - values.from : 0,
    exception: offered(refusal),
  };
}

function offered(draft: Draft): OfferedFrame | undefined {
  const { frame } = evaluate(draft);
  return frame && { bytes: frame.bytes, draft };
}
