import { builtInProfiles, type Profile } from '../../../devices/index.ts';
import { useWords } from '../words.ts';
import { allDevices, ChosenDevice } from './chosen.ts';

interface ProfileSelectProps {
  readonly id: string;
  /** What stands for no device. */
  readonly none: string;
  /** Is called when another device is chosen. */
  readonly onChosen: () => void;
}

/** Which device is spoken to: one of the built-in profiles, or of a person's own. */
export function ProfileSelect({ id, none, onChosen }: ProfileSelectProps) {
  const words = useWords('devices');
  const { choose, chosen, own } = allDevices;
  const group = (label: string, profiles: readonly Profile[]) => (
    <optgroup label={label}>
      {profiles.map((profile) => (
        <option key={profile.id} value={profile.id}>
          {profile.name}
        </option>
      ))}
    </optgroup>
  );
  return (
    <>
      <ChosenDevice />
      <select
        id={id}
        value={chosen.value?.id ?? ''}
        onChange={({ currentTarget }) => {
          choose(currentTarget.value);
          onChosen();
        }}
      >
        <option value="">{none}</option>
        {group(words.builtIn, builtInProfiles)}
        {own.value.length > 0 && group(words.own, own.value)}
      </select>
    </>
  );
}
