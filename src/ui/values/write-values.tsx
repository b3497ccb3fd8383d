import { Component } from 'preact';
import { formatHex, readValues } from '../../notation/index.ts';
import { type Draft, withText } from '../draft.ts';
import type { Control, Evaluation } from '../evaluate.ts';
import { step } from '../state.ts';
import { valueWords as words } from './language.ts';

interface WriteProps {
  readonly draft: Draft;
  readonly evaluation: Evaluation;
}

/** Most registers shown before they are put into the frame. */
const SHOWN = 16;

/** Typed values that become the registers of the frame. */
export class WriteValues extends Component<WriteProps, { open: boolean; text: string }> {
  override state = { open: false, text: '' };

  render() {
    const target = targetOf(this.props.evaluation);
    if (target === undefined) return null;
    return (
      <details
        class="write-values"
        open={this.state.open}
        onToggle={({ currentTarget: { open } }) => this.setState({ open })}
      >
        <summary>{words.write}</summary>
        {this.state.open && this.body(target)}
      </details>
    );
  }

  private body({ path, field }: Control) {
    const { text } = this.state;
    const { values, faults } = readValues(text);
    const registers = values.flatMap((value) => value.registers);
    const single = field.kind !== 'registers';
    const tooMany = single && registers.length > 1;
    const ready = registers.length > 0 && faults.length === 0 && !tooMany;
    const lineOf = (place: number) => text.slice(0, place).split('\n').length;
    return (
      <div class="control" data-invalid={faults.length > 0 || tooMany ? '' : undefined}>
        <label for="typed-values">{words.typed}</label>
        <textarea
          id="typed-values"
          class="mono"
          autocomplete="off"
          spellcheck={false}
          autocapitalize="off"
          rows={Math.min(12, Math.max(3, text.split('\n').length))}
          value={text}
          aria-invalid={faults.length > 0 || tooMany}
          aria-describedby="typed-said"
          onInput={({ currentTarget }) => this.setState({ text: currentTarget.value })}
        />
        <div class="said" id="typed-said" aria-live="polite">
          <p>{words.typedHint}</p>
          {faults.slice(0, SHOWN).map(({ place, fault }) => (
            <p class="error" key={place.start}>
              {words.line(lineOf(place.start))} {words.fault(fault)}
            </p>
          ))}
          {tooMany && <p class="error">{words.onlyOne(registers.length)}</p>}
          {values.flatMap(({ place, notes }) =>
            notes.map((note) => (
              <p class="problem" data-severity="warning" key={`${place.start}-${note.code}`}>
                {words.line(lineOf(place.start))} {words.note(note)}
              </p>
            )),
          )}
          {registers.length > 0 && faults.length === 0 && (
            <p>
              {words.registers(registers.length)}{' '}
              <span class="mono">
                {hexOf(registers.slice(0, SHOWN))}
                {registers.length > SHOWN && ' …'}
              </span>
            </p>
          )}
        </div>
        <button
          type="button"
          disabled={!ready}
          onClick={() => step(withText(this.props.draft, path, hexOf(registers)))}
        >
          {words.apply}
        </button>
      </div>
    );
  }
}

const hexOf = (registers: readonly number[]) => registers.map((register) => formatHex(register, 4)).join(' ');

/** The field of the form that holds registers: a list, or the value of a single one. */
const targetOf = ({ controls, description }: Evaluation): Control | undefined =>
  controls.find(({ field }) => field.kind === 'registers') ??
  (description.table === 'holding-register'
    ? controls.find(({ field }) => field.name === 'value' && field.kind === 'number')
    : undefined);
