import { useRef } from 'preact/hooks';
import { formatBytes } from '../../../notation/index.ts';
import type { WordsOf } from '../../../words/index.ts';
import { type Draft, type Evaluation, evaluate, exceptionTo, expectReply } from '../../../workbench/index.ts';
import { useSignalWhenSeen } from '../../kit/signal-when-seen.ts';
import { currentFrame, hasFrame } from '../../parts/current-frame.ts';
import { page, step } from '../../parts/store.ts';
import { useWords } from '../../parts/words.ts';

/** Bytes that are written out: no legal frame has more. */
const MOST = 600;

/** What a device will answer to the current frame. */
export const Reply = () => hasFrame.value && page.kind.value === 'request' && <ReplyPanel />;

/** The bytes that a device will answer, or their layout, or nothing; and how it refuses. */
function ReplyPanel() {
  const words = useWords('tools');
  const element = useRef<HTMLElement>(null);
  const { draft: request, frame } = useSignalWhenSeen(currentFrame, element).value;
  return (
    <section class="panel stack reply" aria-labelledby="reply" ref={element}>
      <h2 id="reply">{words.reply}</h2>
      {frame && answersTo(request, frame, words)}
    </section>
  );
}

type Frame = NonNullable<Evaluation['frame']>;

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
        <Answer means={means[expected.kind](frame.bytes)} frame={frame} use={words.use} draft={expected.draft} />
      ) : (
        <p>{words.noReply}</p>
      )}
      {refused && <Answer means={words.refused} frame={refused} use={words.useException} draft={refusal} />}
    </>
  );
}

interface AnswerProps {
  readonly means: string;
  readonly frame: Frame;
  readonly use: string;
  readonly draft: Draft;
}

const Answer = ({ means, frame: { bytes }, use, draft: reply }: AnswerProps) => (
  <div class="answer">
    <p>{means}</p>
    <p class="mono">
      {formatBytes(bytes.subarray(0, MOST))}
      {bytes.length > MOST && ' …'}
    </p>
    <button type="button" onClick={() => step(reply)}>
      {use}
    </button>
  </div>
);
