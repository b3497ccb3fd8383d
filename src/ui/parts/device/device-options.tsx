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
      <ProfileButtons profiles={[{ id: '', name: none }]} onChoose={choose} />
      {ownProfiles.length > 0 && <Group title={own} profiles={ownProfiles} onChoose={choose} />}
      <Group title={builtIn} profiles={builtInProfiles} onChoose={choose} />
    </div>
  );
}

interface ButtonsProps {
  readonly profiles: readonly Pick<Profile, 'id' | 'name'>[];
  readonly onChoose: (id: string) => void;
}

/** Buttons that choose a device; that of the chosen one is pressed. */
export const ProfileButtons = ({ profiles, onChoose }: ButtonsProps) => (
  <>
    {profiles.map(({ id, name }) => (
      <button
        key={id}
        type="button"
        aria-pressed={(allDevices.chosen.value?.id ?? '') === id}
        onClick={() => onChoose(id)}
      >
        {name}
      </button>
    ))}
  </>
);

interface GroupProps extends ButtonsProps {
  readonly title: string;
}

function Group({ title, ...buttons }: GroupProps) {
  const id = useId();
  return (
    // biome-ignore lint/a11y/useSemanticElements: a fieldset would frame it.
    <div role="group" aria-labelledby={id}>
      <p id={id} class="soft">
        {title}
      </p>
      <ProfileButtons {...buttons} />
    </div>
  );
}
