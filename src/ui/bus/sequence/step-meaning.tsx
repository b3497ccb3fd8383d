import { decodeFrame, fromHex, type Reading, type SerialMode } from '../../../modbus/index.ts';
import type { StepTexts } from '../../../sequences/index.ts';
import { words as pageWords, problemText } from '../../parts/page-words.ts';
import { sequenceWords as words } from './sequence-words.ts';

/** The frame of a step as it is read; `undefined` while it is none. */
export function readingOf({ kind, fields }: StepTexts, transport: SerialMode): Reading | undefined {
  const bytes = kind === 'send' ? fromHex(fields['bytes'] ?? '') : undefined;
  return bytes && bytes.length > 0 ? decodeFrame(bytes, { transport, direction: 'request' }) : undefined;
}

/** What the frame of a step says, and what is wrong with it: it is sent all the same. */
export function StepMeaning({ step, transport }: { readonly step: StepTexts; readonly transport: SerialMode }) {
  const reading = readingOf(step, transport);
  if (reading === undefined) return null;
  const size = fromHex(step.fields['bytes'] ?? '')?.length ?? 0;
  const parts = Object.entries(reading.fields).flatMap(([name, value]) =>
    typeof value === 'number' || typeof value === 'string'
      ? [[pageWords.labels[name]?.toLowerCase() ?? name, String(value)] as const]
      : Array.isArray(value) && value.every((one) => typeof one === 'number')
        ? [[pageWords.labels[name]?.toLowerCase() ?? name, value.join(' ')] as const]
        : [],
  );
  return (
    <>
      <p class="step-meaning">
        {pageWords.page.summary(reading, size, transport)}
        {parts.length > 0 && `: ${words.withNames(parts)}`}
      </p>
      {reading.problems.map((problem) => (
        <p key={`${problem.code} ${problem.span.from}`} class="said" data-severity={problem.severity}>
          <span class="problem">{problemText(problem)}</span>
        </p>
      ))}
    </>
  );
}
