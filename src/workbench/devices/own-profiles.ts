import {
  builtInProfiles,
  type DeviceFileFault,
  isProfile,
  type LineFault,
  PROFILE_VERSION,
  type Profile,
  readProfiles,
  writeProfiles,
} from '../../devices/index.ts';
import { readJson } from '../../notation/index.ts';
import type { KeptList, ListCodec, ListReading, Refusal, Removed } from '../kept-list.ts';
import { freeName } from '../names.ts';

/** A stored profile that cannot be used, and the first reason; it stays in the storage as it is. */
export interface BadProfile {
  /** What it is called, as far as that can be read. */
  readonly name: string;
  readonly fault: LineFault | DeviceFileFault;
  readonly raw: unknown;
}

/** The profiles of a person's own, however they are kept. */
export type ProfileList = Pick<KeptList<Profile, DeviceFileFault, BadProfile>, 'kept' | 'change' | 'remove'>;

/** A profile as it is kept alone, and its place among the others: the lower, the earlier. */
export interface ProfileRecord {
  readonly version: number;
  readonly place: number;
  readonly profile: Profile;
}

/** A kept profile as it reads. */
export type RecordReading =
  | { readonly place: number; readonly profile: Profile }
  | { readonly place: number; readonly bad: BadProfile };

export const profileRecord = (profile: Profile, place: number): ProfileRecord => ({
  version: PROFILE_VERSION,
  place,
  profile,
});

/** Reads what `profileRecord` of any version made. Only what is not a profile as it stands is read cell by cell. */
export function readRecord(record: unknown): RecordReading {
  const { version, place: given, profile } = Object(record) as Readonly<Record<string, unknown>>;
  const place = typeof given === 'number' && Number.isFinite(given) ? given : 0;
  if (version === PROFILE_VERSION && isProfile(profile)) return { place, profile };
  const reading = readStored(textOf(profile, version));
  if (reading.kind === 'unreadable')
    return { place, bad: { name: nameOf(profile), fault: reading.fault, raw: profile } };
  const [[one], [bad]] = [reading.items, reading.bad];
  return one
    ? { place, profile: one }
    : { place, bad: bad ?? { name: '', fault: { code: 'not-profiles' }, raw: profile } };
}

/** A kept value as the text of a file; a blank one for what no text can hold. */
function textOf(profile: unknown, version: unknown): string {
  try {
    return writeProfiles([profile as Profile], version);
  } catch {
    return '';
  }
}

const nameOf = (profile: unknown): string => {
  const { name } = Object(profile) as Readonly<Record<string, unknown>>;
  return typeof name === 'string' ? name : '';
};

/** Profiles as the text of their file; each one that has any fault is bad as a whole. Earlier pages kept all as one text. */
export const profileCodec: ListCodec<Profile, DeviceFileFault, BadProfile> = {
  read: readStored,
  write: (profiles, bad) => writeProfiles([...profiles, ...bad.map(({ raw }) => raw as Profile)]),
};

function readStored(text: string): ListReading<Profile, DeviceFileFault, BadProfile> {
  const json = readJson(text);
  if (json.kind === 'unreadable') return json;
  const { profiles: rows, ...envelope } = Object(json.value) as Readonly<Record<string, unknown>>;
  const reading = readProfiles(JSON.stringify({ ...envelope, profiles: [] }));
  if (reading.kind === 'unreadable') return reading;
  if (!Array.isArray(rows)) return { kind: 'unreadable', fault: { code: 'not-profiles' } };
  const items: Profile[] = [];
  const bad: BadProfile[] = [];
  for (const stored of rows) {
    const row = readProfiles(JSON.stringify({ ...envelope, profiles: [stored] }));
    const [one] = row.kind === 'profiles' ? row.profiles : [];
    const fault = one === undefined ? { code: 'not-profiles' as const } : one.faults[0];
    if (fault !== undefined) bad.push({ name: one?.profile.name ?? '', fault, raw: withVersion(stored, envelope) });
    // A list that was edited by hand may have a name twice.
    else if (one !== undefined) items.push(asOwn(one.profile, items));
  }
  return { kind: 'list', items, bad };
}

/** A stored profile that says of which version it is, since the list is written in the newest. */
const withVersion = (stored: unknown, { version }: Readonly<Record<string, unknown>>): unknown =>
  version === 1 && typeof stored === 'object' && stored !== null && !Array.isArray(stored)
    ? { version, ...stored }
    : stored;

/** The profile under an id and a name that no other has. */
export function asOwn(profile: Profile, profiles: readonly Profile[]): Profile {
  const all = [...builtInProfiles, ...profiles];
  const id = freeName(profile.id || 'own', new Set(all.map((each) => each.id)));
  const name = freeName(profile.name, new Set(all.map((each) => each.name)));
  return id === profile.id && name === profile.name ? profile : { ...profile, id, name };
}

/** Adds a profile; if its name is taken, both are kept. Answers the profile as it was stored. */
export const addProfile = (list: ProfileList, profile: Profile): Profile | Refusal =>
  list.change((profiles) => {
    const own = asOwn(profile, profiles);
    return { items: [...profiles, own], result: own };
  });

/** Puts a changed profile in the place of the one that has its id. */
export const replaceProfile = (list: ProfileList, profile: Profile): Profile | Refusal =>
  list.change((profiles) =>
    profiles.some(({ id }) => id === profile.id)
      ? { items: profiles.map((each) => (each.id === profile.id ? profile : each)), result: profile }
      : 'gone',
  );

export const deleteProfile = (list: ProfileList, wanted: string): Removed<Profile> | Refusal =>
  list.remove(({ id }) => id === wanted);

/** Brings a deleted profile back to its place. */
export const restoreProfile = (list: ProfileList, { item, index }: Removed<Profile>): Profile | Refusal =>
  list.change((profiles) => {
    const own = asOwn(item, profiles);
    return { items: profiles.toSpliced(index, 0, own), result: own };
  });

/** The profiles that can be used now. */
export const profilesIn = ({ kept }: ProfileList): readonly Profile[] => (kept.kind === 'list' ? kept.items : []);
