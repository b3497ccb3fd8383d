import { computed, signal } from '@preact/signals';
import { useMemo } from 'preact/hooks';
import type { Finding } from '../../diagnosis/index.ts';
import { decodeFrame, type SerialMode } from '../../modbus/index.ts';
import { formatBytes } from '../../notation/index.ts';
import { draftOf, evaluate, type FrameTab } from '../../workbench/index.ts';
import { useNaming } from '../parts/device/naming.ts';
import { FrameTabs } from '../parts/frame-tabs/frame-tabs.tsx';
import { page } from '../parts/store.ts';
import { Strip } from '../parts/strip/strip.tsx';
import { useWords } from '../parts/words.ts';

interface ReplyProps {
  readonly request: Uint8Array;
  readonly reply: Uint8Array;
  readonly transport: SerialMode;
}

/** The tab of the reply that is open. */
const openTab = signal<FrameTab>('bytes');

/** A reply as it is read: its bytes, its problems, and all that can be said of it. */
export function SentReply({ request, reply, transport }: ReplyProps) {
  const { page: words, section } = useWords('page');
  const { problem: textOf } = useWords('complaints');
  const { send: text } = useWords('bus');
  const naming = useNaming();
  const { reading, of, explained } = useMemo(() => {
    const reading = decodeFrame(reply, { transport, direction: 'response', request });
    const draft = draftOf(reading, request);
    return {
      reading,
      of: computed(() => ({ draft, frame: evaluate(draft).frame })),
      explained: computed(() => ({ reading, bytes: reply, names: naming?.(reading) })),
    };
  }, [request, reply, transport, naming]);
  return (
    <>
      <Strip
        of={explained}
        label={text.replyBytes}
        actions={
          <button type="button" onClick={() => page.showReading(reading, request, 'step')}>
            {text.open}
          </button>
        }
      >
        <p class="mono bytes-line">{formatBytes(reply)}</p>
        <ul class="problems edges">
          {reading.problems.map((problem) => (
            <li key={`${problem.code} ${problem.span.from}`} data-severity={problem.severity}>
              <b>{words.severities[problem.severity]}</b> {textOf(problem)}{' '}
              <span class="section">{section(problem.section)}</span>
            </li>
          ))}
        </ul>
      </Strip>
      <FrameTabs
        of={of}
        chosen={openTab}
        onChoose={(tab) => {
          openTab.value = tab;
        }}
      />
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
