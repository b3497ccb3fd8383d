import type { Finding } from '../../diagnosis/index.ts';
import { decodeFrame, type Problem } from '../../modbus/index.ts';
import { formatBytes } from '../../notation/index.ts';
import { useNaming } from '../parts/device/naming.ts';
import { loadExplanation } from '../parts/explanation/load-explanation.tsx';
import { Slot } from '../parts/slot.tsx';
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
  const { problems } = useWords('complaints');
  const { transport } = bus.rules.value;
  const reading = decodeFrame(reply, { transport, direction: 'response', request });
  // Each code has the sentence of its own problem.
  const textOf = (problem: Problem) => (problems[problem.code] as (problem: Problem) => string)(problem);
  return (
    <>
      <p>{words.summary(reading, reply.length, transport)}</p>
      <p class="mono bytes-line">{formatBytes(reply)}</p>
      <ul class="problems">
        {reading.problems.map((problem) => (
          <li key={`${problem.code} ${problem.span.from}`} data-severity={problem.severity}>
            <b>{words.severities[problem.severity]}</b> {textOf(problem)}{' '}
            <span class="section">{section(problem.section)}</span>
          </li>
        ))}
      </ul>
      <Slot part={loadExplanation} with={{ reading, bytes: reply, names: useNaming()?.(reading) }} />
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
    <ul class="problems">
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
