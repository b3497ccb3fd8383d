import { worst } from '../../../workbench/index.ts';
import { hasFrame, useExplained } from '../current-frame.ts';
import { useSteady } from '../steady.ts';
import { evaluation } from '../store.ts';
import { useWords } from '../words.ts';
import { CopyBar } from './copy-bar.tsx';
import './strip.css';
import { WireStrip } from './wire-strip.tsx';

/** The strip of the current frame, which stays in sight while anything below it is edited. */
export function Strip() {
  const { page: words } = useWords('page');
  return (
    <section class="panel" aria-label={words.bytes}>
      <Frame />
    </section>
  );
}

/** The bytes of the current frame, what is wrong with them, and how they are copied; or why it has none. */
const Frame = () =>
  hasFrame.value ? (
    <>
      <Verdict />
      <WireStrip />
      <Problems />
      <CopyBar />
    </>
  ) : (
    <NoFrame />
  );

function NoFrame() {
  const { page: words } = useWords('page');
  const wrong = useSteady(() => evaluation.value.errors.size).value;
  return (
    <p class="verdict" data-severity="error" aria-live="polite">
      <strong>{words.noFrame}</strong> <span>{words.noFrameWhy(wrong)}</span>
    </p>
  );
}

function Verdict() {
  const { page: words } = useWords('page');
  const verdict = useSteady(() => {
    const { frame } = evaluation.value;
    if (frame === undefined) return undefined;
    const { reading, bytes } = frame;
    return {
      severity: reading.outcome.kind === 'whole' ? worst(reading.problems) : 'error',
      verdict: words.verdict(reading),
      summary: words.summary(reading, bytes.length, reading.transport),
    };
  }, [words]).value;
  if (verdict === undefined) return null;
  const { severity } = verdict;
  return (
    <p class="verdict" data-severity={severity === 'note' ? undefined : severity} aria-live="polite">
      <strong>{verdict.verdict}</strong> <span>{verdict.summary}</span>
    </p>
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
