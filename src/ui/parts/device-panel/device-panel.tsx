import { useState } from 'preact/hooks';
import type { Profile, Register } from '../../../devices/index.ts';
import type { ProfileChange } from '../../../store/index.ts';
import type { Refusal } from '../../../workbench/index.ts';
import { Messages } from '../../kit/messages.tsx';
import { useFocus } from '../../kit/use-focus.ts';
import { allDevices, onceCame } from '../device/chosen.ts';
import { ProfileSelect } from '../device/profile-select.tsx';
import { KeptFault } from '../kept-fault.tsx';
import { part, Slot } from '../slot.tsx';
import { useWords } from '../words.ts';
import { About } from './about.tsx';
import { ByteCountOffer } from './byte-count-offer.tsx';
import './devices.css';
import { FoundRegisters } from './found-registers.tsx';
import { RegisterEditor } from './register-editor.tsx';

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
  const [editing, edit] = useState<Register | 'new'>();
  const [done, setDone] = useState(NOTHING);
  const profile = allDevices.chosen.value;

  const say = (line: string) => setDone({ lines: [line] });
  const finish = (next: Done) => {
    edit(undefined);
    setDone(next);
  };
  /** Tells the result of a change. */
  const changed = (outcome: ProfileChange | Refusal, line: string) => {
    if (typeof outcome === 'string') return finish({ lines: [words.refusals[outcome]] });
    const copied = outcome.kind === 'copied' ? [words.copied(outcome.before.name, outcome.copy.name)] : [];
    finish({ lines: [line, ...copied], undo: true });
  };

  const create = () => {
    const added = allDevices.create(words.newName);
    finish({ lines: [typeof added === 'string' ? words.refusals[added] : words.created(added.name)] });
  };
  const undo = ({ kind }: ProfileChange) => {
    const back = allDevices.undo();
    const line = kind === 'deleted' ? words.restored : () => words.undone;
    finish({ lines: [typeof back === 'string' ? words.refusals[back] : line(back.name)] });
  };
  const imported = (lines: readonly string[], show?: Profile) => {
    if (show) allDevices.choose(show.id);
    setSearch('');
    finish({ lines });
  };
  const start = (register: Register | 'new') => {
    edit(register);
    setDone(NOTHING);
  };

  const keep = (of: Profile, register: Register) => {
    const registers =
      editing === 'new'
        ? [...of.registers, register]
        : of.registers.map((each) => (each === editing ? register : each));
    changed(allDevices.keep(of, { ...of, registers }), words.kept(register.name));
    focus(`edit ${register.name}`);
  };
  const remove = (of: Profile, register: Register) => {
    const registers = of.registers.filter((each) => each !== register);
    changed(allDevices.keep(of, { ...of, registers }), words.removedRow(register.name));
    focus('undo');
  };
  const latest = allDevices.latest.value;
  const edited = editing === 'new' ? undefined : editing;
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
                finish(NOTHING);
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
        <>
          <FoundRegisters
            profile={profile}
            search={search}
            onSearch={setSearch}
            onTaken={say}
            onEdit={start}
            onRemove={(register) => remove(profile, register)}
          />
          {editing === undefined ? (
            <p>
              <button type="button" data-focus="add" onClick={() => start('new')}>
                {words.add}
              </button>
            </p>
          ) : (
            <RegisterEditor
              key={edited?.name ?? ''}
              profile={profile}
              register={edited}
              onKeep={(register) => keep(profile, register)}
              onCancel={() => {
                edit(undefined);
                focus(edited ? `edit ${edited.name}` : 'add');
              }}
            />
          )}
        </>
      )}
      <Messages lines={done.lines}>
        {done.undo && latest && (
          <button type="button" data-focus="undo" onClick={() => undo(latest)}>
            {latest.kind === 'deleted' ? words.undo(latest.removed.item.name) : words.undoChange}
          </button>
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
