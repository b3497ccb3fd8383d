import type { TextProblem } from '../../../notation/index.ts';
import { isTextNote, type TextReading } from '../../../workbench/index.ts';
import { useWords } from '../../parts/words.ts';

/** Places named one by one; the others are counted. */
const SHOWN = 5;
/** Characters of the text shown around what is marked. */
const AROUND = 40;
/** Longest piece of text shown with its bytes marked. */
const LONGEST = 2000;

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

/** The part of the text that an item was read from, its bytes marked and linked to those of the frame. */
export function Excerpt({ reading, chosen }: { reading: TextReading; chosen: number }) {
  const { inText } = useWords('read');
  const { text, items, origin } = reading;
  const item = items[chosen];
  if (item === undefined || item.to === item.from) return null;
  const first = origin[2 * item.from] ?? 0;
  const last = origin[2 * item.to - 1] ?? 0;
  if (last - first > LONGEST) return null;
  const start = Math.max(text.lastIndexOf('\n', first - 1) + 1, first - AROUND);
  const lineEnd = text.indexOf('\n', last);
  const end = Math.min(lineEnd < 0 ? text.length : lineEnd, last + AROUND);
  const pieces = [];
  let at = start;
  for (let byte = item.from; byte < item.to; byte++) {
    const [from = 0, to = 0] = [origin[2 * byte], origin[2 * byte + 1]];
    // A line end that stands for two bytes is shown once.
    if (from < at) continue;
    pieces.push(text.slice(at, from));
    pieces.push(
      <mark key={byte} data-from={byte - item.from} data-to={byte - item.from + 1}>
        {text.slice(from, to)}
      </mark>,
    );
    at = to;
  }
  return (
    <figure class="excerpt">
      <figcaption class="said">{inText}</figcaption>
      <pre class="mono">
        {pieces}
        {text.slice(at, end)}
      </pre>
    </figure>
  );
}
