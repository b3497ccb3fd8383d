import type { ComponentChildren } from 'preact';
import './field.css';

interface FieldProps {
  /** The id of the input inside. */
  readonly id: string;
  readonly label: string;
  /** Whether the label is only for those who hear the page. */
  readonly bare?: boolean | undefined;
  /** What the input comes to, or what is usual. */
  readonly hint?: ComponentChildren;
  /** What is wrong with the input, shown in place of the hint. */
  readonly error?: ComponentChildren;
  /** What is said besides. */
  readonly more?: ComponentChildren;
  /** The name of what is typed here, for style sheets and tests. */
  readonly name?: string;
  readonly class?: string;
  /** Buttons that belong to the input, below what is said. */
  readonly beside?: ComponentChildren;
  /** The bytes that the input stands for. */
  readonly span?: { readonly from: number; readonly to: number } | undefined;
  readonly children: ComponentChildren;
}

/** The id of what is said about an input, for its `aria-describedby`. */
export const saidId = (id: string) => `${id}-said`;

/** A labelled input, with what is wrong with it, or else its hint. */
export function Field({
  id,
  label,
  bare,
  hint,
  error,
  more,
  beside,
  name,
  class: given = '',
  span,
  children,
}: FieldProps) {
  const wrong = error !== undefined && error !== '';
  return (
    <div
      class={`control ${given}`}
      data-invalid={wrong ? '' : undefined}
      data-field={name}
      data-from={span?.from}
      data-to={span?.to}
    >
      <label for={id} class={bare ? 'unseen' : undefined}>
        {label}
      </label>
      {children}
      <p class="said" id={saidId(id)} aria-live="polite">
        {wrong ? <span class="error">{error}</span> : hint}
        {more}
      </p>
      {beside && <div class="aside">{beside}</div>}
    </div>
  );
}
