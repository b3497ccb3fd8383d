import { bitsTime, type Section } from '../../modbus/index.ts';
import type { TimingView } from '../../store/index.ts';
import { errorOf, knownOf, type TypedTiming } from '../../workbench/index.ts';
import { Field } from '../kit/field.tsx';
import { TextInput } from '../kit/text-input.tsx';
import { SectionNames } from '../parts/section-names.tsx';
import type { ViewProps } from '../parts/use-view.ts';
import { useWords } from '../parts/words.ts';

interface EntryFieldProps extends ViewProps<TimingView> {
  readonly name: TypedTiming;
  readonly label: string;
  readonly hint?: string | undefined;
  /** Where the specification says what is legal. */
  readonly section?: Section | undefined;
  readonly placeholder?: string | undefined;
  readonly list?: string | undefined;
}

/** A text with what it comes to, or what is wrong with it. */
export function EntryField({ view, name, label, hint, section, placeholder, list }: EntryFieldProps) {
  const { inputError } = useWords('complaints');
  const error = errorOf(view.reading.value.entries[name]);
  const id = `timing-text-${name}`;
  const said = error && (
    <>
      {inputError(error)} {section && <SectionNames of={section} />}
    </>
  );
  return (
    <Field id={id} label={label} hint={hint} error={said}>
      <TextInput
        id={id}
        text={view.shown.value[name]}
        wrong={error !== undefined}
        placeholder={placeholder}
        list={list}
        onText={(text) => view.set(name, text)}
      />
    </Field>
  );
}

/** A time, with what it is in other units before its hint. */
export function TimeField({ view, name, label, hint, section }: EntryFieldProps) {
  const text = useWords('timing');
  const words = useWords('page');
  const { entries, line } = view.reading.value;
  const time = knownOf(entries[name]);
  const said = [
    time && line ? text.timeHint(time, time / bitsTime(line.baud, 1)) : '',
    hint ?? '',
    section ? words.section(section) : '',
  ];
  return <EntryField view={view} name={name} label={label} section={section} hint={said.join(' ').trim()} />;
}
