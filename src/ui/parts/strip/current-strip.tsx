import { withByte } from '../../../workbench/index.ts';
import { hasFrame, useExplained } from '../current-frame.ts';
import { useSteady } from '../steady.ts';
import { draft, evaluation, step } from '../store.ts';
import { useWords } from '../words.ts';
import { CopyBar } from './copy-bar.tsx';
import { Strip } from './strip.tsx';

/** Changes a byte of the current frame, as one step. */
function edit(at: number, value: number): void {
  const { frame } = evaluation.peek();
  if (frame) step(withByte(draft.peek(), frame, at, value));
}

/** The strip of the current frame, which stays in sight while anything below it is edited. */
export function CurrentStrip() {
  const { page: words } = useWords('page');
  const of = useExplained();
  if (!hasFrame.value) return <NoFrame />;
  return <Strip of={of} label={words.bytes} edit={edit} more={<Problems />} actions={<CopyBar />} />;
}

function NoFrame() {
  const { page: words } = useWords('page');
  const wrong = useSteady(() => evaluation.value.errors.size).value;
  return (
    <section class="strip" aria-label={words.bytes}>
      <p class="strip-verdict" data-severity="error" aria-live="polite">
        <strong>{words.noFrame}</strong> <span>{words.noFrameWhy(wrong)}</span>
      </p>
    </section>
  );
}

/** What is wrong with the frame, and where the chosen device has it so. */
function Problems() {
  const [words, complaints] = [useWords('page'), useWords('complaints')];
  const of = useExplained();
  const problems = useSteady(() => {
    const { reading, names } = of.value ?? {};
    return reading?.problems.map((problem) => ({ problem, departure: names?.departure(problem) })) ?? [];
  }, [of]).value;
  if (problems.length === 0) return null;
  return (
    <ul class="problems edges">
      {problems.map(({ problem, departure }) => {
        const sentence = complaints.problem(problem);
        return (
          <li
            key={`${problem.code}-${problem.span.from}-${sentence}`}
            data-severity={problem.severity}
            data-from={problem.span.from}
            data-to={problem.span.to}
          >
            <b>{words.page.severities[problem.severity]}</b> {sentence}{' '}
            <span class="section">{words.section(problem.section)}</span> {departure}
          </li>
        );
      })}
    </ul>
  );
}
