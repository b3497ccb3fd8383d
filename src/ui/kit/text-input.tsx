import { saidId } from './field.tsx';

export interface InputProps {
  readonly id: string;
  readonly text: string;
  readonly wrong?: boolean;
  readonly onText: (text: string) => void;
  readonly onEnter?: (() => void) | undefined;
}

interface LineProps extends InputProps {
  readonly placeholder?: string | undefined;
  /** The id of the list of what is usual here. */
  readonly list?: string | undefined;
  readonly onLeave?: (() => void) | undefined;
  readonly onKey?: ((event: KeyboardEvent) => void) | undefined;
}

/** What inputs of text have in common: nothing corrects what an engineer types. */
const attributes = ({ id, text, wrong = false, onText, onEnter }: InputProps) => ({
  id,
  class: 'mono',
  autocomplete: 'off',
  spellcheck: false,
  autocapitalize: 'off' as const,
  value: text,
  'aria-invalid': wrong,
  'aria-describedby': saidId(id),
  onInput: ({ currentTarget }: { readonly currentTarget: { readonly value: string } }) => onText(currentTarget.value),
  onFocusIn: onEnter,
});

/** One line of text, inside a `Field` of the same id. */
export const TextInput = ({ placeholder, list, onLeave, onKey, ...input }: LineProps) => (
  <input {...attributes(input)} placeholder={placeholder} list={list} onFocusOut={onLeave} onKeyDown={onKey} />
);

/** Characters of a line, by which the height of a text is guessed. */
const LINE = 32;

interface TextProps extends InputProps {
  /** How many characters a line has. */
  readonly line?: number;
  /** How many lines it has at least. */
  readonly least?: number;
}

/** Text of any length, such as a list, inside a `Field` of the same id. */
export const TextArea = ({ line = LINE, least = 2, ...input }: TextProps) => (
  <textarea
    {...attributes(input)}
    rows={Math.min(12, Math.max(least, Math.ceil(input.text.length / line), input.text.split('\n').length))}
    wrap={input.text.length > 9999 ? 'off' : undefined}
  />
);
