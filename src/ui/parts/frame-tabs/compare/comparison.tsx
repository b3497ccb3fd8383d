import './compare.css';
import { Comparison } from '../../../../store/index.ts';
import { Field } from '../../../kit/field.tsx';
import { TextArea } from '../../../kit/text-input.tsx';
import type { CurrentFrame, TabProps } from '../../current-frame.ts';
import { useWords } from '../../words.ts';
import { CauseLine, DifferenceList } from './difference-list.tsx';
import { SideBySide } from './side-by-side.tsx';
import { Transports } from './transports.tsx';

const comparison = new Comparison();

/** The frame in every transport, and beside what a device sent: what differs, why, and what to do. */
export function CompareTab({ of }: TabProps) {
  const words = useWords('compare');
  const wrong = comparison.bytes.value === undefined;
  return (
    <>
      <Transports {...of.value} />
      <h3 class="sent">{words.heading}</h3>
      <Field id="sent" label={words.sent} hint={words.sentHint} error={wrong ? words.notBytes : undefined}>
        <TextArea
          id="sent"
          text={comparison.text.value}
          line={64}
          wrong={wrong}
          onText={(typed) => {
            comparison.text.value = typed;
          }}
        />
      </Field>
      <Result {...of.value} />
    </>
  );
}

function Result({ draft, frame }: CurrentFrame) {
  const words = useWords('compare');
  const compared = comparison.of(draft, frame);
  if (compared === undefined) return <Verdict text={comparison.bytes.value?.length ? words.noFrame : ''} />;
  const { causes, differences } = compared.comparison;
  const identical = causes.some(({ code }) => code === 'identical');
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

/** The result in a sentence. It stands also when it is empty, so that what comes is read out. */
function Verdict({ text, good = false }: { readonly text: string; readonly good?: boolean }) {
  return (
    <p class="verdict" data-severity={good ? undefined : 'error'} aria-live="polite">
      {text && <strong>{text}</strong>}
    </p>
  );
}
