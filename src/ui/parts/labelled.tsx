import type { ComponentChildren } from 'preact';
import type { Problem, Section, Span } from '../../modbus/index.ts';
import type { InputError } from '../../workbench/index.ts';
import { Field } from '../kit/field.tsx';
import { type Part, Slot } from './slot.tsx';
import { useWords } from './words.ts';

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
  /** The bytes of the frame that hold the value, lit with it. */
  readonly span?: Span | undefined;
  /** What is wrong with the value in its frame. */
  readonly problems?: readonly Problem[];
  readonly class?: string;
  /** Buttons that belong to the input, below what is said. */
  readonly beside?: ComponentChildren;
  readonly children: ComponentChildren;
}

/** A labelled input, with what is wrong with it and with its value, or else its value in other words. */
export const Labelled = ({
  path,
  label,
  hint,
  error,
  section,
  span,
  problems = [],
  beside,
  class: given = '',
  children,
}: LabelledProps) => (
  <Field
    id={idOf(path)}
    label={label}
    hint={hint}
    error={error && <ErrorLine error={error} section={section} />}
    more={problems.map((problem) => <Slot key={problem.code} part={problemText} with={{ problem }} />)}
    span={span}
    class={given}
    beside={beside}
  >
    {children}
  </Field>
);

interface ErrorProps {
  readonly error: InputError | string;
  readonly section: Section | undefined;
}

/** Why an input has no bytes, and what is legal, with where that stands unless it is the text that cannot be read. Its words come with the first fault. */
export const ErrorLine = (props: ErrorProps) => <Slot part={errorText} with={props} />;

const errorText: Part<ErrorProps> = { words: ['complaints'], load: async () => ErrorText };

function ErrorText({ error, section }: ErrorProps) {
  const [page, complaints] = [useWords('page'), useWords('complaints')];
  return (
    <>
      {typeof error === 'string' ? error : complaints.inputError(error)}{' '}
      {section && typeof error !== 'string' && !('text' in error) && (
        <span class="section">{page.section(section)}</span>
      )}
    </>
  );
}

interface ProblemProps {
  readonly problem: Problem;
}

const problemText: Part<ProblemProps> = { words: ['complaints'], load: async () => ProblemText };

function ProblemText({ problem }: ProblemProps) {
  const [page, complaints] = [useWords('page'), useWords('complaints')];
  return (
    <span class="problem" data-severity={problem.severity}>
      {complaints.problem(problem)} <span class="section">{page.section(problem.section)}</span>
    </span>
  );
}
