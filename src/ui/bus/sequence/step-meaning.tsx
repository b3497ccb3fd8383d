import { decodeFrame, fromHex, type SerialMode } from '../../../modbus/index.ts';
import type { StepTexts } from '../../../sequences/index.ts';
import { useWords } from '../../parts/words.ts';

/** The frame of a step with its bytes; `undefined` if the step has none. */
export function frameOf({ kind, fields }: StepTexts, transport: SerialMode) {
  const bytes = kind === 'send' ? fromHex(fields['bytes'] ?? '') : undefined;
  if (bytes === undefined || bytes.length === 0) return undefined;
  return { bytes, reading: decodeFrame(bytes, { transport, direction: 'request' }) };
}

interface MeaningProps {
  readonly frame: NonNullable<ReturnType<typeof frameOf>>;
  readonly transport: SerialMode;
}

/** The meaning of a step's frame, and its faults: it is sent all the same. */
export function StepMeaning({ frame: { bytes, reading }, transport }: MeaningProps) {
  const { page, labels } = useWords('page');
  const { withNames } = useWords('sequence');
  const { problem: textOf } = useWords('complaints');
  const parts = Object.entries(reading.fields).flatMap(([name, value]) => {
    const label = labels[name]?.toLowerCase() ?? name;
    if (typeof value === 'number' || typeof value === 'string') return [[label, String(value)] as const];
    const isList = Array.isArray(value) && value.every((one) => typeof one === 'number');
    return isList ? [[label, value.join(' ')] as const] : [];
  });
  return (
    <>
      <p class="step-meaning">
        {page.summary(reading, bytes.length, transport)}
        {parts.length > 0 && `: ${withNames(parts)}`}
      </p>
      {reading.problems.map((problem) => (
        <p key={`${problem.code} ${problem.span.from}`} class="said" data-severity={problem.severity}>
          <span class="problem">{textOf(problem)}</span>
        </p>
      ))}
    </>
  );
}
