import {
  builtInProfiles,
  type DeviceFileFault,
  type Profile,
  readProfiles,
  writeProfiles,
} from '../../devices/index.ts';
import { Cell } from '../cell.ts';
import { freeName } from '../saved/saved-file.ts';

const KEY = 'framewright.devices';

/** What the browser holds: profiles, a text that is none and is left alone, or nothing because it refuses. */
export type StoredProfiles =
  | { readonly kind: 'profiles'; readonly profiles: readonly Profile[] }
  | { readonly kind: 'unreadable'; readonly fault: DeviceFileFault | 'rows'; readonly text: string }
  | { readonly kind: 'refused' };

/** Why a change was not stored. Nothing was changed then. */
export type StoreRefusal = 'refused' | 'full' | 'unreadable' | 'gone';

/** A deleted profile and its place in the list. */
export interface DeletedProfile {
  readonly profile: Profile;
  readonly index: number;
}

export const stored = new Cell<StoredProfiles>(load());

function load(): StoredProfiles {
  let text: string | null;
  try {
    text = localStorage.getItem(KEY);
  } catch {
    return { kind: 'refused' };
  }
  if (text === null) return { kind: 'profiles', profiles: [] };
  const reading = readProfiles(text);
  if (reading.kind === 'unreadable') return { ...reading, text };
  // Saving the list again would lose what could not be read.
  if (reading.profiles.some(({ faults }) => faults.length > 0)) return { kind: 'unreadable', fault: 'rows', text };
  return { kind: 'profiles', profiles: reading.profiles.map(({ profile }) => profile) };
}

/** Follows what other tabs store. Answers how to stop. */
export function followOtherTabs(onChange: () => void): () => void {
  const follow = ({ key }: StorageEvent) => {
    if (key !== KEY && key !== null) return;
    stored.value = load();
    onChange();
  };
  addEventListener('storage', follow);
  return () => removeEventListener('storage', follow);
}

/** Moves a stored text that cannot be read to a key of its own, which it answers, and begins anew. */
export function setUnreadableAside(): string | undefined {
  const now = load();
  stored.value = now;
  if (now.kind !== 'unreadable') return undefined;
  try {
    let number = 1;
    while (localStorage.getItem(`${KEY}.unreadable-${number}`) !== null) number++;
    const key = `${KEY}.unreadable-${number}`;
    localStorage.setItem(key, now.text);
    localStorage.removeItem(KEY);
    stored.value = load();
    return key;
  } catch {
    return undefined;
  }
}

type Change<T> = { readonly profiles: readonly Profile[]; readonly result: T } | 'gone';

/** Changes the profiles as they are stored now, whatever this tab last saw of them. */
function change<T>(make: (profiles: readonly Profile[]) => Change<T>): T | StoreRefusal {
  const now = load();
  stored.value = now;
  if (now.kind !== 'profiles') return now.kind;
  const changed = make(now.profiles);
  if (changed === 'gone') return 'gone';
  try {
    localStorage.setItem(KEY, writeProfiles(changed.profiles));
  } catch (error) {
    return error instanceof DOMException && /quota/i.test(error.name) ? 'full' : 'refused';
  }
  stored.value = { kind: 'profiles', profiles: changed.profiles };
  return changed.result;
}

/** The profile under an id and a name that no other has. */
function asOwn(profile: Profile, profiles: readonly Profile[]): Profile {
  const all = [...builtInProfiles, ...profiles];
  const id = freeName(profile.id || 'own', new Set(all.map((each) => each.id)));
  return { ...profile, id, name: freeName(profile.name, new Set(all.map((each) => each.name))) };
}

/** Adds a profile; where its name is taken, both are kept. Answers it as it was stored. */
export const addProfile = (profile: Profile): Profile | StoreRefusal =>
  change((profiles) => {
    const own = asOwn(profile, profiles);
    return { profiles: [...profiles, own], result: own };
  });

/** Puts a changed profile in the place of the one that has its id. */
export const replaceProfile = (profile: Profile): Profile | StoreRefusal =>
  change((profiles) =>
    profiles.some(({ id }) => id === profile.id)
      ? { profiles: profiles.map((each) => (each.id === profile.id ? profile : each)), result: profile }
      : 'gone',
  );

export const deleteProfile = (wanted: string): DeletedProfile | StoreRefusal =>
  change((profiles) => {
    const index = profiles.findIndex(({ id }) => id === wanted);
    const profile = profiles[index];
    return profile === undefined ? 'gone' : { profiles: profiles.toSpliced(index, 1), result: { profile, index } };
  });

/** Brings a deleted profile back to its place. */
export const restoreProfile = ({ profile, index }: DeletedProfile): Profile | StoreRefusal =>
  change((profiles) => {
    const own = asOwn(profile, profiles);
    return { profiles: profiles.toSpliced(index, 0, own), result: own };
  });
