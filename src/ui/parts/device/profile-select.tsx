import { builtInProfiles, type Profile } from '../../../devices/index.ts';
import { Select } from '../../kit/choice.tsx';
import { useWords } from '../words.ts';
import { allDevices, ChosenDevice, onceCame } from './chosen.ts';

interface ProfileSelectProps {
  readonly id: string;
  /** The name of the choice of no device. */
  readonly none: string;
  /** Is called when another device is chosen. */
  readonly onChosen: () => void;
}

/** The choice of a device: the built-in profiles, and those of a person. */
export const ProfileSelect = onceCame(Choice);

function Choice({ id, none, onChosen }: ProfileSelectProps) {
  const { builtIn, own, inLink } = useWords('devices');
  const group = (name: string, profiles: readonly Profile[]) =>
    profiles.map((profile) => ({ value: profile.id, name: profile.name, group: name }));
  return (
    <>
      <ChosenDevice />
      <Select
        id={id}
        value={allDevices.chosen.value?.id ?? ''}
        options={[
          { value: '', name: none },
          ...group(builtIn, builtInProfiles),
          ...group(own, allDevices.own.value),
          ...group(inLink, allDevices.linked.value ? [allDevices.linked.value] : []),
        ]}
        onChoose={(chosen) => {
          allDevices.choose(chosen);
          onChosen();
        }}
      />
    </>
  );
}
