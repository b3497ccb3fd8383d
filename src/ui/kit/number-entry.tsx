import { Component } from 'preact';
import { TextField } from './text-field.tsx';

interface EntryProps {
  readonly id: string;
  readonly label: string;
  readonly value: string;
  /** What is wrong with a text; nothing where it is taken. */
  readonly take: (text: string) => string | undefined;
  readonly hint?: string | undefined;
  readonly list?: readonly string[] | undefined;
}

/** What a `NumberEntry` does with a text: what can be read is passed on, and of anything else it says what is wrong. */
export const taking =
  <T,>(read: (text: string) => T | undefined, wrong: string, take: (value: T) => void) =>
  (text: string): string | undefined => {
    const value = read(text);
    if (value === undefined) return wrong;
    take(value);
    return undefined;
  };

/** A number that is taken while it is typed. A text that is none stays, with the reason beside it; the last number holds. */
export class NumberEntry extends Component<EntryProps, { text?: string | undefined; wrong?: string | undefined }> {
  render() {
    const { id, label, value, take, hint, list } = this.props;
    const { text, wrong } = this.state;
    return (
      <TextField
        id={id}
        label={label}
        text={text ?? value}
        error={wrong}
        hint={hint}
        usual={list}
        onText={(typed) => this.setState({ text: typed, wrong: take(typed) })}
        onLeave={() => {
          if (wrong === undefined) this.setState({ text: undefined });
        }}
      />
    );
  }
}
