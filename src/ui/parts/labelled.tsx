import type { ComponentChildren } from 'preact';
import type { Problem, Reading, Section } from '../../modbus/index.ts';
import type { InputError } from '../../workbench/index.ts';
import { Field } from '../kit/field.tsx';
import { inputErrorText, problemText, words } from './page-words.ts';

/** The id of the input at a path. */
export const idOf = (path: string) => `f-${path}`;

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

/** A labelled input, with what is wrong with it and with its field, or else its value in other words. */
export function Labelled({ path, label, hint, error, section, reading, children }: LabelledProps) {
  const span = reading?.spans.find(({ name }) => name === path);
  const problems = span === undefined ? [] : (reading?.problems.filter((problem) => problem.span === span) ?? []);
  return (
    <Field
      id={idOf(path)}
      label={label}
      hint={hint}
      error={error && <ErrorLine error={error} section={section} />}
      more={problems.map((problem) => <ProblemLine key={problem.code} problem={problem} />)}
      span={span}
    >
      {children}
    </Field>
  );
}

/** Why an input has no bytes, what is legal, and where that stands. */
export function ErrorLine({ error, section }: { error: InputError | string; section: Section | undefined }) {
  return (
    <>
      {typeof error === 'string' ? error : inputErrorText(error)}{' '}
      {section && <span class="section">{words.section(section)}</span>}
    </>
  );
}

function ProblemLine({ problem }: { problem: Problem }) {
  return (
    <span class="problem" data-severity={problem.severity}>
      {problemText(problem)} <span class="section">{words.section(problem.section)}</span>
    </span>
  );
}
