import { Component } from 'preact';
import { builtInSequences, type SequenceTexts } from '../../../sequences/index.ts';
import { LONGEST_NAME, plainName } from '../../../workbench/index.ts';
import { Choice, optionsOf } from '../../kit/choice.tsx';
import { Field, saidId } from '../../kit/field.tsx';
import { library } from './library.ts';
import { sequenceWords as words } from './sequence-words.ts';

interface HeadProps {
  readonly sequence: SequenceTexts;
  readonly locked: boolean;
  readonly onEdit: (next: SequenceTexts, what: string) => void;
  readonly onSaid: (said: readonly string[], focus?: string) => void;
}

/** Which sequence it is, and what it is called. */
export function Head({ sequence, locked, onEdit, onSaid }: HeadProps) {
  return (
    <fieldset class="sequence-head" disabled={locked}>
      <div class="control">
        <label for="sequence-choice">{words.choose}</label>
        <div class="sequence-choice">
          <select
            id="sequence-choice"
            value={sequence.name}
            onChange={({ currentTarget }) => {
              library.choose(currentTarget.value);
              onSaid([]);
            }}
          >
            <Group label={words.builtIn} of={builtInSequences} />
            {library.own.length > 0 && <Group label={words.own} of={library.own} />}
          </select>
          <button
            type="button"
            onClick={() => {
              library.create(words.newName);
              onSaid([]);
            }}
          >
            {words.create}
          </button>
          {library.isOwn(sequence) && (
            <button
              type="button"
              onClick={() => {
                library.remove();
                onSaid([words.removed(sequence.name)], 'undo');
              }}
            >
              {words.remove}
            </button>
          )}
        </div>
      </div>
      <Name name={sequence.name} onName={(name) => onEdit({ ...sequence, name }, '')} />
      <Choice
        id="sequence-transport"
        label={words.transport}
        value={sequence.transport}
        options={optionsOf(words.transports)}
        onChoose={(transport) => onEdit({ ...sequence, transport }, '')}
      />
      <div class="control about">
        <label for="sequence-about">{words.about}</label>
        <textarea
          id="sequence-about"
          rows={2}
          value={sequence.about}
          onInput={({ currentTarget }) => onEdit({ ...sequence, about: currentTarget.value }, 'about')}
        />
      </div>
    </fieldset>
  );
}

const Group = ({ label, of }: { readonly label: string; readonly of: readonly SequenceTexts[] }) => (
  <optgroup label={label}>
    {of.map(({ name }) => (
      <option key={name} value={name}>
        {name}
      </option>
    ))}
  </optgroup>
);

interface NameProps {
  readonly name: string;
  readonly onName: (name: string) => void;
}

/** A name as typed; it counts when the field is left, so that half a name is not taken for that of another. */
class Name extends Component<NameProps, { readonly text: string | undefined }> {
  override state = { text: undefined as string | undefined };

  override componentDidUpdate(before: NameProps) {
    if (before.name !== this.props.name) this.setState({ text: undefined });
  }

  render() {
    const { name, onName } = this.props;
    const { text = name } = this.state;
    const blank = plainName(text) === '';
    return (
      <Field id="sequence-name" label={words.fields['name'] ?? 'name'} error={blank ? words.noName : undefined}>
        <input
          id="sequence-name"
          autocomplete="off"
          maxLength={LONGEST_NAME}
          value={text}
          aria-invalid={blank}
          aria-describedby={saidId('sequence-name')}
          onInput={({ currentTarget }) => this.setState({ text: currentTarget.value })}
          onChange={() => !blank && plainName(text) !== name && onName(plainName(text))}
        />
      </Field>
    );
  }
}
