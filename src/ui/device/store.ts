import {
  builtInProfiles,
  type DeviceFileFault,
  type Profile,
  readProfiles,
  writeProfiles,
} from '../../devices/index.ts';
import { freeName, type Refusal, type Removed } from '../../workbench/index.ts';
import { BrowserList } from '../kept/browser-list.ts';

/** The profiles of a person's own, kept in this browser. */
export const keptProfiles = new BrowserList<Profile, DeviceFileFault | 'rows'>('devices', {
  read(text) {
    const reading = readProfiles(text);
    if (reading.kind === 'unreadable') return reading;
    // Saving the list again would lose what could not be read.
    if (reading.profiles.some(({ faults }) => faults.length > 0)) return { kind: 'unreadable', fault: 'rows' };
    return { kind: 'list', items: reading.profiles.map(({ profile }) => profile), bad: [] };
  },
  write: writeProfiles,
});

/** The profile under an id and a name that no other has. */
function asOwn(profile: Profile, profiles: readonly Profile[]): Profile {
  const all = [...builtInProfiles, ...profiles];
  const id = freeName(profile.id || 'own', new Set(all.map((each) => each.id)));
  return { ...profile, id, name: freeName(profile.name, new Set(all.map((each) => each.name))) };
}

/** Adds a profile; where its name is taken, both are kept. Answers it as it was stored. */
export const addProfile = (profile: Profile): Profile | Refusal =>
  keptProfiles.change((profiles) => {
    const own = asOwn(profile, profiles);
    return { items: [...profiles, own], result: own };
  });

/** Puts a changed profile in the place of the one that has its id. */
export const replaceProfile = (profile: Profile): Profile | Refusal =>
  keptProfiles.change((profiles) =>
    profiles.some(({ id }) => id === profile.id)
      ? { items: profiles.map((each) => (each.id === profile.id ? profile : each)), result: profile }
      : 'gone',
  );

export const deleteProfile = (wanted: string): Removed<Profile> | Refusal =>
  keptProfiles.remove(({ id }) => id === wanted);

/** Brings a deleted profile back to its place. */
export const restoreProfile = ({ item, index }: Removed<Profile>): Profile | Refusal =>
  keptProfiles.change((profiles) => {
    const own = asOwn(item, profiles);
    return { items: profiles.toSpliced(index, 0, own), result: own };
  });
