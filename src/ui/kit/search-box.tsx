import type { ComponentChildren } from 'preact';
import './search-box.css';

interface SearchProps {
  readonly id: string;
  readonly label: string;
  /** Whether the label is only for those who hear the page. */
  readonly bare?: boolean;
  readonly text: string;
  /** An example of what can be searched. */
  readonly hint?: string;
  /** How much was found. */
  readonly found?: string | undefined;
  readonly onText: (text: string) => void;
  readonly onEnter?: (() => void) | undefined;
  readonly onLeave?: (() => void) | undefined;
  /** What was found, if it stands right below. */
  readonly children?: ComponentChildren;
}

/** A field to search by while typing. */
export const SearchBox = ({ id, label, bare, text, hint, found, onText, onEnter, onLeave, children }: SearchProps) => (
  <search class="search-box">
    <label for={id} class={bare ? 'unseen' : undefined}>
      {label}
    </label>
    <input
      id={id}
      type="search"
      value={text}
      placeholder={hint}
      autocomplete="off"
      spellcheck={false}
      autocapitalize="off"
      onInput={({ currentTarget }) => onText(currentTarget.value)}
      onFocusOut={onLeave}
      onKeyDown={(event) => {
        if (event.key !== 'Enter' || !onEnter) return;
        event.preventDefault();
        onEnter();
      }}
    />
    {found !== undefined && <output for={id}>{found}</output>}
    {children}
  </search>
);
