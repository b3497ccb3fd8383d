import { builtInProfiles, type Profile } from '../../../devices/index.ts';
import { frameNames, registerNamesOf } from '../../../workbench/index.ts';
import { Cell } from '../../state/cell.ts';
import { draft, edit } from '../../state/draft.ts';
import { Remembered } from '../../state/remembered.ts';
import { deviceWords } from './device-words.ts';
import { keptProfiles } from './kept-profiles.ts';
import { device, devicesCame, naming, registerNames } from './naming.ts';

const remembered = new Remembered<string>('device', '', (value) => (typeof value === 'string' ? value : undefined));

/** The id of the profile chosen; blank for none. */
export const chosenId = new Cell(remembered.value);

export function ownProfiles(): readonly Profile[] {
  const { value } = keptProfiles.stored;
  return value.kind === 'list' ? value.items : [];
}

export const isOwn = ({ id }: Profile): boolean => ownProfiles().some((own) => own.id === id);

const allProfiles = () => [...builtInProfiles, ...ownProfiles()];

export const chosenProfile = (): Profile | undefined => allProfiles().find(({ id }) => id === chosenId.value);

/** Chooses a device by hand: this browser remembers it. What was typed with another device is the frame's own from now on. */
export function choose(id: string): void {
  remembered.value = id;
  speakTo(id);
  const { value } = draft;
  if (value.device !== undefined && value.device !== id) edit({ ...value, device: id || undefined });
}

/** Speaks to the device that a link or a saved frame names, until another is chosen; one that is not known here changes nothing. */
export function speakToKnown(id: string): void {
  if (allProfiles().some((profile) => profile.id === id)) speakTo(id);
}

function speakTo(id: string): void {
  chosenId.value = id;
  refresh();
}

/** Makes the profile chosen, as it is now, the device that frames are named and values are typed for. */
export function refresh(): void {
  const profile = chosenProfile();
  devicesCame.value = true;
  device.value = profile;
  naming.value = profile && frameNames(profile, deviceWords);
  registerNames.value = profile && registerNamesOf(profile);
}
