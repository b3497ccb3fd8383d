import './compare.css';
import { computed, signal } from '@preact/signals';
import { compareFrames } from '../../../diagnosis/index.ts';
import { readBytes } from '../../../notation/index.ts';
import { type Compared, requestOf } from '../../../workbench/index.ts';
import { Field } from '../../kit/field.tsx';
import { TextArea } from '../../kit/text-input.tsx';
import { useWords } from '../../parts/words.ts';
import type { CurrentFrame } from '../current-frame.ts';
import { CauseLine, DifferenceList } from './difference-list.tsx';
import { SideBySide } from './side-by-side.tsx';

/** What the device sent, as typed. */
const sent = signal('');
const theirs = computed(() => readSent(sent.value));

/** The current frame beside what a device sent: what differs, why, and what to do. */
export function Comparison(current: CurrentFrame) {
  const words = useWords('compare');
  const wrong = theirs.value === undefined;
  return (
    <>
      <Field id="sent" label={words.sent} hint={words.sentHint} error={wrong ? words.notBytes : undefined}>
        <TextArea
          id="sent"
          text={sent.value}
          line={64}
          wrong={wrong}
          onText={(typed) => {
            sent.value = typed;
          }}
        />
      </Field>
      <Result {...current} theirs={theirs.value} />
    </>
  );
}

/** The bytes of a text, however it says them; `undefined` for a text that says none. */
function readSent(text: string): Uint8Array | undefined {
  const { bytes } = readBytes(text);
  return bytes.length === 0 && text.trim() !== '' ? undefined : bytes;
}

function Result({ draft, frame, theirs }: CurrentFrame & { readonly theirs: Uint8Array | undefined }) {
  const words = useWords('compare');
  if (theirs === undefined || theirs.length === 0) return <Verdict />;
  if (frame === undefined) return <Verdict text={words.noFrame} />;
  const { bytes: mine, reading } = frame;
  const { transport, direction } = reading;
  const comparison = compareFrames(mine, theirs, { transport, direction, request: requestOf(draft) });
  const { causes, differences } = comparison;
  const identical = causes.some(({ code }) => code === 'identical');
  const compared: Compared = { comparison, mine, theirs, ascii: transport === 'ascii' };
  return (
    <>
      <Verdict text={identical ? words.identical : words.differences(differences.length)} good={identical} />
      {causes.map((cause) => (
        <CauseLine key={cause.code} cause={cause} />
      ))}
      <SideBySide {...compared} />
      {differences.length > 0 && <DifferenceList {...compared} />}
    </>
  );
}

/** What it comes to. It stands also when it is empty, so that what comes is read out. */
function Verdict({ text, good = false }: { readonly text?: string; readonly good?: boolean }) {
  return (
    <p class="verdict" data-severity={good ? undefined : 'error'} aria-live="polite">
      {text && <strong>{text}</strong>}
    </p>
  );
}
