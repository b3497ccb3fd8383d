import { formatBytes } from '../../../notation/index.ts';
import type { WordsOf } from '../../../words/index.ts';
import { type OfferedFrame, type OtherFrame, otherFrame } from '../../../workbench/index.ts';
import type { TabProps } from '../current-frame.ts';
import { show } from '../store.ts';
import { useWords } from '../words.ts';

/** Bytes that are written out: no legal frame has more. */
const MOST = 600;

/** The reply to a request, as it came or as it is to be expected, or the request that a reply answers. */
export function ReplyTab({ of }: TabProps) {
  const words = useWords('reply');
  const { draft, frame } = of.value;
  return frame === undefined ? (
    <p class="said">{words.noReply}</p>
  ) : (
    <div class="stack reply">{contentOf(otherFrame(draft, frame), words)}</div>
  );
}

function contentOf(other: OtherFrame, words: WordsOf<'reply'>) {
  switch (other.kind) {
    case 'no-request':
      return <p class="said">{words.noRequest}</p>;
    case 'silence':
      return <p>{words.silence[other.why]}</p>;
    case 'request':
    case 'reply':
      return (
        <>
          <Offered
            {...other.frame}
            means={words[other.kind]}
            use={other.kind === 'request' ? words.toRequest : words.toReply}
          />
          <p class={other.why === 'differs' ? 'error' : 'said'}>{words.pairs[other.why]}</p>
        </>
      );
    case 'expected': {
      const { how, reply, values, exception } = other;
      return (
        <>
          {reply ? (
            <Offered {...reply} means={words.expected[how](reply.bytes.length, values)} use={words.use} />
          ) : (
            <p>{words.noReply}</p>
          )}
          {exception && <Offered {...exception} means={words.refused} use={words.useException} />}
        </>
      );
    }
  }
}

interface OfferedProps extends OfferedFrame {
  readonly means: string;
  readonly use: string;
}

/** A frame that can be made the current one. */
const Offered = ({ bytes, draft, means, use }: OfferedProps) => (
  <div class="answer">
    <p>{means}</p>
    <p class="mono">
      {formatBytes(bytes.subarray(0, MOST))}
      {bytes.length > MOST && ' …'}
    </p>
    <button type="button" onClick={() => show(draft, 'step')}>
      {use}
    </button>
  </div>
);
