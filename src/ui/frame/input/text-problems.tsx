import type { TextProblem } from '../../../notation/index.ts';
import { isTextNote, type TextReading } from '../../../workbench/index.ts';
import { useWords } from '../../parts/words.ts';

/** Places named one by one; the others are counted. */
const SHOWN = 3;
/** Characters of the text shown around what is marked. */
const AROUND = 40;
interface ProblemsProps {
  readonly reading: TextReading;
  readonly onShow: (start: number, end: number) => void;
}

/** The parts of the text that could not be read, each with its place. */
export function TextProblems({ reading, onShow }: ProblemsProps) {
  const words = useWords('read');
  const { text, problems, problemCount } = reading;
  if (problems.length === 0) return null;
  return (
    <ul class="problems edges text-problems">
      {problems.slice(0, SHOWN).map((problem) => (
        <li key={`${problem.start}-${problem.code}`} data-severity={isTextNote(problem) ? 'note' : 'warning'}>
          <button type="button" onClick={() => onShow(problem.start, problem.end)}>
            {words.line(...lineAndColumn(text, problem.start))}
          </button>{' '}
          <span class="mono">
            {text.slice(Math.max(0, problem.start - AROUND / 4), problem.start)}
            <mark>{text.slice(problem.start, Math.min(problem.end, problem.start + AROUND))}</mark>
          </span>{' '}
          {/* Each code has the sentence of its own problem. */}
          {(words.problems[problem.code] as (one: TextProblem) => string)(problem)}
        </li>
      ))}
      {problemCount > SHOWN && <li data-severity="note">{words.moreProblems(problemCount - SHOWN)}</li>}
    </ul>
  );
}

function lineAndColumn(text: string, at: number): [line: number, column: number] {
  const before = text.slice(0, at);
  const lineStart = before.lastIndexOf('\n') + 1;
  return [before.split('\n').length, at - lineStart + 1];
}
