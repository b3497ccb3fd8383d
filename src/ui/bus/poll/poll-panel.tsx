import { Component } from 'preact';
import type { JobEnd } from '../../../store/index.ts';
import {
  deviceSource,
  frameSource,
  type PollSettings,
  type PollSource,
  pollLimits,
  type SourceRefusal,
} from '../../../workbench/index.ts';
import { chosenProfile } from '../../parts/device/chosen.ts';
import { draft, evaluation } from '../../parts/store.ts';
import { bus, NumberField, pollMemory } from '../index.ts';
import { DeviceChoice } from './device-choice.tsx';
import { FrameChoice } from './frame-choice.tsx';
import { poll } from './poll.ts';
import { busWords, pollWords as words } from './poll-words.ts';
import { Values } from './polled-values.tsx';

/** What was read is drawn so often at most, in milliseconds; and again after so long, because ages grow. */
const DRAW_EACH = 100;
const AGE_EACH = 1000;

interface PanelState {
  readonly settings: PollSettings;
  /** Of what was read: drawn again when it changes. */
  readonly drawing: number;
}

/** Reads the same again and again: what is read, and what has come. */
export class PollPanel extends Component<object, PanelState> {
  override state: PanelState = { settings: pollMemory.value, drawing: 0 };
  private stop = () => {};
  private timer: ReturnType<typeof setTimeout> | undefined;
  private soon = false;
  /** What was drawn last: a line that is busy draws none of it again. */
  private drawn: readonly unknown[] = [];

  override componentDidMount() {
    this.stop = poll.listen(this.drawSoon);
    this.later();
  }

  override shouldComponentUpdate(_props: object, state: PanelState) {
    return state !== this.state || this.follows().some((value, index) => value !== this.drawn[index]);
  }

  override componentWillUnmount() {
    this.stop();
    clearTimeout(this.timer);
  }

  private follows(): readonly unknown[] {
    const { link, rules } = bus.state;
    return [link.kind, rules.transport, evaluation.value, chosenProfile()];
  }

  private readonly drawSoon = () => {
    if (this.soon) return;
    this.soon = true;
    this.later();
  };

  private later() {
    clearTimeout(this.timer);
    this.timer = setTimeout(this.draw, this.soon ? DRAW_EACH : AGE_EACH);
  }

  private readonly draw = () => {
    const isNew = this.soon;
    this.soon = false;
    if (isNew || poll.polled) this.setState(({ drawing }) => ({ drawing: drawing + 1 }));
    this.later();
  };

  private readonly set = (change: Partial<PollSettings>) => {
    const settings = { ...this.state.settings, ...change };
    pollMemory.value = settings;
    this.setState({ settings });
  };

  private source(): PollSource | SourceRefusal {
    const { settings } = this.state;
    if (settings.from === 'frame') return frameSource(draft.value, evaluation.value, words);
    const profile = chosenProfile();
    return profile ? deviceSource(profile, settings, bus.state.rules.transport, words) : 'nothing-chosen';
  }

  render() {
    this.drawn = this.follows();
    const { settings } = this.state;
    const running = poll.state.kind === 'running';
    const source = this.source();
    const [least, most] = pollLimits.interval;
    return (
      <div class="poll">
        <fieldset disabled={running}>
          <legend>{words.what}</legend>
          <div class="checks">
            {(['frame', 'device'] as const).map((from) => (
              <label key={from}>
                <input
                  type="radio"
                  name="poll-from"
                  checked={settings.from === from}
                  onChange={() => this.set({ from })}
                />{' '}
                {words[from]}
              </label>
            ))}
          </div>
          {settings.from === 'frame' ? <FrameChoice /> : <DeviceChoice settings={settings} onChange={this.set} />}
          <div class="settings">
            <NumberField
              label={words.interval}
              value={settings.interval}
              least={least}
              most={most}
              wrong={words.wrong(least, most)}
              onChange={(interval) => this.set({ interval })}
            />
          </div>
          <p class="said">{words.intervalHint}</p>
          <SourceSaid source={source} />
        </fieldset>
        <Actions source={source} interval={settings.interval} />
        {poll.polled && (
          <Values
            polled={poll.polled}
            drawing={this.state.drawing}
            window={settings.window}
            onWindow={(window) => this.set({ window })}
          />
        )}
      </div>
    );
  }
}

/** What the poll will do, or why there is none. */
function SourceSaid({ source }: { readonly source: PollSource | SourceRefusal }) {
  if (typeof source === 'string') return <p class="said">{words.refusals[source]}</p>;
  return (
    <p class="said">
      {words.plan(source.values.length, source.requests.length)}{' '}
      {source.unreadable.length > 0 && <span class="error">{words.unreadable(source.unreadable)}</span>}
    </p>
  );
}

function Actions({ source, interval }: { readonly source: PollSource | SourceRefusal; readonly interval: number }) {
  const { state } = poll;
  const connected = bus.state.link.kind === 'open';
  const running = state.kind === 'running';
  const canGoOn = state.kind === 'ended' && (state.end.kind === 'lost' || state.end.kind === 'disconnected');
  return (
    <>
      <p class="verdict poll-state" role="status" data-severity={canGoOn ? 'error' : undefined}>
        <strong>{running ? words.running : state.kind === 'ended' ? endText(state.end) : ''}</strong>
      </p>
      <div class="actions">
        {running ? (
          <button type="button" class="first" onClick={() => poll.stop()}>
            {words.stop}
          </button>
        ) : (
          <button
            type="button"
            class={canGoOn ? undefined : 'first'}
            disabled={!connected || typeof source === 'string' || source.values.length === 0}
            onClick={() => typeof source !== 'string' && poll.start(source, interval)}
          >
            {words.start}
          </button>
        )}
        {canGoOn && (
          <button type="button" class="first" disabled={!connected} onClick={() => poll.goOn()}>
            {words.goOn}
          </button>
        )}
        {!connected && <span class="said">{words.notConnected}</span>}
      </div>
    </>
  );
}

const endText = (end: JobEnd): string =>
  end.kind === 'refused' ? busWords.guard.refusals[end.why] : words.ended[end.kind];
