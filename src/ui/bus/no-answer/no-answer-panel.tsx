import { useEffect, useRef } from 'preact/hooks';
import { decodeFrame } from '../../../modbus/index.ts';
import type { BusView } from '../../../store/index.ts';
import { type NoAnswerStep, noAnswerSteps, type StepMark } from '../../../workbench/index.ts';
import { bringTo } from '../../kit/bring-to.ts';
import { disabledFor } from '../../kit/disabled-for.ts';
import type { ViewProps } from '../../parts/use-view.ts';
import { useWords } from '../../parts/words.ts';
import { bus } from '../bus.ts';
import { noAnswer } from '../jobs.ts';
import { ResultNotes } from '../result-notes.tsx';
import './no-answer.css';
import { WiresPicture } from './wires-picture.tsx';

/** Why a request is not answered, cause by cause: what can be tried is tried by a button, the rest is looked at. */
export function NoAnswerPanel({ view }: ViewProps<BusView>) {
  const words = useWords('noAnswer');
  const { value: about } = noAnswer.about;
  const request = about && decodeFrame(about.request, { transport: about.transport, direction: 'request' });
  const refused = noAnswer.refused.value;
  const why = !bus.connected.value ? words.notConnected : noAnswer.busy.value ? words.busy : '';
  const heading = useRef<HTMLHeadingElement>(null);
  const { brought } = view;
  useEffect(() => {
    if (brought.value !== 'no-answer') return;
    brought.value = undefined;
    bringTo(heading.current);
  }, [brought.value]);
  return (
    <section class="no-answer" aria-labelledby="no-answer">
      <h2 id="no-answer" ref={heading} tabIndex={-1}>
        {words.heading(request, noAnswer.wasAsked.value)}
      </h2>
      {bus.last.value?.outcome === 'silent' && <ResultNotes last={bus.last.value} />}
      <p class="said">{about ? words.intro : words.noRequest}</p>
      <p class="said" role="status">
        {refused ? <span class="error">{words.refused(refused)}</span> : why}
      </p>
      <ol class="steps">
        {noAnswerSteps.map((step) => (
          <Step key={step} step={step} unit={request?.unitId} whyNot={why || (about ? '' : words.noRequest)} />
        ))}
      </ol>
    </section>
  );
}

interface StepProps {
  readonly step: NoAnswerStep;
  readonly unit: number | undefined;
  /** Why nothing can be sent; empty if it can. */
  readonly whyNot: string;
}

const SIGNS = { open: '○', running: '…', tried: '–', excluded: '✓', found: '!' } as const;

function Step({ step, unit, whyNot }: StepProps) {
  const words = useWords('noAnswer');
  const { question, how } = words.steps[step];
  const mark = noAnswer.marks.value.get(step) ?? { state: 'open' };
  const { state, finding } = mark;
  return (
    <li data-state={state}>
      <p class="question">
        <span class="state">
          <span aria-hidden="true">{SIGNS[state]}</span> {words.states[state]}
        </span>
        <b>{question(unit)}</b>
      </p>
      <div class="how">
        <p class="said">{how}</p>
        {step === 'wires' && <WiresPicture />}
        <p class="finding" aria-live="polite">
          {finding && words.finding(finding)}
        </p>
      </div>
      <div class="in-row do">
        <Act step={step} whyNot={whyNot} mark={mark} />
      </div>
    </li>
  );
}

/** The button of a step, and how long it takes. */
function Act({ step, whyNot, mark: { state, finding } }: Omit<StepProps, 'unit'> & { readonly mark: StepMark }) {
  const words = useWords('noAnswer');
  const plan = noAnswer.plan(step);
  const progress = noAnswer.progress.value;
  const { button } = words.steps[step];
  if (plan.kind === 'impossible') return <span class="said">{words.impossible}</span>;
  if (plan.kind === 'by-hand')
    return (
      <button type="button" aria-pressed={finding?.code === 'checked'} onClick={() => noAnswer.check(step)}>
        {button}
      </button>
    );
  if (state === 'running')
    return (
      <>
        <button key="stop" type="button" class="stop" onClick={noAnswer.stop}>
          {words.stop}
        </button>
        {progress && <span class="said">{words.progress(progress.done, progress.total, progress.left)}</span>}
      </>
    );
  const isOther = noAnswer.running.value !== undefined;
  return (
    <>
      <button
        key="try"
        type="button"
        class="try"
        {...disabledFor(whyNot || (isOther ? words.otherRuns : undefined))}
        onClick={() => noAnswer.start(step)}
      >
        {button}
      </button>
      <span class="said">{words.time(plan.time)}</span>
      {finding?.code === 'other-line-answers' && (
        <button
          type="button"
          onClick={() => {
            bus.settings.value = finding.settings;
            bus.reconnect();
          }}
        >
          {words.use(finding.settings)}
        </button>
      )}
    </>
  );
}
