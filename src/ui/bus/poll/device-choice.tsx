import { useState } from 'preact/hooks';
import { canRead, deviceUnit, lineName, type Profile, searchProfile, valueName } from '../../../devices/index.ts';
import { wholeNumber } from '../../../notation/index.ts';
import { lineKey, linesFor, type PollSettings, pollLimits } from '../../../workbench/index.ts';
import { NumberEntry } from '../../kit/number-entry.tsx';
import { SearchBox } from '../../kit/search-box.tsx';
import { allDevices } from '../../parts/device/chosen.ts';
import { ProfileSelect } from '../../parts/device/profile-select.tsx';
import { useWords } from '../../parts/words.ts';

/** Most lines drawn at once; a search finds the others. */
const SHOWN = 60;

interface ChoiceProps {
  readonly settings: PollSettings;
  readonly onChange: (change: Partial<PollSettings>) => void;
}

/** The device, its registers that are read, and how requests are made of them. */
export function DeviceChoice({ settings, onChange }: ChoiceProps) {
  const words = useWords('poll');
  const profile = allDevices.chosen.value;
  const number = (name: 'unit' | 'registers' | 'bits' | 'gap') => {
    const [least, most] = pollLimits[name];
    return (
      <NumberEntry
        label={words[name]}
        value={settings[name]}
        read={wholeNumber(least, most)}
        wrong={words.wrong(least, most)}
        onValue={(value) => onChange({ [name]: value })}
      />
    );
  };
  const chosen = () => {
    const unit = allDevices.chosen.value && deviceUnit(allDevices.chosen.value);
    if (unit !== undefined) onChange({ unit });
  };
  return (
    <>
      <div class="settings field-grid">
        <div class="control wide">
          <label for="poll-profile">{words.profile}</label>
          <ProfileSelect id="poll-profile" none={words.noProfile} onChosen={chosen} />
        </div>
        {number('unit')}
      </div>
      {profile && <Lines key={profile.id} profile={profile} settings={settings} onChange={onChange} />}
      <details>
        <summary>{words.how}</summary>
        <div class="settings field-grid">
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
      <div class="tools in-row">
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
