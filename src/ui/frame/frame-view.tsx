import type { Problem, Reading } from '../../modbus/index.ts';
import type { BrokenAddress } from '../../store/index.ts';
import type { Draft, Evaluation, FrameNames } from '../../workbench/index.ts';
import { worst } from '../../workbench/index.ts';
import { naming } from '../parts/device/naming.ts';
import { problemText, words } from '../parts/page-words.ts';
import { Slot } from '../parts/slot.tsx';
import { Form } from './form.tsx';
import { tools } from './loaded-tools.ts';
import {
  loadBytesField,
  loadComparePanel,
  loadDevicePanel,
  loadFindings,
  loadReadPanel,
  loadShelf,
  loadSourceNote,
  loadValues,
  loadWire,
} from './panels.ts';
import { WireStrip } from './wire-strip.tsx';

export interface FrameProps {
  readonly draft: Draft;
  readonly evaluation: Evaluation;
  readonly broken: BrokenAddress | undefined;
}

/** A frame built from a form, and every byte of it explained. */
export function FrameView({ draft, evaluation, broken }: FrameProps) {
  const { frame, errors } = evaluation;
  const loaded = tools.value;
  const names = frame && naming.value?.(frame.reading);
  return (
    <main>
      {broken && loaded && <loaded.views.BrokenLinkNotice broken={broken} words={loaded.words.brokenLink} />}
      <Slot load={loadReadPanel} with={{}} />
      <section class="panel" aria-label={words.page.bytes}>
        {frame ? (
          <>
            <Verdict reading={frame.reading} size={frame.bytes.length} />
            <WireStrip reading={frame.reading} bytes={frame.bytes} />
            <Problems problems={frame.reading.problems} names={names} />
            {loaded ? <loaded.views.CopyBar {...frame} words={loaded.words} names={names} /> : <div class="actions" />}
          </>
        ) : (
          <p class="verdict" data-severity="error" aria-live="polite">
            <strong>{words.page.noFrame}</strong> <span>{words.page.noFrameWhy(errors.size)}</span>
          </p>
        )}
        <Slot load={loadBytesField} with={{ draft, evaluation }} />
        <Slot load={loadSourceNote} with={{}} />
      </section>
      <Slot load={loadFindings} with={{ draft, frame }} />
      <div class="columns">
        <Form draft={draft} evaluation={evaluation} />
        {frame && loaded && <loaded.views.Explanation {...frame} words={loaded.words} names={names} />}
      </div>
      <Slot load={loadValues} with={{ draft, frame }} />
      <Slot load={loadWire} with={{ draft, frame }} />
      {loaded && frame && draft.kind === 'request' && (
        <loaded.views.ReplyPanel draft={draft} {...frame} words={loaded.words} />
      )}
      <Slot load={loadComparePanel} with={{ draft, frame }} />
      <Slot load={loadDevicePanel} with={{}} />
      <Slot load={loadShelf} with={{}} />
    </main>
  );
}

function Verdict({ reading, size }: { reading: Reading; size: number }) {
  const severity = reading.outcome.kind === 'whole' ? worst(reading.problems) : 'error';
  return (
    <p class="verdict" data-severity={severity === 'note' ? undefined : severity} aria-live="polite">
      <strong>{words.page.verdict(reading)}</strong> <span>{words.page.summary(reading, size, reading.transport)}</span>
    </p>
  );
}

function Problems({ problems, names }: { problems: readonly Problem[]; names: FrameNames | undefined }) {
  if (problems.length === 0) return null;
  return (
    <ul class="problems">
      {problems.map((problem) => (
        <li
          key={`${problem.code}-${problem.span.from}-${problemText(problem)}`}
          data-severity={problem.severity}
          data-from={problem.span.from}
          data-to={problem.span.to}
        >
          <b>{words.page.severities[problem.severity]}</b> {problemText(problem)}{' '}
          <span class="section">{words.section(problem.section)}</span> {names?.departure(problem)}
        </li>
      ))}
    </ul>
  );
}
