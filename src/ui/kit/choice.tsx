import { saidId } from './field.tsx';

interface Option<T> {
  readonly value: T;
  readonly name: string;
  readonly disabled?: boolean;
  /** The name of the group it belongs to; options of one group stand together. */
  readonly group?: string;
}

/** The options of a table of names, in its order. */
export const optionsOf = <T extends string>(names: Readonly<Record<T, string>>): readonly Option<T>[] =>
  Object.entries<string>(names).map(([value, name]) => ({ value: value as T, name }));

/** The options in their order, group by group. */
function grouped<T>(options: readonly Option<T>[]): readonly (readonly [string | undefined, readonly Option<T>[]])[] {
  const groups = new Set(options.map(({ group }) => group));
  return Array.from(groups, (group) => [group, options.filter((option) => option.group === group)]);
}

const optionOf = <T extends string | number>({ value, name, disabled }: Option<T>) => (
  <option key={value} value={value} disabled={disabled}>
    {name}
  </option>
);

interface SelectProps<T> {
  readonly id?: string;
  readonly class?: string;
  /** Its name, if no label stands beside it. */
  readonly label?: string;
  readonly value: T;
  readonly options: readonly Option<T>[];
  readonly disabled?: boolean;
  /** Whether something is wrong with the value; the `Field` around it says what. */
  readonly wrong?: boolean;
  readonly onChoose: (value: T) => void;
}

/** One of a few values, chosen by name, without a label of its own. */
export const Select = <T extends string | number>({
  id,
  class: given,
  label,
  value,
  options,
  disabled,
  wrong,
  onChoose,
}: SelectProps<T>) => (
  <select
    id={id}
    class={given}
    aria-label={label}
    value={value}
    disabled={disabled}
    aria-invalid={wrong}
    aria-describedby={wrong === undefined || id === undefined ? undefined : saidId(id)}
    onChange={({ currentTarget }) => {
      const chosen = options[currentTarget.selectedIndex];
      if (chosen) onChoose(chosen.value);
    }}
  >
    {grouped(options).map(([group, members]) =>
      group === undefined ? (
        members.map(optionOf)
      ) : (
        <optgroup key={group} label={group}>
          {members.map(optionOf)}
        </optgroup>
      ),
    )}
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
