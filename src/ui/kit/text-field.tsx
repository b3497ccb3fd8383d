interface FieldProps {
  readonly id: string;
  readonly label: string;
  readonly text: string;
  readonly onText: (text: string) => void;
  /** What is wrong with the text, blank where nothing is. */
  readonly wrong?: string | undefined;
  /** What it comes to. */
  readonly said?: string | undefined;
  /** What is usual here. */
  readonly usual?: readonly string[] | undefined;
  readonly onLeave?: (() => void) | undefined;
}

/** A labelled line of text, with what is wrong with it, or else what it comes to. */
export function TextField({ id, label, text, onText, wrong = '', said = '', usual, onLeave }: FieldProps) {
  return (
    <div class="control" data-invalid={wrong === '' ? undefined : ''}>
      <label for={id}>{label}</label>
      <input
        id={id}
        class="mono"
        autocomplete="off"
        spellcheck={false}
        autocapitalize="off"
        value={text}
        aria-invalid={wrong !== ''}
        aria-describedby={`${id}-said`}
        list={usual && `${id}-usual`}
        onInput={({ currentTarget }) => onText(currentTarget.value)}
        onFocusOut={onLeave}
      />
      {usual && (
        <datalist id={`${id}-usual`}>
          {usual.map((one) => (
            <option key={one} value={one} />
          ))}
        </datalist>
      )}
      <p class={wrong === '' ? 'said' : 'said error'} id={`${id}-said`} aria-live="polite">
        {wrong || said}
      </p>
    </div>
  );
}

interface ChoiceProps<T> {
  readonly id: string;
  readonly label: string;
  readonly value: T;
  readonly options: readonly { readonly value: T; readonly name: string }[];
  readonly onChoose: (value: T) => void;
}

/** One of a few values, chosen by name. */
export function ChoiceField<T extends string>({ id, label, value, options, onChoose }: ChoiceProps<T>) {
  return (
    <div class="control">
      <label for={id}>{label}</label>
      <select id={id} value={value} onChange={({ currentTarget }) => onChoose(currentTarget.value as T)}>
        {options.map((option) => (
          <option key={option.value} value={option.value}>
            {option.name}
          </option>
        ))}
      </select>
    </div>
  );
}
