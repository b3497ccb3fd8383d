import { effect } from '@preact/signals';
import { useEffect, useLayoutEffect } from 'preact/hooks';
import { FileButton } from '../kit/file-button.tsx';
import { device } from '../parts/device/naming.ts';
import { FrameTabs } from '../parts/frame-tabs/frame-tabs.tsx';
import { page } from '../parts/store.ts';
import { CurrentStrip } from '../parts/strip/current-strip.tsx';
import { TraceRows } from '../parts/trace-rows/trace-rows.tsx';
import { viewTitle } from '../parts/use-view.ts';
import { useWords } from '../parts/words.ts';
import { log } from './log.ts';
import './log.css';

/** A log or a capture: what is wrong in it, its frames, and the one that is chosen. */
export function LogView() {
  const { title } = useWords('trace');
  useLayoutEffect(() => {
    viewTitle.value = title;
    return () => {
      viewTitle.value = undefined;
    };
  }, [title]);
  useEffect(takeWhatComes, []);
  useEffect(() => effect(() => log.setDevice(device.value)), []);
  return (
    <main class="log-view">
      <Source />
      {log.state.value.kind === 'open' && (
        <>
          <TraceRows of={log} />
          <CurrentStrip />
          <FrameTabs of={page.shown} chosen={page.tab} onChoose={page.openTab} />
        </>
      )}
    </main>
  );
}

/** What is opened, and how far it is. */
function Source() {
  const words = useWords('trace');
  const state = log.state.value;
  return (
    <div class="in-row">
      <FileButton label={words.openFile} onFile={log.open} />
      <span role="status">
        {state.kind === 'empty' && words.empty}
        {state.kind === 'opening' && (
          <>
            <progress aria-label={words.opening(state.name, 0)} max={100} value={state.percent} />{' '}
            {words.opening(state.name, state.percent)}
          </>
        )}
        {state.kind === 'failed' && <span class="error">{words.failed[state.code]}</span>}
      </span>
      {state.kind === 'opening' && (
        <button type="button" onClick={log.cancel}>
          {words.cancel}
        </button>
      )}
    </div>
  );
}

/** What is dropped or pasted here is the log. Answers how to end that. */
function takeWhatComes(): () => void {
  const take = (event: Event, data: DataTransfer | null) => {
    const file = data?.files[0];
    const typed = event.target instanceof Element && event.target.closest('input, textarea, select') !== null;
    const text = data?.getData('text/plain') ?? '';
    if (file === undefined && (typed || text.trim() === '')) return;
    event.preventDefault();
    event.stopPropagation();
    if (file) log.open(file);
    else log.openText(text);
  };
  const watch = new AbortController();
  const first = { capture: true, signal: watch.signal };
  document.addEventListener('drop', (event) => take(event, event.dataTransfer), first);
  document.addEventListener('paste', (event) => take(event, event.clipboardData), first);
  return () => watch.abort();
}
