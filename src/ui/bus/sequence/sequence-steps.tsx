import { Component } from 'preact';
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
import { page } from '../../parts/store.ts';
import type { StepMark } from './run.ts';
import { sequenceWords as words } from './sequence-words.ts';
import { StepFields } from './step-fields.tsx';
import { readingOf, StepMeaning } from './step-meaning.tsx';

export type StepAction = 'up' | 'down' | 'duplicate' | 'remove';
const ACTIONS: readonly StepAction[] = ['up', 'down', 'duplicate', 'remove'];

/** What a list of steps can have done to it. */
export interface StepDoings {
  readonly change: (place: StepPlace, field: string, text: string) => void;
  readonly act: (place: StepPlace, action: StepAction) => void;
  /** `frame` is the current frame. */
  readonly add: (place: StepPlace, what: StepKind | 'frame') => void;
}

interface ListProps {
  readonly sequence: SequenceTexts;
  readonly steps: readonly StepTexts[];
  /** Of the list: that of the repetition it is in, with no index in a list of the sequence itself. */
  readonly place: StepPlace;
  readonly faults: readonly PlacedFault[];
  readonly marks: ReadonlyMap<string, StepMark>;
  readonly doings: StepDoings;
  /** Nothing can be changed while it runs. */
  readonly locked: boolean;
}

/** Steps in their order, with what each came to, and ways to add others. */
export function StepList(props: ListProps) {
  const { steps, place } = props;
  const around = place.at.length > 0 ? words.addIn(words.stepName(place)) : words.addTo[place.list];
  return (
    <>
      {steps.length > 0 && (
        <ol class="steps">
          {steps.map((step, index) => (
            <StepRow key={index} {...props} step={step} place={{ list: place.list, at: [...place.at, index] }} />
          ))}
        </ol>
      )}
      <fieldset class="step-adds" disabled={props.locked}>
        <legend>{around}</legend>
        {(['frame', 'send', 'wait', 'until', 'repeat'] as const).map((what) => (
          <button
            key={what}
            type="button"
            onClick={() => props.doings.add({ list: place.list, at: [...place.at, steps.length] }, what)}
          >
            {words.add[what]}
          </button>
        ))}
      </fieldset>
    </>
  );
}

interface RowProps extends ListProps {
  readonly step: StepTexts;
}

class StepRow extends Component<RowProps> {
  override shouldComponentUpdate(next: RowProps) {
    const { step, place, sequence, faults, marks, locked } = this.props;
    // A mark of another step changes the map: only a repetition has to look into it.
    const marked = step.steps !== undefined && marks !== next.marks;
    return (
      marked ||
      step !== next.step ||
      locked !== next.locked ||
      faults !== next.faults ||
      sequence !== next.sequence ||
      marks.get(placeKey(place)) !== next.marks.get(placeKey(place))
    );
  }

  render() {
    const { step, place, sequence, faults, marks, doings, locked } = this.props;
    const name = words.stepName(place);
    const key = placeKey(place);
    const id = `sequence-${key.replaceAll(/\W/g, '-')}`;
    const mark = marks.get(key);
    const reading = readingOf(step, sequence.transport);
    return (
      <li
        class="step"
        data-kind={step.kind}
        data-mark={mark?.kind}
        aria-current={mark?.kind === 'running' ? 'step' : undefined}
      >
        <div class="step-head">
          <span>
            <b>{name}</b> {words.kinds[step.kind]}
          </span>
          <Mark mark={mark} />
          <span class="step-actions">
            {reading && (
              <button
                type="button"
                aria-label={words.action.open(name)}
                onClick={() => page.showReading(reading, undefined, 'step')}
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
                disabled={locked || isUseless(sequence, place, action)}
                onClick={() => doings.act(place, action)}
              >
                {words.actions[action]}
              </button>
            ))}
          </span>
        </div>
        <fieldset class="step-body" disabled={locked} aria-label={name}>
          <StepFields
            step={step}
            list={place.list}
            id={id}
            faults={faults.filter((fault) => placeKey(fault.place) === key)}
            onChange={(field, text) => doings.change(place, field, text)}
          />
        </fieldset>
        <StepMeaning step={step} transport={sequence.transport} />
        {step.steps && <StepList {...this.props} steps={step.steps} place={place} />}
      </li>
    );
  }
}

/** Whether a step cannot be moved that way. */
const isUseless = (sequence: SequenceTexts, place: StepPlace, action: StepAction): boolean =>
  (action === 'up' || action === 'down') && movedTo(sequence, place, action === 'up' ? -1 : 1) === undefined;

function Mark({ mark }: { readonly mark: StepMark | undefined }) {
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
