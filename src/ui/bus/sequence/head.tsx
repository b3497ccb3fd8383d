import { useLayoutEffect, useState } from 'preact/hooks';
import { builtInSequences, type SequenceTexts } from '../../../sequences/index.ts';
import { LONGEST_NAME, plainName } from '../../../workbench/index.ts';
import { Choice, optionsOf } from '../../kit/choice.tsx';
import { disabledFor } from '../../kit/disabled-for.ts';
import { Field, saidId } from '../../kit/field.tsx';
import { useWords } from '../../parts/words.ts';
import { sequences } from '../jobs.ts';

interface HeadProps {
  readonly sequence: SequenceTexts;
  readonly locked: boolean;
  readonly onEdit: (next: SequenceTexts, change: string) => void;
  readonly onMessage: (lines: readonly string[], focus?: string) => void;
}

/** Which sequence it is, and what it is called. */
export function Head({ sequence, locked, onEdit, onMessage }: HeadProps) {
  const words = useWords('sequence');
  const custom = sequences.custom.value;
  return (
    <fieldset class="sequence-head" {...disabledFor(locked ? words.locked : undefined)}>
      <div class="control">
        <label for="sequence-choice">{words.choose}</label>
        <div class="sequence-choice in-row">
          <select
            id="sequence-choice"
            value={sequence.name}
            onChange={({ currentTarget }) => {
              sequences.choose(currentTarget.value);
              onMessage([]);
            }}
          >
            <Group label={words.builtIn} of={builtInSequences} />
            {custom.length > 0 && <Group label={words.custom} of={custom} />}
          </select>
          <button
            type="button"
            onClick={() => {
              sequences.create(words.newName);
              onMessage([]);
            }}
          >
            {words.create}
          </button>
          {custom.includes(sequence) && (
            <button
              type="button"
              onClick={() => {
                sequences.deleteChosen();
                onMessage([words.removed(sequence.name)], 'undo');
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
function Name({ name, onName }: NameProps) {
  const words = useWords('sequence');
  const [text, setText] = useState(name);
  useLayoutEffect(() => setText(name), [name]);
  const typed = plainName(text);
  const blank = typed === '';
  return (
    <Field id="sequence-name" label={words.fields['name'] ?? 'name'} error={blank ? words.noName : undefined}>
      <input
        id="sequence-name"
        autocomplete="off"
        maxLength={LONGEST_NAME}
        value={text}
        aria-invalid={blank}
        aria-describedby={saidId('sequence-name')}
        onInput={({ currentTarget }) => setText(currentTarget.value)}
        onChange={() => !blank && typed !== name && onName(typed)}
      />
    </Field>
  );
}
