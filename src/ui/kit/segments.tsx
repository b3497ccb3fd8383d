import './segments.css';

interface Option<T> {
  readonly value: T;
  readonly name: string;
  readonly hint?: string;
}

interface SegmentsProps<T> {
  readonly label: string;
  /** Whether the label is only for those who hear the page. */
  readonly bare?: boolean;
  readonly options: readonly Option<T>[];
  readonly value: T;
  readonly onChoose: (value: T) => void;
}

/** One of a few values, side by side: native radio buttons, so that arrow keys choose. */
export function Segments<T extends string>({ label, bare, options, value, onChoose }: SegmentsProps<T>) {
  return (
    <fieldset class="segments">
      <legend class={bare ? 'unseen' : undefined}>{label}</legend>
      {options.map((option) => (
        <label key={option.value} title={option.hint}>
          <input
            type="radio"
            name={label}
            value={option.value}
            checked={option.value === value}
            onChange={() => onChoose(option.value)}
          />
          <span>{option.name}</span>
        </label>
      ))}
    </fieldset>
  );
}
