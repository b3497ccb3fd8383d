import { useState } from 'preact/hooks';
import type { Profile, Register } from '../../../devices/index.ts';
import type { ChangeStep, ProfileChange } from '../../../store/index.ts';
import { type Refusal, withNewRegister, withoutRegister, withRegister } from '../../../workbench/index.ts';
import { Messages } from '../../kit/messages.tsx';
import { useFocus } from '../../kit/use-focus.ts';
import { mapReading } from '../bus-link.ts';
import { allDevices, onceCame } from '../device/chosen.ts';
import { ProfileSelect } from '../device/profile-select.tsx';
import { KeptFault } from '../kept-fault.tsx';
import { part, Slot } from '../slot.tsx';
import { page } from '../store.ts';
import { useWords } from '../words.ts';
import { About } from './about.tsx';
import { ByteCountOffer } from './byte-count-offer.tsx';
import './devices.css';
import { FoundRegisters } from './found-registers.tsx';
import { mapReader, ReadMap, ReadValue } from './read-map.tsx';

/** The settings come with a person's first device; files when the panel is first opened. */
const settings = part(
  ['devices'],
  () => import('./profile-settings.tsx'),
  ({ ProfileSettings }) => ProfileSettings,
);
const exchange = part(
  ['devices'],
  () => import('./exchange.tsx'),
  ({ Exchange }) => Exchange,
);

/** What was done, in sentences, and whether it can be taken back. */
interface Done {
  readonly lines: readonly string[];
  readonly undo?: boolean;
  /** Whether the way to the current frame is offered. */
  readonly toFrame?: boolean;
}

const NOTHING: Done = { lines: [] };

interface DevicePanelProps {
  /** Whether the library stands beside it, where devices are chosen and imported. */
  readonly inLibrary?: boolean;
}

/** The chosen device: its registers by name, and what else its profile says. */
export const DevicePanel = onceCame(Panel);

function Panel({ inLibrary = false }: DevicePanelProps) {
  const words = useWords('devices');
  const { root, focus } = useFocus<HTMLDivElement>();
  const [search, setSearch] = useState('');
  const [done, setDone] = useState(NOTHING);
  const profile = allDevices.chosen.value;

  const say = (line: string) => setDone({ lines: [line] });
  /** Tells the result of a change, and whether it was made. */
  const changed = (outcome: ProfileChange | Refusal, line: string): boolean => {
    if (typeof outcome === 'string') {
      say(words.refusals[outcome]);
      return false;
    }
    const isCopy = outcome.kind === 'copied';
    if (isCopy) mapReading.value?.follow(outcome.before, outcome.copy);
    setDone({ lines: [line, ...(isCopy ? [words.copied(outcome.before.name, outcome.copy.name)] : [])], undo: true });
    return true;
  };

  const create = () => {
    const added = allDevices.create(words.newName);
    say(typeof added === 'string' ? words.refusals[added] : words.created(added.name));
  };
  const went = (step: ChangeStep | Refusal, line: (step: ChangeStep) => string) => {
    setDone({ lines: [typeof step === 'string' ? words.refusals[step] : line(step)], undo: true });
    return typeof step === 'string' || step.change.kind !== 'copied' ? undefined : step.change;
  };
  const undo = () => {
    const copied = went(allDevices.undo(), ({ change, profile: { name } }) =>
      change.kind === 'deleted' ? words.restored(name) : words.undone,
    );
    if (copied) mapReading.value?.follow(copied.copy, copied.before);
  };
  const redo = () => {
    const copied = went(allDevices.redo(), ({ change, profile: { name } }) =>
      change.kind === 'deleted' ? words.deleted(name) : words.redone,
    );
    if (copied) mapReading.value?.follow(copied.before, copied.copy);
  };
  const imported = (lines: readonly string[], show?: Profile) => {
    if (show) allDevices.choose(show.id);
    setSearch('');
    setDone({ lines });
  };

  const keep = (of: Profile, at: number, register: Register) =>
    changed(allDevices.keep(of, withRegister(of, at, register)), words.kept(register.name));
  const remove = (of: Profile, at: number) => {
    changed(allDevices.keep(of, withoutRegister(of, at)), words.removedRow(of.registers[at]?.name ?? ''));
    focus('undo');
  };
  const add = (of: Profile) =>
    changed(allDevices.keep(of, withNewRegister(of, words.newRegister)), words.added(words.newRegister))
      ? of.registers.length
      : undefined;
  const { latest, next } = allDevices.history;
  return (
    <div ref={root}>
      <KeptFault list={allDevices.list} words={words} onMessage={say} />
      <div class="device-choice in-row">
        {!inLibrary && (
          <label for="device-profile">
            {words.profile}
            <ProfileSelect
              id="device-profile"
              none={words.none}
              onChosen={() => {
                setSearch('');
                setDone(NOTHING);
              }}
            />
          </label>
        )}
        <button type="button" onClick={create}>
          {words.newProfile}
        </button>
      </div>
      {profile ? <About profile={profile} /> : <p class="said">{words.intro}</p>}
      <ByteCountOffer />
      {profile && (
        <FoundRegisters
          profile={profile}
          search={search}
          onSearch={setSearch}
          onTaken={(name, line) => (inLibrary ? setDone({ lines: [words.inForm(name)], toFrame: true }) : say(line))}
          onKeep={(at, register) => keep(profile, at, register)}
          onRemove={(at) => remove(profile, at)}
          onAdd={() => add(profile)}
          {...(inLibrary && {
            tools: (found) => <ReadMap profile={profile} found={found} />,
            value: { name: words.valueRead, cell: (found) => <ReadValue profile={profile} found={found} /> },
            onRead: (found) => {
              const reader = mapReader();
              if (reader) reader.start(profile, [found]);
              else say(words.connectFirst);
            },
          })}
        />
      )}
      <Messages lines={done.lines}>
        {done.toFrame && (
          <p>
            <a href={page.frameLink.value}>{words.toForm}</a>
          </p>
        )}
        {done.undo && (latest.value || next.value) && (
          <p class="in-row">
            {latest.value && (
              <button type="button" data-focus="undo" onClick={undo}>
                {latest.value.kind === 'deleted' ? words.undo(latest.value.removed.item.name) : words.undoChange}
              </button>
            )}
            {next.value && (
              <button type="button" onClick={redo}>
                {words.redo}
              </button>
            )}
          </p>
        )}
      </Messages>
      {profile && allDevices.isOwn(profile) && (
        <>
          <Slot
            key={profile.id}
            part={settings}
            with={{ profile, onChange: (next) => changed(allDevices.keep(profile, next), words.changed(next.name)) }}
          />
          <p>
            <button
              type="button"
              onClick={() => {
                changed(allDevices.delete(profile), words.deleted(profile.name));
                focus('undo');
              }}
            >
              {words.delete(profile.name)}
            </button>
          </p>
        </>
      )}
      <Slot part={exchange} with={{ profile, inLibrary, onImported: imported, onMessage: say }} />
    </div>
  );
}
