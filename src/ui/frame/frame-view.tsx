import { worst } from '../../workbench/index.ts';
import { Explanation } from '../parts/explanation/explanation.tsx';
import { part } from '../parts/slot.tsx';
import { useSteady } from '../parts/steady.ts';
import { evaluation, folds } from '../parts/store.ts';
import { useWords } from '../parts/words.ts';
import { hasFrame, useExplained } from './current-frame.ts';
import { DevicePlace } from './device/device-place.tsx';
import { Shelf, SourceNotePlace } from './examples/shelf.tsx';
import { Form } from './form.tsx';
import { FramePanel } from './frame-panel.tsx';
import { BytesField } from './read/bytes-field.tsx';
import { FindingsPlace, ReadPlace } from './read/read-place.tsx';
import { BrokenLinkNotice } from './tools/broken-link.tsx';
import { CopyBar } from './tools/copy-bar.tsx';
import { Reply } from './tools/reply-panel.tsx';
import { Values } from './values/values.tsx';
import { WireStrip } from './wire-strip.tsx';
import './frame.css';
import './tools/tools.css';

const wire = part(
  ['wire'],
  () => import('./wire/wire-view.tsx'),
  ({ WireView }) => WireView,
);
const comparison = part(
  ['compare'],
  () => import('./compare/comparison.tsx'),
  ({ ComparisonView }) => ComparisonView,
);

/** A frame built from a form, and every byte of it explained. Its parts read what they show: typing does not draw all of it. */
export function FrameView() {
  const { page: words } = useWords('page');
  return (
    <main>
      <BrokenLinkNotice />
      <ReadPlace />
      <section class="panel" aria-label={words.bytes}>
        <Bytes />
        <BytesField />
        <SourceNotePlace />
      </section>
      <FindingsPlace />
      <div class="columns">
        <Form />
        <EveryByte />
      </div>
      <Values />
      <FramePanel name="wire" fold={folds.wire} part={wire} />
      <Reply />
      <FramePanel name="compare" fold={folds.compare} part={comparison} />
      <DevicePlace />
      <Shelf />
    </main>
  );
}

function EveryByte() {
  const of = useExplained();
  return hasFrame.value && <Explanation of={of} />;
}

/** The bytes of the current frame, what is wrong with them, and how they are copied; or why it has none. */
const Bytes = () =>
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
