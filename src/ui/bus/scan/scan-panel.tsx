import { useComputed } from '@preact/signals';
import { estimateScan } from '../../../bus/index.ts';
import { type ScanSettings, scanOrder, scanTargets } from '../../../workbench/index.ts';
import { disabledFor } from '../../kit/disabled-for.ts';
import { useWords } from '../../parts/words.ts';
import { bus } from '../bus.ts';
import { scan } from '../jobs.ts';
import { Findings } from './found.tsx';
import './scan.css';
import { Fields } from './settings-fields.tsx';

/** Looks for units, functions and addresses. */
export function ScanPanel() {
  const words = useWords('scan');
  const settings = scan.settings.value;
  const set = (change: Partial<ScanSettings>) => {
    scan.settings.value = { ...scan.settings.value, ...change };
  };
  return (
    <div class="scan">
      <fieldset {...disabledFor(scan.running.value ? words.locked : undefined)}>
        <legend>{words.target}</legend>
        <div class="checks in-row">
          {scanTargets.map((what) => (
            <label key={what}>
              <input type="radio" name="scan-what" checked={settings.what === what} onChange={() => set({ what })} />{' '}
              {words.targets[what]}
            </label>
          ))}
        </div>
        <p class="said">{words.intro[settings.what]}</p>
        <Fields settings={settings} onChange={set} />
      </fieldset>
      <Start />
      <Progress />
      {scan.order.value && <Findings order={scan.order.value} />}
    </div>
  );
}

function Start() {
  const words = useWords('scan');
  const planned = useComputed(() => {
    const { value: link } = bus.link;
    // How the line is open, or would be.
    const line = link.kind === 'open' ? link.settings : bus.settings.value;
    const order = scanOrder(scan.settings.value, line);
    return order && { order, ...estimateScan(order, line, bus.rules.value) };
  }).value;
  const connected = bus.connected.value;
  if (scan.running.value)
    return (
      <div class="actions">
        <button key="stop" type="button" class="stop" onClick={scan.stop}>
          {words.stop}
        </button>
      </div>
    );
  return (
    <>
      <p class="said">
        {planned ? (
          words.estimate(planned.requests, planned.time, planned.order.what)
        ) : (
          <span class="error">{words.backwards}</span>
        )}
      </p>
      <div class="actions">
        <button
          key="start"
          type="button"
          class={connected ? 'first' : undefined}
          {...disabledFor(!connected ? words.notConnected : planned ? undefined : words.backwards)}
          onClick={() => planned && scan.start(planned.order)}
        >
          {words.start}
        </button>
        {!connected && <span class="said">{words.notConnected}</span>}
      </div>
    </>
  );
}

/** How far it is, and how it ended. Only the end is read out, not each step. */
function Progress() {
  const words = useWords('scan');
  const end = scan.end.value;
  const order = scan.order.value;
  const progress = scan.progress.value;
  const isDone = progress !== undefined && progress.done === progress.total;
  const ended = end?.kind === 'refused' ? words.refused(end.why) : end && words.ended[isDone ? 'done' : end.kind];
  const isBad = end !== undefined && !isDone && end.kind !== 'stopped';
  return (
    <>
      <p class="verdict" role="status" data-severity={isBad ? 'error' : undefined}>
        {(scan.running.value || ended) && <strong>{ended ?? words.running}</strong>}
      </p>
      {order && progress && (
        <div class="progress in-row">
          <progress aria-label={words.progressLabel} value={progress.done} max={progress.total} />
          <span>{words.progress(progress.done, progress.total, progress.left, order.what)}</span>
        </div>
      )}
      {isDone && end && order?.what === 'units' && scan.found.value.length === 0 && <p class="said">{words.noUnits}</p>}
    </>
  );
}
