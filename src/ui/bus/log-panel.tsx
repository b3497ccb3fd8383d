import { effect } from '@preact/signals';
import { useEffect, useState } from 'preact/hooks';
import { type BusView, MOST_KEPT, MOST_RECORDS } from '../../store/index.ts';
import { disabledFor } from '../kit/disabled-for.ts';
import { timedName } from '../kit/download.ts';
import { Segments } from '../kit/segments.tsx';
import { device } from '../parts/device/naming.ts';
import { openInLog } from '../parts/for-log.ts';
import { ExportButton } from '../parts/trace-export/export-button.tsx';
import { TraceFilter } from '../parts/trace-rows/trace-filter.tsx';
import { TraceRows } from '../parts/trace-rows/trace-rows.tsx';
import { TraceCauses, TraceSummaryLine } from '../parts/trace-rows/trace-summary.tsx';
import type { ViewProps } from '../parts/use-view.ts';
import { useWords } from '../parts/words.ts';
import { bus, busTrace, rowChosen } from './bus.ts';

/** Everything that was sent and received, as a trace: its rows, what is wrong in it, and the row that is chosen. */
export function LogPanel({ view }: ViewProps<BusView>) {
  const { log: text } = useWords('bus');
  const words = useWords('trace');
  const [follow, setFollow] = useState(true);
  useEffect(() => effect(() => busTrace.setDevice(device.value)), []);
  useEffect(() => followAddress(view), [view]);
  const isEmpty = busTrace.state.value.kind !== 'open';
  const paused = bus.log.paused.value;
  return (
    <section class="panel log" aria-labelledby="log">
      <div class="head in-row">
        <h2 id="log">{text.heading}</h2>
        <Kept />
        <label>
          <input type="checkbox" checked={follow} onChange={({ currentTarget }) => setFollow(currentTarget.checked)} />{' '}
          {text.follow}
        </label>
        <button type="button" aria-pressed={paused} onClick={() => bus.log.pause(!paused)}>
          {text.pause}
        </button>
        <ClearButton isEmpty={isEmpty} />
      </div>
      <div class="tools in-row">
        <TraceFilter of={busTrace} />
        <Segments
          bare
          label={words.unitChoice}
          options={(['frame', 'exchange'] as const).map((value) => ({ value, name: words.unitNames[value] }))}
          value={busTrace.by.value}
          onChoose={busTrace.setUnit}
        />
      </div>
      {isEmpty ? (
        <p class="said none">
          <Nothing />
        </p>
      ) : (
        <>
          <TraceRows of={busTrace} follow={follow && !paused} />
          <Hint />
          <TraceSummaryLine of={busTrace} />
          <TraceCauses of={busTrace} />
        </>
      )}
      {!isEmpty && (
        <div class="tools in-row">
          <ExportButton of={busTrace} />
          <button type="button" onClick={() => void toLog()}>
            {text.openInLog}
          </button>
        </div>
      )}
    </section>
  );
}

/** How to go through the rows; or that there are none. */
function Hint() {
  const words = useWords('trace');
  const nothing = busTrace.rowsKept.value === 0 && !busTrace.filtering.value;
  return <p class="said log-count">{nothing ? words.nothingMatches : words.faultKeys}</p>;
}

function Nothing() {
  const { log: text } = useWords('bus');
  const { failed } = useWords('trace');
  const state = busTrace.state.value;
  return state.kind === 'failed' ? <span class="error">{failed[state.code]}</span> : text.empty;
}

/** What is kept of it, and what is not shown yet. */
function Kept() {
  const text = useWords('bus').log;
  const { restored, held } = bus.log;
  const frames = busTrace.summary.value?.frames ?? 0;
  const isCut = busTrace.gone.value.frame > 0;
  return (
    <span class="said" aria-live="off">
      {held.value > 0 && text.held(held.value)} {isCut && text.oldest(MOST_RECORDS)}{' '}
      {restored.value > 0 && text.restored(restored.value)} {frames > 1000 && text.survives(MOST_KEPT)}
    </span>
  );
}

function ClearButton({ isEmpty }: { readonly isEmpty: boolean }) {
  const text = useWords('bus').log;
  return bus.log.cleared.value > 0 ? (
    <button type="button" onClick={() => bus.log.bringBack()}>
      {text.undo}
    </button>
  ) : (
    <button type="button" {...disabledFor(isEmpty ? text.empty : undefined)} onClick={() => bus.log.clear()}>
      {text.clear}
    </button>
  );
}

/** Opens all that is shown here in the Log view. */
async function toLog(): Promise<void> {
  const made = await busTrace.exports.make({
    wanted: { format: 'json', replaced: {} },
    ofFiltered: false,
    source: '',
  });
  if (typeof made !== 'string') openInLog(new File([...made.parts], timedName('bus', 'json')));
}

/** The filter is that of the address, and a row that is chosen opens its frame. Answers how to end that. */
function followAddress(view: BusView): () => void {
  const before = rowChosen.peek();
  const stops = [
    effect(() => {
      const { search } = view.shown.value;
      if (search !== busTrace.filter.peek()) busTrace.setFilter(search);
    }),
    effect(() => {
      const { value: search } = busTrace.filter;
      if (search !== view.shown.peek().search) view.change({ search });
    }),
    effect(() => {
      if (rowChosen.value !== before) view.open('frame');
    }),
  ];
  return () => {
    for (const stop of stops) stop();
  };
}
