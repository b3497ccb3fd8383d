import type { Section } from '../../modbus/index.ts';
import { type Entry, errorOf, type TimingName } from '../../workbench/index.ts';
import { TextInput } from '../kit/text-input.tsx';
import { idOf, Labelled } from '../parts/labelled.tsx';

interface EntryFieldProps {
  readonly name: TimingName;
  readonly label: string;
  readonly text: string;
  readonly entry: Entry<number | undefined>;
  readonly hint?: string | undefined;
  /** Where the specification says what is legal. */
  readonly section?: Section | undefined;
  readonly placeholder?: string | undefined;
  readonly list?: string | undefined;
  readonly onText: (name: TimingName, text: string) => void;
}

/** A text with what it comes to, or what is wrong with it. */
export function EntryField({ name, label, text, entry, hint, section, placeholder, list, onText }: EntryFieldProps) {
  const error = errorOf(entry);
  const path = `timing-${name}`;
  return (
    <Labelled path={path} label={label} hint={hint} error={error} section={section}>
      <TextInput
        id={idOf(path)}
        text={text}
        wrong={error !== undefined}
        placeholder={placeholder}
        list={list}
        onText={(typed) => onText(name, typed)}
      />
    </Labelled>
  );
}
