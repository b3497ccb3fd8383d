import { useState } from 'preact/hooks';
import { conventions, deviceTraits, type Profile, readSerial, type SerialSettings } from '../../../devices/index.ts';
import { readSerialFormat } from '../../../modbus/index.ts';
import { Select } from '../../kit/choice.tsx';
import { Field, saidId } from '../../kit/field.tsx';
import { useWords } from '../words.ts';

interface SettingsProps {
  readonly profile: Profile;
  readonly onChange: (profile: Profile) => void;
}

/** The settings of a person's device; each is kept when its field is left. */
export function ProfileSettings({ profile, onChange }: SettingsProps) {
  const words = useWords('devices');
  /** What was typed for the serial line, if it cannot be read. */
  const [bad, setBad] = useState<string>();
  const change = (changed: Partial<Profile>) => onChange({ ...profile, ...changed });
  const takeNotes = (text: string) => {
    const notes = text
      .split('\n')
      .map((line) => line.trim())
      .filter((line) => line !== '');
    if (notes.join('\n') !== profile.notes.join('\n')) change({ notes });
  };
  const takeSerial = (text: string) => {
    const { serial: before, ...others } = profile;
    const serial = text.trim() === '' ? undefined : serialOf(text);
    const wrong = serial === undefined && text.trim() !== '';
    setBad(wrong ? text : undefined);
    if (!wrong && words.serial(serial) !== words.serial(before)) onChange({ ...others, ...(serial ? { serial } : {}) });
  };
  return (
    <div class="device-own field-grid">
      <label>
        {words.rename}
        <input
          value={profile.name}
          maxLength={200}
          autocomplete="off"
          onChange={({ currentTarget }) => {
            const name = currentTarget.value.trim();
            if (name === '') currentTarget.value = profile.name;
            else if (name !== profile.name) change({ name });
          }}
        />
      </label>
      <label>
        {words.manual}
        <Select
          value={profile.convention}
          options={conventions.map((value) => ({ value, name: words.conventions[value] }))}
          onChoose={(convention) => change({ convention })}
        />
      </label>
      <Field
        id="device-serial"
        label={words.serialLine}
        hint={words.serialHint}
        error={bad === undefined ? undefined : words.serialWrong}
      >
        <input
          id="device-serial"
          value={bad ?? words.serial(profile.serial)}
          autocomplete="off"
          spellcheck={false}
          aria-invalid={bad !== undefined}
          aria-describedby={saidId('device-serial')}
          onChange={({ currentTarget }) => takeSerial(currentTarget.value)}
        />
      </Field>
      <label>
        {words.from}
        <input
          value={profile.source}
          autocomplete="off"
          onChange={({ currentTarget }) => {
            const source = currentTarget.value.trim();
            if (source !== profile.source) change({ source });
          }}
        />
      </label>
      <fieldset class="device-traits">
        <legend>{words.departs}</legend>
        {deviceTraits.map((trait) => (
          <label key={trait}>
            <input
              type="checkbox"
              checked={profile.traits.includes(trait)}
              onChange={({ currentTarget: { checked } }) =>
                change({
                  traits: deviceTraits.filter((t) => (t === trait ? checked : profile.traits.includes(t))),
                })
              }
            />{' '}
            {words.traits[trait]}
          </label>
        ))}
      </fieldset>
      <Field id="device-notes" class="device-notes-field" label={words.notes} hint={words.notesHint}>
        <textarea
          id="device-notes"
          rows={Math.min(12, Math.max(3, profile.notes.length + 1))}
          aria-describedby={saidId('device-notes')}
          value={profile.notes.join('\n')}
          onChange={({ currentTarget }) => takeNotes(currentTarget.value)}
        />
      </Field>
    </div>
  );
}

/** Settings as people write them: `9600 8N1`, `19200 8E1, unit 6`. */
function serialOf(text: string): SerialSettings | undefined {
  const [, baud = '', name = '', unit = ''] =
    /^(\d+)[\s,]+([78][neo][12])(?:[\s,]+unit\s*(\w+))?$/i.exec(text.trim()) ?? [];
  const format = readSerialFormat(name);
  return format && readSerial([baud, String(format.dataBits), format.parity, String(format.stopBits), unit]);
}
