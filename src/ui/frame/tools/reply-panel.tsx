import type { Reading } from '../../../modbus/index.ts';
import { formatBytes } from '../../../notation/index.ts';
import type { ToolWords } from '../../../words/index.ts';
import type { Draft } from '../../../workbench/index.ts';
import { type ExpectedReply, evaluate, exceptionTo, expectReply } from '../../../workbench/index.ts';
import { DrawnWhenSeen } from '../../kit/drawn-when-seen.ts';
import { step } from '../../parts/store.ts';

/** Bytes that are written out: no legal frame has more. */
const MOST = 600;

interface ReplyProps {
  readonly draft: Draft;
  readonly reading: Reading;
  readonly bytes: Uint8Array;
  readonly words: ToolWords;
}

/** What a device will answer: the bytes, or their layout, or nothing; and how it refuses. */
export class ReplyPanel extends DrawnWhenSeen<ReplyProps, HTMLElement> {
  render() {
    const { draft, reading, bytes, words } = this.props;
    const expected = expectReply(draft, reading, bytes);
    return (
      <section class="panel reply" aria-labelledby="reply" ref={this.element}>
        <h2 id="reply">{words.reply}</h2>
        {expected.kind === 'none' ? (
          <p>{words[expected.why]}</p>
        ) : (
          <>
            <Expected expected={expected} words={words} />
            <Refusal draft={exceptionTo(draft, bytes)} words={words} />
          </>
        )}
      </section>
    );
  }
}

type Answer = Exclude<ExpectedReply, { readonly kind: 'none' }>;

function Expected({ expected, words }: { expected: Answer; words: ToolWords }) {
  const { frame } = expected.evaluation;
  if (frame === undefined) return <p>{words.noReply}</p>;
  const values = frame.reading.spans.find(({ kind }) => kind === 'registers' || kind === 'bits');
  const said =
    expected.kind === 'exact'
      ? words.echo
      : expected.kind === 'open'
        ? words.open
        : words.layout(frame.bytes.length, values === undefined ? 0 : values.to - values.from);
  return <Frame said={said} bytes={frame.bytes} use={words.use} draft={expected.draft} />;
}

function Refusal({ draft, words }: { draft: Draft; words: ToolWords }) {
  const { frame } = evaluate(draft);
  return frame ? <Frame said={words.refused} bytes={frame.bytes} use={words.useException} draft={draft} /> : null;
}

function Frame({ said, bytes, use, draft }: { said: string; bytes: Uint8Array; use: string; draft: Draft }) {
  return (
    <div class="answer">
      <p>{said}</p>
      <p class="mono">
        {formatBytes(bytes.subarray(0, MOST))}
        {bytes.length > MOST && ' …'}
      </p>
      <button type="button" onClick={() => step(draft)}>
        {use}
      </button>
    </div>
  );
}
