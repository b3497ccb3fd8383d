import { effect } from '@preact/signals';
import { useEffect } from 'preact/hooks';
import { Segments } from '../kit/segments.tsx';
import { useCommand } from '../parts/commands.ts';
import { device } from '../parts/device/naming.ts';
import { forLog } from '../parts/for-log.ts';
import { FrameTabs } from '../parts/frame-tabs/frame-tabs.tsx';
import { page } from '../parts/store.ts';
import { CurrentStrip } from '../parts/strip/current-strip.tsx';
import { ExportButton } from '../parts/trace-export/export-button.tsx';
import { RowAbout } from '../parts/trace-rows/row-about.tsx';
import { timeKind } from '../parts/trace-rows/row-time.ts';
import { TraceFilter } from '../parts/trace-rows/trace-filter.tsx';
import { TraceRows } from '../parts/trace-rows/trace-rows.tsx';
import { TraceCauses, TraceSummaryLine } from '../parts/trace-rows/trace-summary.tsx';
import { useViewTitle } from '../parts/use-view.ts';
import { useWords } from '../parts/words.ts';
import { log, logAddress } from './log.ts';
import { LogSource } from './log-source.tsx';
import { Silences } from './silences.tsx';
import { TraceTabs } from './tabs/trace-tabs.tsx';
import './log.css';

/** A log or a capture: what is wrong in it, its frames, and the one that is chosen. */
export function LogView() {
  const { title } = useWords('trace');
  useViewTitle(title);
  useEffect(takeWhatComes, []);
  useEffect(() => effect(() => log.setDevice(device.value)), []);
  return (
    <main class="log-view">
      <LogSource />
      {log.state.value.kind === 'open' && <Opened />}
    </main>
  );
}

function Opened() {
  const words = useWords('trace');
  // Also where another tab than the list is open.
  useCommand('next-fault', log.nextFault);
  useCommand('previous-fault', log.previousFault);
  const names = <N extends string>(of: Readonly<Record<N, string>>) =>
    (Object.keys(of) as N[]).map((value) => ({ value, name: of[value] }));
  if (log.summary.value?.frames === 0 && log.pieces.value === 0) return <p class="said">{words.nothing}</p>;
  return (
    <>
      <TraceSummaryLine of={log} />
      <TraceCauses of={log} />
      <div class="in-row log-tools">
        <TraceFilter of={log} />
        <Segments
          bare
          label={words.unitChoice}
          options={names(words.unitNames)}
          value={log.by.value}
          onChoose={log.setUnit}
        />
        <Segments
          bare
          label={words.timeChoice}
          options={names(words.timeNames)}
          value={timeKind.value}
          onChoose={(kind) => {
            timeKind.value = kind;
          }}
        />
        <Silences />
        <ExportButton of={log} />
      </div>
      <TraceTabs
        of={log}
        chosen={logAddress.tab.value}
        onChoose={(tab) => {
          logAddress.tab.value = tab;
        }}
      >
        <TraceRows of={log} />
      </TraceTabs>
      <p class="said log-count">
        <span role="status">
          {words.shown(
            log.rowsKept.value,
            log.piecesKept.value,
            log.by.value,
            log.filtering.value,
            log.filtered.value,
            log.chosen.value >= 0,
          )}
        </span>{' '}
        <Clock />
      </p>
      <RowAbout of={log} />
      {log.chosen.value >= 0 && log.about.value?.row.length !== 0 && (
        <>
          <CurrentStrip />
          <FrameTabs of={page.shown} chosen={page.tab} onChoose={page.openTab} />
        </>
      )}
    </>
  );
}

/** Whose clock the times are of: those of the list, and those of the filter. */
function Clock() {
  const words = useWords('trace');
  log.revision.value;
  const state = log.state.value;
  if (state.kind !== 'open' || log.row(0)?.time === undefined) return null;
  const { timeZone } = new Intl.DateTimeFormat().resolvedOptions();
  return words.clockOf(state.format, state.clock?.shows, timeZone);
}

/** What is dropped or pasted here is the log, and what was given before. Answers how to end that. */
function takeWhatComes(): () => void {
  const take = (event: Event, data: DataTransfer | null) => {
    const file = data?.files[0];
    const typed = event.target instanceof Element && event.target.closest('input, textarea, select') !== null;
    const text = data?.getData('text/plain') ?? '';
    if (file === undefined && (typed || text.trim() === '')) return;
    event.preventDefault();
    event.stopPropagation();
    logAddress.open(file ?? text);
  };
  const watch = new AbortController();
  const first = { capture: true, signal: watch.signal };
  document.addEventListener('drop', (event) => take(event, event.dataTransfer), first);
  document.addEventListener('paste', (event) => take(event, event.clipboardData), first);
  const stop = effect(() => {
    const { value } = forLog;
    if (value === undefined) return;
    forLog.value = undefined;
    logAddress.open(value, 'edit');
  });
  return () => {
    watch.abort();
    stop();
  };
}
