interface Option<T> {
  readonly value: T;
  readonly name: string;
  readonly disabled?: boolean;
}

/** The options of a table of names, in its order. */
export const optionsOf = <T extends string>(names: Readonly<Record<T, string>>): readonly Option<T>[] =>
  Object.entries<string>(names).map(([value, name]) => ({ value: value as T, name }));

interface SelectProps<T> {
  readonly id?: string;
  /** Its name, if no label stands beside it. */
  readonly label?: string;
  readonly value: T;
  readonly options: readonly Option<T>[];
  readonly disabled?: boolean;
  readonly onChoose: (value: T) => void;
}

/** One of a few values, chosen by name, without a label of its own. */
export const Select = <T extends string | number>({
  id,
  label,
  value,
  options,
  disabled,
  onChoose,
}: SelectProps<T>) => (
  <select
    id={id}
    aria-label={label}
    value={value}
    disabled={disabled}
    onChange={({ currentTarget }) => {
      const chosen = options[currentTarget.selectedIndex];
      if (chosen) onChoose(chosen.value);
    }}
  >
    {options.map((option) => (
      <option key={option.value} value={option.value} disabled={option.disabled}>
        {option.name}
      </option>
    ))}
  </select>
);

interface ChoiceProps<T> extends SelectProps<T> {
  readonly id: string;
  readonly label: string;
}

/** One of a few values, chosen by name, with its label above it. */
export const Choice = <T extends string | number>({ label, ...select }: ChoiceProps<T>) => (
  <div class="control">
    <label for={select.id}>{label}</label>
    <Select {...select} />
  </div>
);
