import { useComputed } from '@preact/signals';
import type { FoundRegister, Profile } from '../../../devices/index.ts';
import { canRead, valuesOf } from '../../../devices/index.ts';
import { wholeNumber } from '../../../notation/index.ts';
import { mapValues, pollLimits } from '../../../workbench/index.ts';
import { disabledFor } from '../../kit/disabled-for.ts';
import { NumberEntry } from '../../kit/number-entry.tsx';
import { busLink, mapReading, openBus } from '../bus-link.ts';
import { useWords } from '../words.ts';

interface MapProps {
  readonly profile: Profile;
  readonly found: readonly FoundRegister[];
}

/** What reads maps, where a line is open or being opened; `undefined` where somebody has to connect first. */
export const mapReader = () =>
  busLink.value.kind === 'open' || openBus.value?.opening.value ? mapReading.value : undefined;

/** Reads all registers that are shown, over the connection that is open or will be; without one, the ways to it. */
export function ReadMap({ profile, found }: MapProps) {
  const words = useWords('library');
  const { connectFirst } = useWords('devices');
  const reading = mapReader();
  if (!reading) {
    const bus = openBus.value;
    return (
      <p class="read-map in-row">
        <span class="said">{connectFirst}</span>
        <a href="#bus">{words.toBus}</a>
        {bus && (
          <button type="button" onClick={() => bus.openVirtual()}>
            {words.toVirtual}
          </button>
        )}
      </p>
    );
  }
  const [least, most] = pollLimits.unit;
  const running = reading.running.value;
  const count = found.filter(({ register }) => canRead(register)).length;
  return (
    <div class="read-map">
      <div class="in-row">
        <button
          type="button"
          class={running ? 'stop' : 'first'}
          {...disabledFor(!running && count === 0 ? words.nothingToRead : undefined)}
          onClick={() => (running ? reading.stop() : reading.start(profile, found))}
        >
          {running ? words.cancelReading : words.readAll(count)}
        </button>
        <NumberEntry
          key={profile.id}
          label={words.unit}
          value={reading.unitOf(profile)}
          read={wholeNumber(least, most)}
          wrong={words.unitWrong(least, most)}
          onValue={(unit) => reading.chooseUnit(profile, unit)}
        />
        <span class="said">{words.readHint(reading.gapFor(profile))}</span>
      </div>
      <Standing profile={profile} />
    </div>
  );
}

/** How far the reading is, or what it came to. */
function Standing({ profile }: { readonly profile: Profile }) {
  const words = useWords('library');
  const { refusals } = useWords('bus').guard;
  const reading = mapReading.value;
  const progress = reading?.progress.value;
  if (!reading || !progress || reading.map.value.of !== profile.id) return null;
  const { done, left } = progress;
  if (reading.running.value && openBus.value?.opening.value) return <p class="said">{words.readOnceOpen}</p>;
  if (reading.running.value)
    return (
      <p class="in-row">
        <progress aria-label={words.readingNow(done, left)} value={done} max={Math.max(1, done + left)} />
        <span aria-hidden="true">{words.readingNow(done, left)}</span>
      </p>
    );
  const end = reading.end.value;
  const why = end && (end.kind === 'refused' ? refusals[end.why] : words.readEnded[end.kind]);
  return (
    <p class="said" role="status">
      {why} {words.readResult(progress)}
    </p>
  );
}

/** The value of a line as it was read last, or why there is none. */
export function ReadValue({ profile, found }: { readonly profile: Profile; readonly found: FoundRegister }) {
  const words = useWords('library');
  const read = useComputed(() => mapReading.value?.map.value).value;
  const values = read && read.of === profile.id ? mapValues(profile, found, read.cells) : [];
  const [last] = values.toSorted((one, other) => other.time - one.time);
  if (last === undefined) return null;
  const failed = values.find((value) => value.kind === 'failed');
  const isAll = found.index !== undefined || values.length >= valuesOf(found.register);
  const text = words.values(found.register, values, isAll);
  const time = new Date(last.time).toLocaleTimeString();
  if (failed?.kind === 'failed')
    return (
      <span class="error" title={time}>
        {[text, words.failure(failed.failure)].filter((part) => part !== '').join('; ')}
      </span>
    );
  return (
    <>
      <span>{text}</span>
      <small>{time}</small>
    </>
  );
}
