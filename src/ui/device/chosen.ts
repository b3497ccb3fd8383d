import { builtInProfiles, nameAt, type Profile, placesNamed } from '../../devices/index.ts';
import { Cell } from '../cell.ts';
import { Remembered } from '../tools/remembered.ts';
import { frameNames } from './frame-names.ts';
import { device, naming, type RegisterNames, registerNames } from './naming.ts';
import { keptProfiles } from './store.ts';

const remembered = new Remembered<string>('device', '', (value) => (typeof value === 'string' ? value : undefined));

/** The id of the profile chosen; blank for none. */
export const chosenId = new Cell(remembered.value);

export function ownProfiles(): readonly Profile[] {
  const { value } = keptProfiles.stored;
  return value.kind === 'list' ? value.items : [];
}

export const isOwn = ({ id }: Profile): boolean => ownProfiles().some((own) => own.id === id);

export const chosenProfile = (): Profile | undefined =>
  [...builtInProfiles, ...ownProfiles()].find(({ id }) => id === chosenId.value);

export function choose(id: string): void {
  remembered.value = id;
  chosenId.value = id;
  refresh();
}

/** Makes the profile chosen, as it is now, the device that frames are named and values are typed for. */
export function refresh(): void {
  const profile = chosenProfile();
  device.value = profile;
  naming.value = profile && frameNames(profile);
  registerNames.value = profile && registerNamesOf(profile);
}

const registerNamesOf = (profile: Profile): RegisterNames => ({
  device: profile.name,
  placeOf: (name, table) => {
    const places = placesNamed(profile, name);
    return places.find((place) => place.table === table) ?? places[0];
  },
  nameAt: (table, address) => (table === 'file-record' ? undefined : nameAt(profile, table, address)),
});
