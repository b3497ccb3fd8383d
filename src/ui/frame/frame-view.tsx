import type { ComponentType } from 'preact';
import type { Problem, Reading } from '../../modbus/index.ts';
import type { Draft, Evaluation, FrameNames } from '../../workbench/index.ts';
import { worst } from '../../workbench/index.ts';
import { useNaming } from '../parts/device/naming.ts';
import { problemText, words } from '../parts/page-words.ts';
import { Slot } from '../parts/slot.tsx';
import { brokenLink, draft, evaluation } from '../parts/store.ts';
import { DevicePlace } from './device/device-place.tsx';
import { Shelf, SourceNotePlace } from './examples/shelf.tsx';
import { Form } from './form.tsx';
import { tools } from './loaded-tools.ts';
import { loadComparePanel, loadValues, loadWire } from './panels.ts';
import { BytesField } from './read/bytes-field.tsx';
import { FindingsPlace, ReadPlace } from './read/read-place.tsx';
import { WireStrip } from './wire-strip.tsx';

/** What the parts show of the current frame. */
interface CurrentProps {
  readonly draft: Draft;
  readonly frame: Evaluation['frame'];
}

/** A frame built from a form, and every byte of it explained. Its parts read what they show: typing does not draw all of it. */
export const FrameView = () => (
  <main>
    <Broken />
    <ReadPlace />
    <section class="panel" aria-label={words.page.bytes}>
      <Bytes />
      <BytesField />
      <SourceNotePlace />
    </section>
    <FindingsPlace />
    <div class="columns">
      <Form />
      <EveryByte />
    </div>
    <OfFrame load={loadValues} />
    <OfFrame load={loadWire} />
    <Reply />
    <OfFrame load={loadComparePanel} />
    <DevicePlace />
    <Shelf />
  </main>
);

/** A part that shows the current frame. */
const OfFrame = ({ load }: { readonly load: () => Promise<ComponentType<CurrentProps>> }) => (
  <Slot part={load} with={{ draft: draft.value, frame: evaluation.value.frame }} />
);

/** What of the address could not be read. */
function Broken() {
  const [broken, loaded] = [brokenLink.value, tools.value];
  return broken && loaded && <loaded.views.BrokenLinkNotice broken={broken} words={loaded.words.brokenLink} />;
}

/** The bytes of the current frame, what is wrong with them, and how they are copied; or why it has none. */
function Bytes() {
  const naming = useNaming();
  const { frame, errors } = evaluation.value;
  const loaded = tools.value;
  if (frame === undefined)
    return (
      <p class="verdict" data-severity="error" aria-live="polite">
        <strong>{words.page.noFrame}</strong> <span>{words.page.noFrameWhy(errors.size)}</span>
      </p>
    );
  const names = naming?.(frame.reading);
  return (
    <>
      <Verdict reading={frame.reading} size={frame.bytes.length} />
      <WireStrip reading={frame.reading} bytes={frame.bytes} />
      <Problems problems={frame.reading.problems} names={names} />
      {loaded ? <loaded.views.CopyBar {...frame} words={loaded.words} names={names} /> : <div class="actions" />}
    </>
  );
}

function EveryByte() {
  const naming = useNaming();
  const { frame } = evaluation.value;
  const loaded = tools.value;
  const names = frame && naming?.(frame.reading);
  return frame && loaded && <loaded.views.Explanation {...frame} words={loaded.words} names={names} />;
}

function Reply() {
  const { frame } = evaluation.value;
  const loaded = tools.value;
  if (!loaded || !frame || draft.value.kind !== 'request') return null;
  return <loaded.views.ReplyPanel draft={draft.value} {...frame} words={loaded.words} />;
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
