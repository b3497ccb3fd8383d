import { useComputed } from '@preact/signals';
import { formatBytes, wholeNumber } from '../../../notation/index.ts';
import {
  deviceSource,
  frameSource,
  type PollSettings,
  type PollSource,
  pollLimits,
  type SourceRefusal,
  type SourceWords,
} from '../../../workbench/index.ts';
import { disabledFor } from '../../kit/disabled-for.ts';
import { NumberEntry } from '../../kit/number-entry.tsx';
import { allDevices, onceCame } from '../../parts/device/chosen.ts';
import { draft, evaluation } from '../../parts/store.ts';
import { useWords } from '../../parts/words.ts';
import { bus } from '../bus.ts';
import { poll } from '../jobs.ts';
import { DeviceChoice } from './device-choice.tsx';
import './poll.css';
import { Values } from './polled-values.tsx';

/** The present choice of what is polled. */
function chosenSource(words: SourceWords): PollSource | SourceRefusal {
  const { value: settings } = poll.settings;
  if (settings.from === 'frame') return frameSource(draft.value, evaluation.value, words);
  const profile = allDevices.chosen.value;
  return profile ? deviceSource(profile, settings, bus.rules.value.transport, words) : 'nothing-chosen';
}

/** Reads the same again and again: the choice of what is read, and the values. */
export const PollPanel = onceCame(Panel);

function Panel() {
  const words = useWords('poll');
  const settings = poll.settings.value;
  const set = (change: Partial<PollSettings>) => {
    poll.settings.value = { ...poll.settings.value, ...change };
  };
  const source = useComputed(() => chosenSource(words)).value;
  const [least, most] = pollLimits.interval;
  return (
    <div class="poll">
      <fieldset {...disabledFor(poll.running.value ? words.locked : undefined)}>
        <legend>{words.source}</legend>
        <div class="checks in-row">
          {(['frame', 'device'] as const).map((from) => (
            <label key={from}>
              <input type="radio" name="poll-from" checked={settings.from === from} onChange={() => set({ from })} />{' '}
              {words[from]}
            </label>
          ))}
        </div>
        {settings.from === 'frame' ? <CurrentFrame /> : <DeviceChoice settings={settings} onChange={set} />}
        <div class="settings field-grid">
          <NumberEntry
            label={words.interval}
            value={settings.interval}
            read={wholeNumber(least, most)}
            wrong={words.wrong(least, most)}
            onValue={(interval) => set({ interval })}
          />
        </div>
        <p class="said">{words.intervalHint}</p>
        <Plan source={source} />
      </fieldset>
      <Actions source={source} />
      <Values />
    </div>
  );
}

function CurrentFrame() {
  const { summary } = useWords('page').page;
  const { frame } = evaluation.value;
  if (frame === undefined) return null;
  return (
    <>
      <p>{summary(frame.reading, frame.bytes.length, draft.value.transport)}</p>
      <p class="mono bytes-line">{formatBytes(frame.bytes)}</p>
    </>
  );
}

interface SourceProps {
  readonly source: PollSource | SourceRefusal;
}

/** What the poll will do, or why it cannot be started. */
function Plan({ source }: SourceProps) {
  const words = useWords('poll');
  if (typeof source === 'string') return <p class="said">{words.refusals[source]}</p>;
  return (
    <p class="said">
      {words.plan(source.values.length, source.requests.length)}{' '}
      {source.unreadable.length > 0 && <span class="error">{words.unreadable(source.unreadable)}</span>}
    </p>
  );
}

function Actions({ source }: SourceProps) {
  const words = useWords('poll');
  const { refusals } = useWords('bus').guard;
  const end = poll.end.value;
  const running = poll.running.value;
  const connected = bus.connected.value;
  const whyNot = !connected
    ? words.notConnected
    : typeof source === 'string'
      ? words.refusals[source]
      : source.values.length === 0
        ? words.noValues
        : undefined;
  const canGoOn = end?.kind === 'lost' || end?.kind === 'disconnected';
  const ended = end && (end.kind === 'refused' ? refusals[end.why] : words.ended[end.kind]);
  return (
    <>
      <p class="verdict poll-state" role="status" data-severity={canGoOn ? 'error' : undefined}>
        <strong>{running ? words.running : ended}</strong>
      </p>
      <div class="actions">
        {running ? (
          <button type="button" class="stop" onClick={poll.stop}>
            {words.stop}
          </button>
        ) : (
          <button
            type="button"
            class={canGoOn || !connected ? undefined : 'first'}
            {...disabledFor(whyNot)}
            onClick={() => typeof source !== 'string' && poll.start(source)}
          >
            {words.start}
          </button>
        )}
        {canGoOn && (
          <button
            type="button"
            class={connected ? 'first' : undefined}
            {...disabledFor(connected ? undefined : words.notConnected)}
            onClick={() => poll.goOn()}
          >
            {words.goOn}
          </button>
        )}
        {!connected && <span class="said">{words.notConnected}</span>}
      </div>
    </>
  );
}
