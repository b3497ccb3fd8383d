import { useId } from 'preact/hooks';
import { builtInProfiles, type Profile } from '../../../devices/index.ts';
import { useWords } from '../words.ts';
import { allDevices, ChosenDevice } from './chosen.ts';
import './device-options.css';

interface DeviceOptionsProps {
  /** Is called when a device, or none, is chosen. */
  readonly onChosen: () => void;
}

/** Every device, each a button that chooses it: none, those of a person, the built-in ones. */
export function DeviceOptions({ onChosen }: DeviceOptionsProps) {
  const { none, builtIn, own } = useWords('devices');
  const choose = (id: string) => {
    allDevices.choose(id);
    onChosen();
  };
  const ownProfiles = allDevices.own.value;
  return (
    <div class="device-options">
      <ChosenDevice />
      <One id="" name={none} onChoose={choose} />
      {ownProfiles.length > 0 && <Group title={own} profiles={ownProfiles} onChoose={choose} />}
      <Group title={builtIn} profiles={builtInProfiles} onChoose={choose} />
    </div>
  );
}

interface GroupProps {
  readonly title: string;
  readonly profiles: readonly Profile[];
  readonly onChoose: (id: string) => void;
}

function Group({ title, profiles, onChoose }: GroupProps) {
  const id = useId();
  return (
    // biome-ignore lint/a11y/useSemanticElements: a fieldset would frame it.
    <div role="group" aria-labelledby={id}>
      <p id={id} class="soft">
        {title}
      </p>
      {profiles.map((profile) => (
        <One key={profile.id} id={profile.id} name={profile.name} onChoose={onChoose} />
      ))}
    </div>
  );
}

interface OneProps {
  readonly id: string;
  readonly name: string;
  readonly onChoose: (id: string) => void;
}

const One = ({ id, name, onChoose }: OneProps) => (
  <button type="button" aria-pressed={(allDevices.chosen.value?.id ?? '') === id} onClick={() => onChoose(id)}>
    {name}
  </button>
);
