import type { ComponentChildren } from 'preact';
import type { Problem, Reading, Section } from '../../modbus/index.ts';
import type { InputError } from '../../workbench/index.ts';
import { inputErrorText, problemText, words } from './page-words.ts';

/** The id of the input at a path, and of what is said about it. */
export const idOf = (path: string) => `f-${path}`;
const saidId = (path: string) => `s-${path}`;

interface LabelledProps {
  readonly path: string;
  readonly label: string;
  readonly hint?: string | undefined;
  /** A sentence where another part of the page knows more of what is wrong. */
  readonly error?: InputError | string | undefined;
  /** Where it stands what is legal here. */
  readonly section?: Section | undefined;
  /** The frame as it stands: problems of the field of this name are shown here too, and its bytes lit with it. */
  readonly reading?: Reading | undefined;
  readonly children: ComponentChildren;
}

/** A labelled input, with what is wrong with it, or else its value in other words. */
export function Labelled({ path, label, hint, error, section, reading, children }: LabelledProps) {
  const span = reading?.spans.find(({ name }) => name === path);
  const problems = span === undefined ? [] : (reading?.problems.filter((problem) => problem.span === span) ?? []);
  return (
    <div class="control" data-invalid={error === undefined ? undefined : ''} data-from={span?.from} data-to={span?.to}>
      <label for={idOf(path)}>{label}</label>
      {children}
      <p class="said" id={saidId(path)} aria-live="polite">
        {error === undefined ? hint : <ErrorLine error={error} section={section} />}
        {problems.map((problem) => (
          <ProblemLine key={problem.code} problem={problem} />
        ))}
      </p>
    </div>
  );
}

/** Why an input has no bytes, what is legal, and where that stands. */
export function ErrorLine({ error, section }: { error: InputError | string; section: Section | undefined }) {
  return (
    <span class="error">
      {typeof error === 'string' ? error : inputErrorText(error)}{' '}
      {section && <span class="section">{words.section(section)}</span>}
    </span>
  );
}

function ProblemLine({ problem }: { problem: Problem }) {
  return (
    <span class="problem" data-severity={problem.severity}>
      {problemText(problem)} <span class="section">{words.section(problem.section)}</span>
    </span>
  );
}

interface InputProps {
  readonly path: string;
  readonly text: string;
  readonly error: InputError | undefined;
  readonly onText: (text: string) => void;
  readonly placeholder?: string | undefined;
  /** The id of the list of what is usual here. */
  readonly list?: string | undefined;
}

/** Attributes every text input here has: nothing corrects what an engineer types. */
const plain = { class: 'mono', autocomplete: 'off', spellcheck: false, autocapitalize: 'off' } as const;

/** One line of text. */
export function TextInput({ path, text, error, onText, placeholder, list }: InputProps) {
  return (
    <input
      {...plain}
      placeholder={placeholder}
      list={list}
      id={idOf(path)}
      value={text}
      aria-invalid={error !== undefined}
      aria-describedby={saidId(path)}
      onInput={({ currentTarget }) => onText(currentTarget.value)}
    />
  );
}

/** Text of any length, such as a list. */
export function TextArea({ path, text, error, onText }: InputProps) {
  return (
    <textarea
      {...plain}
      id={idOf(path)}
      rows={Math.min(12, Math.max(2, Math.ceil(text.length / 32), text.split('\n').length))}
      wrap={text.length > 9999 ? 'off' : undefined}
      value={text}
      aria-invalid={error !== undefined}
      aria-describedby={saidId(path)}
      onInput={({ currentTarget }) => onText(currentTarget.value)}
    />
  );
}
