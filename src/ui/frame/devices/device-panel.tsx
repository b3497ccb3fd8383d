import {
  builtInProfiles,
  type FoundRegister,
  type Profile,
  type Register,
  searchProfile,
} from '../../../devices/index.ts';
import {
  type BadProfile,
  createProfile,
  type Done,
  type Imported,
  keepChange,
  type ProfileDesk,
  removeProfile,
} from '../../../workbench/index.ts';
import { download } from '../../kit/download.ts';
import { FoldPanel } from '../../kit/fold.tsx';
import { allDevices, chosenProfile } from '../../parts/device/chosen.ts';
import { deviceWords as words } from '../../parts/device/device-words.ts';
import { Slot } from '../../parts/slot.tsx';
import { KeptPanel } from '../kept-panel.ts';
import { About } from './about.tsx';
import { ByteCountOffer, byteCountWanted } from './byte-count-offer.tsx';
import { RegisterEditor } from './register-editor.tsx';
import { RegisterTable } from './register-table.tsx';

interface PanelState {
  readonly search: string;
  /** What is being edited: a register, or a new one. */
  readonly editing?: Register | 'new' | undefined;
  readonly done: Done;
  readonly focus?: string | undefined;
}

const desk = (): ProfileDesk => ({ list: allDevices().list, choose: allDevices().choose, words });

const NOTHING: Done = { said: [] };

/** Settings come with the first device of one's own; files, with what reads CSV, when the panel is first opened. */
const loadOwnSettings = () => import('./own-settings.tsx').then(({ OwnSettings }) => OwnSettings);
const loadExchange = () => import('./exchange.tsx').then(({ Exchange }) => Exchange);

/** The device that is spoken to: its registers by name, and what is known of it. */
export class DevicePanel extends KeptPanel<object, PanelState> {
  override state: PanelState = { search: '', done: NOTHING };

  private readonly say = (said: string): void => this.setState({ done: { said: [said] } });

  private do(done: Done, more: Partial<PanelState> = {}): void {
    this.setState({ editing: undefined, ...more, done });
  }

  private readonly imported = ({ said, show }: Imported): void => {
    if (show) allDevices().choose(show.id);
    this.do({ said }, { search: '' });
  };

  private keep(profile: Profile, register: Register): void {
    const { editing } = this.state;
    const registers =
      editing === 'new'
        ? [...profile.registers, register]
        : profile.registers.map((each) => (each === editing ? register : each));
    const done = keepChange(desk(), profile, { ...profile, registers }, words.kept(register.name));
    this.do(done, { focus: `edit ${register.name}` });
  }

  private remove(profile: Profile, { register }: FoundRegister): void {
    const registers = profile.registers.filter((each) => each !== register);
    this.do(keepChange(desk(), profile, { ...profile, registers }, words.removedRow(register.name)), { focus: 'undo' });
  }

  render() {
    const profile = chosenProfile();
    return (
      <FoldPanel root={this.takeRoot} class="device-panel" title={words.title} hint={profile?.name}>
        {() => this.body(profile)}
      </FoldPanel>
    );
  }

  private body(profile: Profile | undefined) {
    return (
      <>
        <StorageFault onSaid={this.say} />
        <div class="device-choice">
          <Choice onChosen={() => this.do(NOTHING, { search: '' })} />
          <button type="button" onClick={() => this.do(createProfile(desk()))}>
            {words.newProfile}
          </button>
        </div>
        {!profile && <p class="said">{words.intro}</p>}
        {profile && <About profile={profile} />}
        <ByteCountOffer wanted={byteCountWanted(profile)} />
        {profile && this.registers(profile)}
        {this.says()}
        {profile && allDevices().isOwn(profile) && this.own(profile)}
        <Slot part={loadExchange} with={{ profile, onImported: this.imported, onSaid: this.say }} />
      </>
    );
  }

  private registers(profile: Profile) {
    const { search, editing } = this.state;
    const found = searchProfile(profile, search);
    const edited = editing === 'new' ? undefined : editing;
    return (
      <>
        <div class="control device-search">
          <label for="device-search">{words.search}</label>
          <input
            id="device-search"
            type="search"
            autocomplete="off"
            spellcheck={false}
            value={search}
            aria-describedby="device-found"
            onInput={({ currentTarget }) => this.setState({ search: currentTarget.value })}
          />
          <p class="said" id="device-found" aria-live="polite">
            {search.trim() === '' ? words.searchHint : words.found(found.length)}
          </p>
        </div>
        <RegisterTable
          profile={profile}
          found={found}
          onTaken={this.say}
          onEdit={({ register }) => this.setState({ editing: register, done: NOTHING })}
          onRemove={(each) => this.remove(profile, each)}
        />
        {editing === undefined ? (
          <p>
            <button type="button" data-focus="add" onClick={() => this.setState({ editing: 'new', done: NOTHING })}>
              {words.add}
            </button>
          </p>
        ) : (
          <RegisterEditor
            key={edited?.name ?? ''}
            profile={profile}
            register={edited}
            onKeep={(register) => this.keep(profile, register)}
            onCancel={() => this.setState({ editing: undefined, focus: edited ? `edit ${edited.name}` : 'add' })}
          />
        )}
      </>
    );
  }

  private own(profile: Profile) {
    return (
      <>
        <Slot
          key={profile.id}
          part={loadOwnSettings}
          with={{
            profile,
            onChange: (changed) => this.do(keepChange(desk(), profile, changed, words.changed(changed.name))),
          }}
        />
        <p>
          <button type="button" onClick={() => this.do(removeProfile(desk(), profile), { focus: 'undo' })}>
            {words.delete(profile.name)}
          </button>
        </p>
      </>
    );
  }

  /** What was done, and the way back from it. */
  private says() {
    const { said, undo } = this.state.done;
    return (
      <div class="device-says">
        <div role="status">
          {said.map((line, index) => (
            <p key={index}>{line}</p>
          ))}
        </div>
        {undo && (
          <button type="button" data-focus="undo" onClick={() => this.do(undo.run())}>
            {undo.label}
          </button>
        )}
      </div>
    );
  }
}

function Choice({ onChosen }: { onChosen: () => void }) {
  const options = (profiles: readonly Profile[]) =>
    profiles.map(({ id, name }) => (
      <option key={id} value={id}>
        {name}
      </option>
    ));
  const own = allDevices().own.value;
  return (
    <label>
      {words.profile}
      <select
        value={chosenProfile()?.id ?? ''}
        onChange={({ currentTarget }) => {
          allDevices().choose(currentTarget.value);
          onChosen();
        }}
      >
        <option value="">{words.none}</option>
        <optgroup label={words.builtIn}>{options(builtInProfiles)}</optgroup>
        {own.length > 0 && <optgroup label={words.own}>{options(own)}</optgroup>}
      </select>
    </label>
  );
}

/** What of the storage cannot be used. Nothing is thrown away. */
function StorageFault({ onSaid }: { onSaid: (said: string) => void }) {
  const { value } = allDevices().list.stored;
  if (value.kind === 'refused') return <p class="device-fault">{words.refusals.refused}</p>;
  if (value.kind === 'list') return value.bad.length === 0 ? null : <BadProfiles bad={value.bad} />;
  return (
    <p class="device-fault">
      {words.unreadable(value.fault)}{' '}
      <button type="button" onClick={() => download(value.text, 'framewright-devices.json')}>
        {words.download}
      </button>{' '}
      <button
        type="button"
        onClick={() => {
          const outcome = allDevices().list.setUnreadableAside();
          onSaid(typeof outcome === 'string' ? words.refusals[outcome] : words.setAsideAs(outcome.key));
        }}
      >
        {words.setAside}
      </button>
    </p>
  );
}

/** Stored devices that cannot be used, and why. */
function BadProfiles({ bad }: { bad: readonly BadProfile[] }) {
  return (
    <div class="device-fault">
      <p>{words.badProfiles(bad.length)}</p>
      {bad.map(({ name, fault }, index) => (
        <p key={index}>{words.badProfile(name, fault)}</p>
      ))}
    </div>
  );
}
