import {
  type DeviceFileFault,
  faultNotices,
  type LineFault,
  type Profile,
  type ProfileReading,
  readProfiles,
} from '../../devices/index.ts';
import type { Refusal } from '../kept-list.ts';
import { addProfile, type ProfileList, profilesIn } from './own-profiles.ts';
import { type ParseCsv, readProfileCsv } from './profile-csv.ts';

/** The sentences about an import. */
export interface ImportWords {
  readonly refusals: Readonly<Record<Refusal, string>>;
  readonly badFile: (fault: DeviceFileFault) => string;
  readonly nothing: string;
  readonly faultAt: (fault: LineFault, where: 'line' | 'row') => string;
  readonly moreFaults: (count: number) => string;
  readonly notImported: (count: number) => string;
  readonly already: (name: string) => string;
  readonly nameTaken: (wanted: string, got: string) => string;
  readonly imported: (name: string, count: number) => string;
}

/** The list to import into, the reader of CSV, and the words. */
export interface ImportDesk {
  readonly list: ProfileList;
  readonly parse: ParseCsv;
  readonly words: ImportWords;
}

/** The largest file that is read, in bytes: a device's table is small, so that a bigger file was chosen by mistake. */
export const LARGEST_PROFILES = 5_000_000;
/** Most faults that are listed. */
const LISTED = 50;

export interface Imported {
  /** The result in sentences. */
  readonly messages: readonly string[];
  /** The profile that is shown then, if there is one. */
  readonly show: Profile | undefined;
}

/** Imports what a text says, JSON or CSV, as profiles of a person's own; `name` is for one without a name. */
export function importProfiles(desk: ImportDesk, text: string, name: string): Imported {
  const { words } = desk;
  const json = /^\uFEFF?\s*[{[]/.test(text) ? readProfiles(text) : undefined;
  if (json?.kind === 'unreadable') return { messages: [words.badFile(json.fault)], show: undefined };
  const where = json ? 'row' : 'line';
  const outcomes = (json?.profiles ?? [readProfileCsv(text, name, desk.parse)]).map((reading) =>
    importOne(desk, reading, where),
  );
  return {
    messages: outcomes.length === 0 ? [words.nothing] : outcomes.flatMap(({ messages }) => messages),
    show: outcomes.findLast(({ show }) => show !== undefined)?.show,
  };
}

function importOne({ list, words }: ImportDesk, { profile, faults }: ProfileReading, where: 'line' | 'row'): Imported {
  const listed = faults.slice(0, LISTED).map((fault) => words.faultAt(fault, where));
  const more = faults.length > LISTED ? [words.moreFaults(faults.length - LISTED)] : [];
  const lost = new Set(faults.filter(({ code }) => !faultNotices.has(code)).map(({ line }) => line)).size;
  const all = [...(lost > 0 ? [words.notImported(lost)] : []), ...listed, ...more];
  if (profile.registers.length === 0 && lost > 0) return { messages: [words.nothing, ...all], show: undefined };
  const same = profilesIn(list).find((own) => equal(own, profile));
  if (same) return { messages: [words.already(same.name), ...all], show: same };
  const added = addProfile(list, profile);
  if (typeof added === 'string') return { messages: [words.refusals[added]], show: undefined };
  const renamed = added.name === profile.name ? [] : [words.nameTaken(profile.name, added.name)];
  return { messages: [words.imported(added.name, added.registers.length), ...renamed, ...all], show: added };
}

/** Whether two profiles say the same under the same name; ids are the page's own. */
const equal = (one: Profile, other: Profile) => contents(one) === contents(other);

const contents = ({ name, source, convention, serial, traits, registers, notes }: Profile): string =>
  JSON.stringify([name, source, convention, serial, traits, registers, notes]);
