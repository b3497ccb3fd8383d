import { decodeFrame } from '../../../modbus/index.ts';
import { formatBytes } from '../../../notation/index.ts';
import type { WordsOf } from '../../../words/index.ts';
import {
  type Draft,
  draftOf,
  type Evaluation,
  evaluate,
  exceptionTo,
  expectReply,
  requestOf,
} from '../../../workbench/index.ts';
import type { TabProps } from '../current-frame.ts';
import { show } from '../store.ts';
import { useWords } from '../words.ts';

/** Bytes that are written out: no legal frame has more. */
const MOST = 600;

/** What is answered to a request, or the request that a reply answers. */
export function ReplyTab({ of }: TabProps) {
  const words = useWords('tools');
  const { draft, frame } = of.value;
  if (frame === undefined) return <p class="said">{words.noReply}</p>;
  return (
    <div class="stack reply">
      {draft.kind === 'request' ? answersTo(draft, frame, words) : <Answered draft={draft} words={words} />}
    </div>
  );
}

type Frame = NonNullable<Evaluation['frame']>;

interface AnsweredProps {
  readonly draft: Draft;
  readonly words: WordsOf<'tools'>;
}

/** The request that a reply answers, as far as it is known. */
function Answered({ draft, words }: AnsweredProps) {
  const bytes = requestOf(draft);
  if (bytes === undefined || bytes.length === 0) return <p class="said">{words.noRequest}</p>;
  const request = () => draftOf(decodeFrame(bytes, { transport: draft.transport, direction: 'request' }), undefined);
  return <Other means={words.answers} bytes={bytes} use={words.toRequest} draft={request} />;
}

/** The expected reply and the exception. */
function answersTo(request: Draft, { reading, bytes }: Frame, words: WordsOf<'tools'>) {
  const expected = expectReply(request, reading, bytes);
  if (expected.kind === 'none') return <p>{words[expected.why]}</p>;
  const { frame } = expected.evaluation;
  const refusal = exceptionTo(request, bytes);
  const refused = evaluate(refusal).frame;
  const values = frame?.reading.spans.find(({ kind }) => kind === 'registers' || kind === 'bits');
  const means = {
    exact: () => words.echo,
    open: () => words.open,
    layout: ({ length }: Uint8Array) => words.layout(length, values ? values.to - values.from : 0),
  };
  return (
    <>
      {frame ? (
        <Other
          means={means[expected.kind](frame.bytes)}
          bytes={frame.bytes}
          use={words.use}
          draft={() => expected.draft}
        />
      ) : (
        <p>{words.noReply}</p>
      )}
      {refused && <Other means={words.refused} bytes={refused.bytes} use={words.useException} draft={() => refusal} />}
    </>
  );
}

interface OtherProps {
  readonly means: string;
  readonly bytes: Uint8Array;
  readonly use: string;
  readonly draft: () => Draft;
}

/** The other frame of the exchange, which can be made the current one. */
const Other = ({ means, bytes, use, draft }: OtherProps) => (
  <div class="answer">
    <p>{means}</p>
    <p class="mono">
      {formatBytes(bytes.subarray(0, MOST))}
      {bytes.length > MOST && ' …'}
    </p>
    <button type="button" onClick={() => show(draft(), 'step')}>
      {use}
    </button>
  </div>
);
