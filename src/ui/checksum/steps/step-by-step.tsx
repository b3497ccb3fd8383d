import { useEffect, useMemo } from 'preact/hooks';
import type { CrcSteps } from '../../../modbus/index.ts';
import { KeptChoice, Stepper, type StepSpeed, stepSpeeds } from '../../../store/index.ts';
import { flag, oneOf, stepsText, stepText } from '../../../workbench/index.ts';
import { CopyButton } from '../../kit/copy-button.tsx';
import { storage } from '../../parts/store.ts';
import { useWords } from '../../parts/words.ts';
import { AfterPaint } from './after-paint.ts';
import { ByTable } from './by-table.tsx';
import { Controls, GO_TO } from './controls.tsx';
import { EntriesPanel } from './entries-panel.tsx';
import { Receiver } from './receiver.tsx';
import { Result } from './result.tsx';
import { StepList } from './step-list.tsx';

const kept = {
  folded: new KeptChoice(storage, 'checksum-steps-folded', false, flag),
  speed: new KeptChoice<StepSpeed>(storage, 'checksum-step-speed', 2, oneOf(stepSpeeds)),
};

function every(milliseconds: number, act: () => void): () => void {
  const timer = setInterval(act, milliseconds);
  return () => clearInterval(timer);
}

/** Registers of more bits take the whole width. */
const WIDE = 18;

/** The id of the names of the keys. */
const KEYS = 'steps-keys';

/** Goes through the steps: with buttons, with keys, and by itself. Other steps start from the beginning. */
export function StepByStep({ steps }: { readonly steps: CrcSteps }) {
  const words = useWords('checksumSteps');
  const stepper = useMemo(() => new Stepper(steps.bytes.length, kept, every), [steps]);
  useEffect(() => stepper.stop, [stepper]);
  const rows = stepper.rows.value;
  const place = stepper.place.value;
  // The same for all rows, so that no step draws it again.
  const end = useMemo(
    () => (
      <div class="step-end">
        <Result steps={steps} />
        <Receiver steps={steps} />
      </div>
    ),
    [steps],
  );

  const onKey = (event: KeyboardEvent) => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    if (event.key === 'g') document.getElementById(GO_TO)?.focus();
    else if (!stepper.press(`${event.shiftKey ? 'Shift ' : ''}${event.key}`)) return;
    event.preventDefault();
  };
  return (
    <>
      <Controls stepper={stepper} />
      <div class="step-columns" data-wide={steps.form.bits > WIDE ? '' : undefined}>
        <div class="step-by-step">
          <StepList
            steps={steps}
            rows={rows}
            chosen={stepper.row.value}
            describedBy={KEYS}
            onChoose={(row) => stepper.move(row - stepper.row.peek())}
            onFold={stepper.toggle}
            onKey={onKey}
          />
          <p class="now">{stepText(steps, place, words)}</p>
          <CopyButton
            label={words.copySteps}
            text={() => stepsText(steps, rows, words)}
            of={rows}
            copied={words.copied}
            refused={() => words.copyFailed}
          />
          <p class="step-keys said in-row" id={KEYS}>
            {words.keys}{' '}
            {words.keyNames.map(({ keys, does }) => (
              <span key={does}>
                {keys.map((key) => (
                  <>
                    <kbd key={key}>{key}</kbd>{' '}
                  </>
                ))}
                {does}
              </span>
            ))}
          </p>
        </div>
        <AfterPaint>
          {() => (
            <>
              <ByTable steps={steps} place={place} />
              {end}
            </>
          )}
        </AfterPaint>
      </div>
      <EntriesPanel steps={steps} index={steps.byte(place.at).index} />
    </>
  );
}
