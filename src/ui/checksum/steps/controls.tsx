import { useSignal } from '@preact/signals';
import { type Stepper, stepSpeeds } from '../../../store/index.ts';
import { readStepPlace } from '../../../workbench/index.ts';
import { Select } from '../../kit/choice.tsx';
import { Field } from '../../kit/field.tsx';
import { TextInput } from '../../kit/text-input.tsx';
import { useWords } from '../../parts/words.ts';

interface ControlsProps {
  readonly stepper: Stepper;
}

/** The id of the field that leads to a byte. */
export const GO_TO = 'steps-go-to';

/** The buttons above the steps. */
export function Controls({ stepper }: ControlsProps) {
  const words = useWords('checksumSteps');
  const { move, play, foldAll } = stepper;
  const playing = stepper.playing.value;
  const atFirst = stepper.row.value === 0;
  const atLast = stepper.atLast.value;
  // A button that is disabled under the finger loses the focus, so that it only says so.
  const button = (label: string, act: () => void, why?: string | false) => (
    <button type="button" aria-disabled={why ? true : undefined} title={why || undefined} onClick={act}>
      {label}
    </button>
  );
  return (
    <div class="step-controls in-row">
      <div class="group in-row">
        {button(words.first, () => move(-Infinity), atFirst && words.atFirst)}
        {button(words.back, () => move(-1), atFirst && words.atFirst)}
        {button(playing ? words.stop : words.play, play, atLast && !playing && words.atLast)}
        {button(words.forward, () => move(1), atLast && words.atLast)}
        {button(words.last, () => move(Infinity), atLast && words.atLast)}
      </div>
      <label>
        {words.speed}{' '}
        <Select
          value={stepper.speed}
          options={stepSpeeds.map((value) => ({ value, name: words.perSecond(value) }))}
          onChoose={(speed) => {
            stepper.speed = speed;
          }}
        />
      </label>
      <div class="group in-row">
        {button(words.foldAll, () => foldAll(true))}
        {button(words.unfoldAll, () => foldAll(false))}
      </div>
      <GoTo stepper={stepper} />
    </div>
  );
}

/** Leads to a byte, or to a shift of it. */
function GoTo({ stepper: { bytes, go } }: ControlsProps) {
  const words = useWords('checksumSteps');
  const text = useSignal('');
  /** The text that was to be gone to and is not a place. */
  const refused = useSignal<string | undefined>(undefined);
  const wrong = refused.value === text.value && readStepPlace(text.value, bytes) === undefined;
  const submit = (event: Event) => {
    event.preventDefault();
    const place = readStepPlace(text.value, bytes);
    refused.value = place ? undefined : text.value;
    if (place) go(place);
  };
  return (
    <form class="go-to in-row" onSubmit={submit}>
      <Field id={GO_TO} label={words.goTo} error={wrong ? words.noSuchByte(bytes - 1) : ''}>
        <TextInput
          id={GO_TO}
          text={text.value}
          wrong={wrong}
          placeholder={words.goToHint}
          onText={(typed) => {
            text.value = typed;
          }}
        />
        <button type="submit">{words.go}</button>
      </Field>
    </form>
  );
}
