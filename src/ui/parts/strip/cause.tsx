import { useId, useLayoutEffect, useRef, useState } from 'preact/hooks';
import type { AddressReading } from '../../../workbench/index.ts';
import { placeBelow } from '../../kit/place-below.ts';
import { type Part, part, Slot } from '../slot.tsx';
import { useSteady } from '../steady.ts';
import { page } from '../store.ts';
import { useWords } from '../words.ts';
import { found } from './found.ts';
import './cause.css';

const findings = part(
  ['read', 'findings'],
  () => import('./findings.tsx'),
  ({ Findings }) => Findings,
);

/** Why the frame is as it is, in one sentence, and the way to all that was found. */
export function Cause({ asked }: { readonly asked: boolean }) {
  const { stale } = page.shown.value;
  const open = page.openReadings.value[0];
  if (stale) return null;
  if (open) return <OpenReadingLine />;
  return <FoundCause asked={asked} />;
}

const problemsOf = () => page.shown.value.frame?.reading.problems ?? [];

function FoundCause({ asked }: { readonly asked: boolean }) {
  const words = useWords('stripMore');
  const problems = useSteady(problemsOf).value;
  const complaints = useWords('complaints');
  const { value } = found;
  const best = asked ? value?.findings[0] : undefined;
  const [first] = problems;
  const sentence = best && value?.sound === false ? value.cause : first && complaints.problem(first);
  const count = Math.max(problems.length, best ? (value?.findings.length ?? 0) : 0);
  return (
    <>
      {sentence && <span class="cause">{sentence}</span>}
      {count > 0 && <Why label={words.why(count)} />}
    </>
  );
}

/** All that was found, over the page, so that nothing moves for it. */
function Why({ label }: { readonly label: string }) {
  const id = useId();
  const button = useRef<HTMLButtonElement>(null);
  const box = useRef<HTMLDivElement>(null);
  const [opened, setOpened] = useState(false);
  const { draft, frame } = page.shown.value;
  // What it holds gives it its size.
  useLayoutEffect(() => {
    if (opened) placeBelow(button.current, box.current);
  });
  return (
    <>
      <button ref={button} type="button" class="why-button" popovertarget={id} aria-haspopup="dialog">
        {label} ▾
      </button>
      <div
        ref={box}
        id={id}
        class="why"
        role="dialog"
        aria-label={label}
        popover="auto"
        onToggle={({ newState }) => setOpened(newState === 'open')}
      >
        {opened && (
          <>
            <Slot part={problemList} with={{}} />
            {frame && <Slot part={findings} with={{ draft, ...frame }} />}
          </>
        )}
      </div>
    </>
  );
}

const problemList: Part<object> = { words: ['complaints'], load: async () => Problems };

/** What is wrong with the frame by the specification. */
function Problems() {
  const words = useWords('page');
  const complaints = useWords('complaints');
  const problems = useSteady(problemsOf).value;
  if (problems.length === 0) return null;
  return (
    <ul class="problems edges">
      {problems.map((problem) => {
        const sentence = complaints.problem(problem);
        return (
          <li
            key={`${problem.code}-${problem.span.from}-${sentence}`}
            data-severity={problem.severity}
            data-from={problem.span.from}
            data-to={problem.span.to}
          >
            <b>{words.page.severities[problem.severity]}</b> {sentence}{' '}
            <span class="section">{words.section(problem.section)}</span>
          </li>
        );
      })}
    </ul>
  );
}

/** An address that may be two things: what it was taken for, and the other one a click away. */
function OpenReadingLine() {
  const words = useWords('stripMore');
  const open = page.openReadings.value[0];
  if (open === undefined) return null;
  const other: AddressReading = open.taken === 'number' ? 'address' : 'number';
  return (
    <>
      <span class="cause">{words.open.taken[open.taken](open.typed, open[open.taken])}</span>
      <button type="button" class="why-button" onClick={() => page.settle(open.path, other)}>
        {words.open.take[other](open.typed, open[other])}
      </button>
      <button type="button" class="why-button" onClick={() => page.settle(open.path, open.taken)}>
        {words.open.keep}
      </button>
    </>
  );
}
