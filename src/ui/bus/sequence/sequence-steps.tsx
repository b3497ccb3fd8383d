import { computed, type ReadonlySignal } from '@preact/signals';
import { useMemo } from 'preact/hooks';
import { isFailure } from '../../../bus/index.ts';
import {
  movedTo,
  type PlacedFault,
  placeKey,
  type SequenceTexts,
  type StepKind,
  type StepPlace,
  type StepTexts,
} from '../../../sequences/index.ts';
import type { StepMark } from '../../../store/index.ts';
import { disabledFor } from '../../kit/disabled-for.ts';
import { page } from '../../parts/store.ts';
import { useWords } from '../../parts/words.ts';
import { run } from '../jobs.ts';
import { StepFields } from './step-fields.tsx';
import { frameOf, StepMeaning } from './step-meaning.tsx';

export type StepAction = 'up' | 'down' | 'duplicate' | 'remove';
const ACTIONS: readonly StepAction[] = ['up', 'down', 'duplicate', 'remove'];

/** The acts on a list of steps. */
export interface StepActs {
  readonly change: (place: StepPlace, field: string, text: string) => void;
  readonly act: (place: StepPlace, action: StepAction) => void;
  /** `frame` is the current frame. */
  readonly add: (place: StepPlace, kind: StepKind | 'frame') => void;
}

interface ListProps {
  readonly sequence: SequenceTexts;
  readonly steps: readonly StepTexts[];
  /** Of the list: that of the repetition it is in, with no index in a list of the sequence itself. */
  readonly place: StepPlace;
  readonly faults: readonly PlacedFault[];
  readonly acts: StepActs;
  /** Nothing can be changed while it runs. */
  readonly locked: boolean;
}

/** Steps in their order, each with its outcome, and buttons that add others. */
export function StepList(props: ListProps) {
  const words = useWords('sequence');
  const { steps, place, acts, locked } = props;
  const legend = place.at.length > 0 ? words.addIn(words.stepName(place)) : words.addTo[place.list];
  return (
    <>
      {steps.length > 0 && (
        <ol class="steps stack">
          {steps.map((step, index) => (
            <StepRow key={index} {...props} step={step} place={{ list: place.list, at: [...place.at, index] }} />
          ))}
        </ol>
      )}
      <fieldset class="step-adds in-row" {...disabledFor(locked ? words.locked : undefined)}>
        <legend>{legend}</legend>
        {(['frame', 'send', 'wait', 'until', 'repeat'] as const).map((kind) => (
          <button
            key={kind}
            type="button"
            onClick={() => acts.add({ list: place.list, at: [...place.at, steps.length] }, kind)}
          >
            {words.add[kind]}
          </button>
        ))}
      </fieldset>
    </>
  );
}

interface RowProps extends ListProps {
  readonly step: StepTexts;
}

function StepRow(props: RowProps) {
  const { step, place, sequence, faults, acts, locked } = props;
  const words = useWords('sequence');
  const name = words.stepName(place);
  const key = placeKey(place);
  const frame = frameOf(step, sequence.transport);
  // The mark is drawn without its step.
  const { mark, marked, current } = useMemo(() => {
    const mark = computed(() => (run.of.value === sequence ? run.marks.value.get(key) : undefined));
    const marked = computed(() => mark.value?.kind);
    return { mark, marked, current: computed(() => (marked.value === 'running' ? 'step' : undefined)) };
  }, [sequence, key]);
  return (
    <li class="step" data-kind={step.kind} data-mark={marked} aria-current={current}>
      <div class="step-head in-row">
        <span>
          <b>{name}</b> {words.kinds[step.kind]}
        </span>
        <Mark mark={mark} />
        <span class="step-actions in-row">
          {frame && (
            <button
              type="button"
              aria-label={words.action.open(name)}
              onClick={() => page.showReading(frame.reading, undefined, 'step')}
            >
              {words.actions.open}
            </button>
          )}
          {ACTIONS.map((action) => (
            <button
              key={action}
              type="button"
              data-focus={`${action} ${key}`}
              aria-label={words.action[action](name)}
              {...disabledFor(
                locked
                  ? words.locked
                  : isUseless(sequence, place, action)
                    ? words.useless[action === 'up' ? 'up' : 'down']
                    : undefined,
              )}
              onClick={() => acts.act(place, action)}
            >
              {words.actions[action]}
            </button>
          ))}
        </span>
      </div>
      <fieldset class="step-body" {...disabledFor(locked ? words.locked : undefined)} aria-label={name}>
        <StepFields
          step={step}
          list={place.list}
          id={`sequence-${key.replaceAll(/\W/g, '-')}`}
          faults={faults.filter((fault) => placeKey(fault.place) === key)}
          onChange={(field, text) => acts.change(place, field, text)}
        />
      </fieldset>
      {frame && <StepMeaning frame={frame} transport={sequence.transport} />}
      {step.steps && <StepList {...props} steps={step.steps} place={place} />}
    </li>
  );
}

/** Whether a step cannot be moved that way. */
const isUseless = (sequence: SequenceTexts, place: StepPlace, action: StepAction): boolean =>
  (action === 'up' || action === 'down') && movedTo(sequence, place, action === 'up' ? -1 : 1) === undefined;

/** Whether a step runs, or its outcome. */
function Mark({ mark: { value: mark } }: { readonly mark: ReadonlySignal<StepMark | undefined> }) {
  const words = useWords('sequence');
  if (mark === undefined) return null;
  if (mark.kind === 'running') return <span class="step-mark">▶ {words.atStep(mark.rounds)}</span>;
  const { outcome } = mark;
  const failed = isFailure(outcome) || outcome.kind === 'lost';
  const severity = failed ? 'error' : outcome.kind === 'stopped' ? 'warning' : undefined;
  return (
    <span class="step-mark" data-severity={severity}>
      {failed ? '✗' : outcome.kind === 'stopped' ? '■' : '✓'} {words.outcome(outcome)}
    </span>
  );
}
