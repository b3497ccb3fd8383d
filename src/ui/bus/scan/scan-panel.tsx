import type { LinkSettings } from '../../../bus/index.ts';
import { estimateScan } from '../../../bus/index.ts';
import { type ScanSettings, scanOrder, scanWhats } from '../../../workbench/index.ts';
import { bus, FollowingPanel, scanMemory } from '../index.ts';
import { Findings } from './found.tsx';
import { scanWords as words } from './scan-words.ts';
import { scanning } from './scanning.ts';
import { Fields } from './settings-fields.tsx';

interface PanelState {
  readonly settings: ScanSettings;
}

/** Looks for units, functions and addresses. */
export class ScanPanel extends FollowingPanel<PanelState> {
  override state: PanelState = { settings: scanMemory.value };

  protected follows(): readonly unknown[] {
    const { link, settings, rules } = bus.state;
    return [link.kind, settings, rules, scanning.state];
  }

  protected follow(look: () => void) {
    return scanning.follow(look);
  }

  private readonly set = (change: Partial<ScanSettings>) => {
    const settings = { ...this.state.settings, ...change };
    scanMemory.value = settings;
    this.setState({ settings });
  };

  render() {
    const { settings } = this.state;
    const { running, order } = scanning.state;
    return (
      <div class="scan">
        <fieldset disabled={running}>
          <legend>{words.what}</legend>
          <div class="checks">
            {scanWhats.map((what) => (
              <label key={what}>
                <input
                  type="radio"
                  name="scan-what"
                  checked={settings.what === what}
                  onChange={() => this.set({ what })}
                />{' '}
                {words.whats[what]}
              </label>
            ))}
          </div>
          <p class="said">{words.intro[settings.what]}</p>
          <Fields settings={settings} onChange={this.set} />
        </fieldset>
        <Start settings={settings} />
        <Progress />
        {order && <Findings order={order} found={scanning.state.found} />}
      </div>
    );
  }
}

/** How the line is open, or would be. */
const currentLine = (): LinkSettings => (bus.state.link.kind === 'open' ? bus.state.link.settings : bus.state.settings);

function Start({ settings }: { readonly settings: ScanSettings }) {
  const { running } = scanning.state;
  const connected = bus.state.link.kind === 'open';
  const current = currentLine();
  const order = scanOrder(settings, current);
  const estimate = order && estimateScan(order, current, bus.state.rules);
  return (
    <>
      {!running && (
        <p class="said">
          {estimate && order ? (
            words.estimate(estimate.requests, estimate.time, order.what)
          ) : (
            <span class="error">{words.backwards}</span>
          )}
        </p>
      )}
      <div class="actions">
        {running ? (
          <button key="stop" type="button" class="first" onClick={() => scanning.stop()}>
            {words.stop}
          </button>
        ) : (
          <button
            key="start"
            type="button"
            class="first"
            disabled={!connected || order === undefined}
            onClick={() => order && scanning.start(order)}
          >
            {words.start}
          </button>
        )}
        {!connected && !running && <span class="said">{words.notConnected}</span>}
      </div>
    </>
  );
}

/** How far it is, and how it ended. Only the end is read out, not each step. */
function Progress() {
  const { running, end, order, progress, found } = scanning.state;
  const isDone = progress !== undefined && progress.done === progress.total;
  const ended = end?.kind === 'refused' ? words.refused(end.why) : end && words.ended[isDone ? 'done' : end.kind];
  const isBad = end !== undefined && !isDone && end.kind !== 'stopped';
  return (
    <>
      <p class="verdict" role="status" data-severity={isBad ? 'error' : undefined}>
        {(running || ended) && <strong>{ended ?? words.running}</strong>}
      </p>
      {order && progress && (
        <div class="progress">
          <progress aria-label={words.progressLabel} value={progress.done} max={progress.total} />
          <span>{words.progress(progress.done, progress.total, progress.left, order.what)}</span>
        </div>
      )}
      {isDone && end && order?.what === 'units' && found.length === 0 && <p class="said">{words.noUnits}</p>}
    </>
  );
}
