import {
  type DeviceFileFault,
  faultNotices,
  type Profile,
  type ProfileReading,
  readProfiles,
} from '../../devices/index.ts';
import { ownProfiles } from './chosen.ts';
import { readCsv } from './csv.ts';
import { deviceWords as words } from './language.ts';
import { addProfile } from './store.ts';

/** A device's table is small; anything bigger is another file chosen by mistake. */
export const LARGEST = 5_000_000;
/** Most faults that are listed. */
const LISTED = 50;

export interface Imported {
  /** What is said of it, in order. */
  readonly said: readonly string[];
  /** The profile to be shown then. */
  readonly show: Profile | undefined;
}

/** Imports what a text says, JSON or CSV, as profiles of a person's own. */
export function importText(text: string, name: string): Imported {
  const json = /^\uFEFF?\s*[{[]/.test(text) ? readProfiles(text) : undefined;
  if (json?.kind === 'unreadable') return nothing(json.fault);
  const where = json ? 'row' : 'line';
  const outcomes = (json?.profiles ?? [readCsv(text, name)]).map((reading) => importOne(reading, where));
  return {
    said: outcomes.length === 0 ? [words.nothing] : outcomes.flatMap(({ said }) => said),
    show: outcomes.findLast(({ show }) => show !== undefined)?.show,
  };
}

const nothing = (fault: DeviceFileFault): Imported => ({ said: [words.badFile(fault)], show: undefined });

function importOne({ profile, faults }: ProfileReading, where: 'line' | 'row'): Imported {
  const listed = faults.slice(0, LISTED).map((fault) => words.faultAt(fault, where));
  const more = faults.length > LISTED ? [words.moreFaults(faults.length - LISTED)] : [];
  const lost = new Set(faults.filter(({ code }) => !faultNotices.has(code)).map(({ line }) => line)).size;
  const all = [...(lost > 0 ? [words.notImported(lost)] : []), ...listed, ...more];
  if (profile.registers.length === 0 && lost > 0) return { said: [words.nothing, ...all], show: undefined };
  const same = ownProfiles().find((own) => equal(own, profile));
  if (same) return { said: [words.already(same.name), ...all], show: same };
  const added = addProfile(profile);
  if (typeof added === 'string') return { said: [words.refusals[added]], show: undefined };
  const renamed = added.name === profile.name ? [] : [words.nameTaken(profile.name, added.name)];
  return { said: [words.imported(added.name, added.registers.length), ...renamed, ...all], show: added };
}

/** Whether two profiles say the same under the same name; ids are the page's own. */
const equal = (one: Profile, other: Profile) => contents(one) === contents(other);

const contents = ({ name, source, convention, serial, traits, registers, notes }: Profile): string =>
  JSON.stringify([name, source, convention, serial, traits, registers, notes]);
