import { useId, useState } from 'preact/hooks';
import { TextField } from './text-field.tsx';

interface NumberProps<T> {
  readonly id?: string;
  readonly label: string;
  /** Whether the label is only for those who hear the page, as in a cell of a table. */
  readonly bare?: boolean;
  readonly value: string | number;
  /** The value of a text; `undefined` if it has none that is allowed. */
  readonly read: (text: string) => T | undefined;
  /** What is wrong with a text without a value. */
  readonly wrong: string;
  readonly onValue: (value: T) => void;
  /** When a text is read: while it is typed, or only when it is finished, by Enter or by leaving the field. */
  readonly when?: 'typed' | 'finished';
  readonly hint?: string | undefined;
  readonly usual?: readonly string[] | undefined;
}

/**
 * A number that is typed. A text without a value stays, with the reason beside it, and the last value holds. Escape gives the
 * text up.
 */
export function NumberEntry<T>(props: NumberProps<T>) {
  const { label, bare, value, read, wrong, onValue, when = 'typed', hint, usual } = props;
  const made = useId();
  const [text, setText] = useState<string>();
  const [refused, setRefused] = useState(false);
  const take = (typed: string): boolean => {
    const taken = read(typed);
    setRefused(taken === undefined);
    if (taken !== undefined) onValue(taken);
    return taken !== undefined;
  };
  const giveUp = () => {
    setText(undefined);
    setRefused(false);
  };
  const finish = () => {
    if (text !== undefined && (when === 'typed' ? !refused : take(text))) setText(undefined);
  };
  return (
    <TextField
      id={props.id ?? made}
      label={label}
      bare={bare}
      text={text ?? String(value)}
      error={refused ? wrong : ''}
      hint={hint}
      usual={usual}
      onText={(typed) => {
        setText(typed);
        if (when === 'typed') take(typed);
        else setRefused(false);
      }}
      onLeave={finish}
      onKey={({ key }) => {
        if (key === 'Enter') finish();
        if (key === 'Escape') giveUp();
      }}
    />
  );
}
