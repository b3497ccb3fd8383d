import { Component } from 'preact';
import type { Control, Evaluation } from '../../../workbench/index.ts';
import {
  type Draft,
  placeOf,
  readTyped,
  type TypedReading,
  targetsOf,
  unitsAt,
  withText,
} from '../../../workbench/index.ts';
import { Choice } from '../../kit/choice.tsx';
import { Fold } from '../../kit/fold.tsx';
import { words as pageWords } from '../../parts/page-words.ts';
import { step } from '../../parts/store.ts';
import { NamedValues } from './named-values.tsx';
import { registersSaid, unitSource } from './typed-values.ts';
import { valueWords as words } from './value-words.ts';

interface WriteProps {
  readonly draft: Draft;
  readonly evaluation: Evaluation;
}

interface WriteState {
  readonly text: string;
  /** The field that was chosen, by its path. */
  readonly into: string;
}

/** Most faults shown, and registers whose units are named. */
const SHOWN = 16;

/** Typed values that become the registers of the frame, and the device's names for what may be written. */
export class WriteValues extends Component<WriteProps, WriteState> {
  override state: WriteState = { text: '', into: '' };

  render() {
    const { draft, evaluation } = this.props;
    const targets = targetsOf(evaluation);
    const target = targets.find(({ path }) => path === this.state.into) ?? targets[0];
    if (target === undefined) return null;
    return (
      <>
        <NamedValues control={target} draft={draft} evaluation={evaluation} />
        <Fold class="write-values" summary={words.write}>
          {() => (
            <>
              {targets.length > 1 && (
                <Choice
                  id="typed-into"
                  label={words.into}
                  value={target.path}
                  options={targets.map(({ path, field }) => ({ value: path, name: nameOf(path, field.name) }))}
                  onChoose={(into) => this.setState({ into })}
                />
              )}
              {this.body(target)}
            </>
          )}
        </Fold>
      </>
    );
  }

  private body(target: Control) {
    const { draft, evaluation } = this.props;
    const { text } = this.state;
    const source = unitSource();
    const read = readTyped(text, { control: target, draft, evaluation }, source);
    const wrong = read.faults.length > 0 || read.tooMany;
    const place = placeOf(target, draft, evaluation);
    const units = Array.from({ length: SHOWN }, (_, behind) =>
      unitsAt(source, place, behind).map(({ unit }) => unit),
    ).flat();
    return (
      <div class="control" data-invalid={wrong ? '' : undefined}>
        <label for="typed-values">{words.typed}</label>
        <textarea
          id="typed-values"
          class="mono"
          autocomplete="off"
          spellcheck={false}
          autocapitalize="off"
          rows={Math.min(12, Math.max(3, text.split('\n').length))}
          value={text}
          aria-invalid={wrong}
          aria-describedby="typed-said"
          onInput={({ currentTarget }) => this.setState({ text: currentTarget.value })}
        />
        <div class="said" id="typed-said" aria-live="polite">
          <p>
            {words.typedHint} {units.length > 0 && words.unitsKnown([...new Set(units)])}
          </p>
          <Said text={text} read={read} />
        </div>
        <button
          type="button"
          disabled={read.text === undefined}
          onClick={() => read.text !== undefined && step(withText(draft, target.path, read.text))}
        >
          {words.apply}
        </button>
      </div>
    );
  }
}

/** What the typed values come to, line by line, or what is wrong with them. */
function Said({ text, read }: { readonly text: string; readonly read: TypedReading }) {
  const { values, faults, registers, tooMany } = read;
  const lineOf = (place: number) => words.line(text.slice(0, place).split('\n').length);
  return (
    <>
      {faults.slice(0, SHOWN).map(({ place, fault }) => (
        <p class="error" key={place.start}>
          {lineOf(place.start)} {words.fault(fault)}
        </p>
      ))}
      {tooMany && <p class="error">{words.onlyOne(registers.length)}</p>}
      {values.slice(0, SHOWN).flatMap(({ place, notes }) =>
        notes.map((note) => {
          const exact = note.code === 'in-units' && note.inUnits.exact;
          return (
            <p
              key={`${place.start}-${note.code}`}
              class={exact ? undefined : 'problem'}
              data-severity={exact ? undefined : 'warning'}
            >
              {lineOf(place.start)} {words.note(note)}
            </p>
          );
        }),
      )}
      {registers.length > 0 && faults.length === 0 && <p>{registersSaid(registers)}</p>}
    </>
  );
}

/** `2: Record data` for a field of the second group. */
function nameOf(path: string, name: string): string {
  const label = pageWords.labels[name] ?? name;
  const index = /\[(\d+)\]/.exec(path)?.[1];
  return index === undefined ? label : words.group(Number(index) + 1, label);
}
