import { Component } from 'preact';
import {
  builtInProfiles,
  canRead,
  type FoundRegister,
  lineName,
  type Profile,
  searchProfile,
  valueName,
} from '../../../devices/index.ts';
import { lineKey, linesFor, type PollSettings, pollLimits } from '../../../workbench/index.ts';
import { allDevices, chosenProfile } from '../../parts/device/chosen.ts';
import { deviceWords } from '../../parts/device/device-words.ts';
import { NumberField } from '../index.ts';
import { pollWords as words } from './poll-words.ts';

/** Most lines drawn at once; a search finds the others. */
const SHOWN = 60;

interface ChoiceProps {
  readonly settings: PollSettings;
  readonly onChange: (change: Partial<PollSettings>) => void;
}

/** Which device, which of its registers, and how they are put into requests. */
export class DeviceChoice extends Component<ChoiceProps, { readonly search: string }> {
  override state = { search: '' };

  private number(label: string, name: 'unit' | 'registers' | 'bits' | 'gap') {
    const { settings, onChange } = this.props;
    const [least, most] = pollLimits[name];
    return (
      <NumberField
        label={label}
        value={settings[name]}
        least={least}
        most={most}
        wrong={words.wrong(least, most)}
        onChange={(value) => onChange({ [name]: value })}
      />
    );
  }

  private readonly choose = (id: string) => {
    allDevices().choose(id);
    const unit = chosenProfile()?.serial?.unit;
    // The choice is drawn again also where the unit stays.
    this.props.onChange(unit === undefined ? {} : { unit });
    this.setState({ search: '' });
  };

  private tick(profile: Profile, key: string, ticked: boolean) {
    const { settings, onChange } = this.props;
    const others = linesFor(settings, profile.id).filter((other) => other !== key);
    onChange({ lines: { ...settings.lines, [profile.id]: ticked ? [...others, key] : others } });
  }

  render() {
    const profile = chosenProfile();
    const options = (profiles: readonly Profile[]) =>
      profiles.map(({ id, name }) => (
        <option key={id} value={id}>
          {name}
        </option>
      ));
    const own = allDevices().own.value;
    return (
      <>
        <div class="settings">
          <div class="control wide">
            <label for="poll-profile">{words.profile}</label>
            <select
              id="poll-profile"
              value={profile?.id ?? ''}
              onChange={({ currentTarget }) => this.choose(currentTarget.value)}
            >
              <option value="">{words.noProfile}</option>
              <optgroup label={deviceWords.builtIn}>{options(builtInProfiles)}</optgroup>
              {own.length > 0 && <optgroup label={deviceWords.own}>{options(own)}</optgroup>}
            </select>
          </div>
          {this.number(words.unit, 'unit')}
        </div>
        {profile && this.lines(profile)}
        <details>
          <summary>{words.how}</summary>
          <div class="settings">
            {this.number(words.registers, 'registers')}
            {this.number(words.bits, 'bits')}
            {this.number(words.gap, 'gap')}
          </div>
          <p class="said">{words.gapHint}</p>
        </details>
      </>
    );
  }

  private lines(profile: Profile) {
    const { search } = this.state;
    const ticked = new Set(linesFor(this.props.settings, profile.id));
    const found = searchProfile(profile, search).filter(({ register }) => canRead(register));
    return (
      <fieldset class="poll-lines">
        <legend>{words.lines}</legend>
        <div class="tools">
          <input
            type="search"
            aria-label={words.search}
            placeholder={words.search}
            autocomplete="off"
            spellcheck={false}
            value={search}
            onInput={({ currentTarget }) => this.setState({ search: currentTarget.value })}
          />
          <span class="said">{words.chosen(ticked.size)}</span>
          {ticked.size > 0 && (
            <button
              type="button"
              onClick={() => this.props.onChange({ lines: { ...this.props.settings.lines, [profile.id]: [] } })}
            >
              {words.chooseNone}
            </button>
          )}
        </div>
        <ul>
          {found.slice(0, SHOWN).map(({ register, index }) => {
            const key = lineKey(register, index);
            return (
              <li key={key}>
                <label>
                  <input
                    type="checkbox"
                    checked={ticked.has(key)}
                    onChange={({ currentTarget }) => this.tick(profile, key, currentTarget.checked)}
                  />{' '}
                  {nameOf({ register, index })} <span class="said">{deviceWords.typeText(register)}</span>
                </label>
              </li>
            );
          })}
        </ul>
        <p class="said" aria-live="polite">
          {found.length === 0 ? words.none : found.length > SHOWN && words.more(found.length - SHOWN)}
        </p>
      </fieldset>
    );
  }
}

const nameOf = ({ register, index }: FoundRegister) =>
  index === undefined ? lineName(register) : valueName(register, index);
