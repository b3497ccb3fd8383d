import { useState } from 'preact/hooks';
import { builtInProfiles, canRead, lineName, type Profile, searchProfile, valueName } from '../../../devices/index.ts';
import { lineKey, linesFor, type PollSettings, pollLimits } from '../../../workbench/index.ts';
import { SearchBox } from '../../kit/search-box.tsx';
import { allDevices, chosenProfile } from '../../parts/device/chosen.ts';
import { useWords } from '../../parts/words.ts';
import { NumberField } from '../settings-form.tsx';

/** Most lines drawn at once; a search finds the others. */
const SHOWN = 60;

interface ChoiceProps {
  readonly settings: PollSettings;
  readonly onChange: (change: Partial<PollSettings>) => void;
}

/** Which device, which of its registers, and how they are put into requests. */
export function DeviceChoice({ settings, onChange }: ChoiceProps) {
  const words = useWords('poll');
  const { builtIn, own } = useWords('devices');
  const profile = chosenProfile();
  const number = (name: 'unit' | 'registers' | 'bits' | 'gap') => {
    const [least, most] = pollLimits[name];
    return (
      <NumberField
        label={words[name]}
        value={settings[name]}
        least={least}
        most={most}
        wrong={words.wrong(least, most)}
        onChange={(value) => onChange({ [name]: value })}
      />
    );
  };
  const choose = (id: string) => {
    allDevices().choose(id);
    const unit = chosenProfile()?.serial?.unit;
    if (unit !== undefined) onChange({ unit });
  };
  const group = (label: string, profiles: readonly Profile[]) => (
    <optgroup label={label}>
      {profiles.map(({ id, name }) => (
        <option key={id} value={id}>
          {name}
        </option>
      ))}
    </optgroup>
  );
  const ownProfiles = allDevices().own.value;
  return (
    <>
      <div class="settings">
        <div class="control wide">
          <label for="poll-profile">{words.profile}</label>
          <select
            id="poll-profile"
            value={profile?.id ?? ''}
            onChange={({ currentTarget }) => choose(currentTarget.value)}
          >
            <option value="">{words.noProfile}</option>
            {group(builtIn, builtInProfiles)}
            {ownProfiles.length > 0 && group(own, ownProfiles)}
          </select>
        </div>
        {number('unit')}
      </div>
      {profile && <Lines key={profile.id} profile={profile} settings={settings} onChange={onChange} />}
      <details>
        <summary>{words.how}</summary>
        <div class="settings">
          {number('registers')}
          {number('bits')}
          {number('gap')}
        </div>
        <p class="said">{words.gapHint}</p>
      </details>
    </>
  );
}

/** The registers of the device, to be ticked. */
function Lines({ profile, settings, onChange }: ChoiceProps & { readonly profile: Profile }) {
  const words = useWords('poll');
  const { typeText } = useWords('devices');
  const [search, setSearch] = useState('');
  const ticked = linesFor(settings, profile.id);
  const tick = (lines: readonly string[]) => onChange({ lines: { ...settings.lines, [profile.id]: lines } });
  const found = searchProfile(profile, search).filter(({ register }) => canRead(register));
  return (
    <fieldset class="poll-lines">
      <legend>{words.lines}</legend>
      <div class="tools">
        <SearchBox id="poll-search" label={words.search} bare hint={words.search} text={search} onText={setSearch} />
        <span class="said">{words.chosen(ticked.length)}</span>
        {ticked.length > 0 && (
          <button type="button" onClick={() => tick([])}>
            {words.chooseNone}
          </button>
        )}
      </div>
      <ul>
        {found.slice(0, SHOWN).map(({ register, index }) => {
          const key = lineKey(register, index);
          const others = ticked.filter((other) => other !== key);
          return (
            <li key={key}>
              <label>
                <input
                  type="checkbox"
                  checked={others.length < ticked.length}
                  onChange={({ currentTarget }) => tick(currentTarget.checked ? [...others, key] : others)}
                />{' '}
                {index === undefined ? lineName(register) : valueName(register, index)}{' '}
                <span class="said">{typeText(register)}</span>
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
