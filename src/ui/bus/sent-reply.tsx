import type { Finding } from '../../diagnosis/index.ts';
import { decodeFrame } from '../../modbus/index.ts';
import { formatBytes } from '../../notation/index.ts';
import { useNaming } from '../parts/device/naming.ts';
import { ExplanationOf } from '../parts/explanation/explanation.tsx';
import { page } from '../parts/store.ts';
import { useWords } from '../parts/words.ts';
import { bus } from './bus.ts';

interface ReplyProps {
  readonly request: Uint8Array;
  readonly reply: Uint8Array;
}

/** A reply as it is read: its problems, and every byte of it. */
export function SentReply({ request, reply }: ReplyProps) {
  const { page: words, section } = useWords('page');
  const { problem: textOf } = useWords('complaints');
  const { transport } = bus.rules.value;
  const reading = decodeFrame(reply, { transport, direction: 'response', request });
  const names = useNaming()?.(reading);
  return (
    <>
      <p>{words.summary(reading, reply.length, transport)}</p>
      <p class="mono bytes-line">{formatBytes(reply)}</p>
      <ul class="problems edges">
        {reading.problems.map((problem) => (
          <li key={`${problem.code} ${problem.span.from}`} data-severity={problem.severity}>
            <b>{words.severities[problem.severity]}</b> {textOf(problem)}{' '}
            <span class="section">{section(problem.section)}</span>
          </li>
        ))}
      </ul>
      <ExplanationOf reading={reading} bytes={reply} names={names} />
      <div class="actions">
        <button type="button" onClick={() => page.showReading(reading, request, 'step')}>
          {useWords('bus').send.open}
        </button>
      </div>
    </>
  );
}

/** Findings that are shown: the others are hardly likely. */
const SHOWN = 2;

/** Why what came is not a valid frame: the likeliest findings, in their order. */
export function ReplyFindings({ findings }: { readonly findings: readonly Finding[] }) {
  const say = useWords('findings');
  return (
    <ul class="problems edges">
      {findings.slice(0, SHOWN).map((finding) => {
        const { title, why } = say(finding);
        return (
          <li key={`${finding.code} ${finding.from}`} data-severity="error">
            <b>{title}</b> {why}
          </li>
        );
      })}
    </ul>
  );
}
