import { Field } from './field.tsx';
import { TextInput } from './text-input.tsx';

interface TextFieldProps {
  readonly id: string;
  readonly label: string;
  readonly bare?: boolean | undefined;
  readonly text: string;
  readonly onText: (text: string) => void;
  /** What is wrong with the text; blank if nothing is. */
  readonly error?: string | undefined;
  /** What the text comes to. */
  readonly hint?: string | undefined;
  /** Texts that are usual here. */
  readonly usual?: readonly string[] | undefined;
  readonly onLeave?: (() => void) | undefined;
  readonly onKey?: ((event: KeyboardEvent) => void) | undefined;
}

/** A labelled line of text, with what is wrong with it, or else what it comes to. */
export function TextField(props: TextFieldProps) {
  const { id, label, bare, text, onText, error = '', hint, usual, onLeave, onKey } = props;
  const list = usual && `${id}-usual`;
  return (
    <Field id={id} label={label} bare={bare} hint={hint} error={error}>
      <TextInput id={id} text={text} wrong={error !== ''} list={list} onText={onText} onLeave={onLeave} onKey={onKey} />
      {usual && (
        <datalist id={list}>
          {usual.map((one) => (
            <option key={one} value={one} />
          ))}
        </datalist>
      )}
    </Field>
  );
}
