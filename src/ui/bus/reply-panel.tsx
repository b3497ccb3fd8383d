import { decodeFrame } from '../../modbus/index.ts';
import { part, Slot } from '../parts/slot.tsx';
import { useWords } from '../parts/words.ts';
import { bus } from './bus.ts';
import { ResultNotes } from './result-notes.tsx';
import { severityOf } from './send-panel.tsx';

const sentReply = part(
  ['complaints', 'tools'],
  () => import('./sent-reply.tsx'),
  ({ SentReply }) => SentReply,
);
const replyFindings = part(
  ['findings'],
  () => import('./sent-reply.tsx'),
  ({ ReplyFindings }) => ReplyFindings,
);

/** What became of the request that was sent last, which it names: the current frame may be another by now. */
export function ReplyPanel() {
  const text = useWords('bus').send;
  const { summary } = useWords('page').page;
  const { value: last } = bus.last;
  if (last === undefined) return <p class="said">{bus.sending.value ? text.sending : text.noReplyYet}</p>;
  const { duration, attempts, reply, request, transport, findings, outcome } = last;
  const asked = decodeFrame(request, { transport, direction: 'request' });
  return (
    <section class="reply" aria-label={text.lastReply}>
      <p class="verdict" data-severity={severityOf(last)}>
        <strong>{text.result(last)}</strong> {duration !== undefined && <span>{text.took(duration, attempts)}</span>}
      </p>
      <p class="said">{text.replyTo(summary(asked, request.length, transport))}</p>
      {findings.length > 0 && <Slot part={replyFindings} with={{ findings }} />}
      <ResultNotes last={last} />
      {reply && outcome !== 'silent' && <Slot part={sentReply} with={{ request, reply, transport }} />}
    </section>
  );
}
