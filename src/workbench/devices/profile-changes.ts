import type { Profile } from '../../devices/index.ts';
import type { Refusal } from '../kept-list.ts';
import {
  addProfile,
  deleteProfile,
  type ProfileList,
  profilesIn,
  replaceProfile,
  restoreProfile,
} from './own-profiles.ts';

/** What is said of a change. */
export interface ProfileWords {
  readonly refusals: Readonly<Record<Refusal, string>>;
  readonly undoChange: string;
  readonly undone: string;
  readonly copied: (from: string, to: string) => string;
  readonly newName: string;
  readonly created: (name: string) => string;
  readonly deleted: (name: string) => string;
  readonly undo: (name: string) => string;
  readonly restored: (name: string) => string;
}

/** Where profiles are changed: the list, and the choice of one that goes with it. */
export interface ProfileDesk {
  readonly list: ProfileList;
  /** Chooses a profile by its id, or none by a blank one. */
  readonly choose: (id: string) => void;
  readonly words: ProfileWords;
}

/** What was done, and how to take it back. */
export interface Done {
  readonly said: readonly string[];
  readonly undo?: { readonly label: string; readonly run: () => Done } | undefined;
}

const refused = ({ words }: ProfileDesk, refusal: Refusal): Done => ({ said: [words.refusals[refusal]] });

/** Stores a changed profile; a built-in one stays as it is, and the change is in a copy. */
export function keepChange(desk: ProfileDesk, before: Profile, after: Profile, said: string): Done {
  const { list, choose, words } = desk;
  if (profilesIn(list).some(({ id }) => id === before.id)) {
    const kept = replaceProfile(list, after);
    if (typeof kept === 'string') return refused(desk, kept);
    return { said: [said], undo: { label: words.undoChange, run: () => putBack(desk, before) } };
  }
  const copy = addProfile(list, after);
  if (typeof copy === 'string') return refused(desk, copy);
  choose(copy.id);
  const undo = () => {
    const gone = deleteProfile(list, copy.id);
    if (typeof gone === 'string') return refused(desk, gone);
    choose(before.id);
    return { said: [words.undone] };
  };
  return { said: [said, words.copied(before.name, copy.name)], undo: { label: words.undoChange, run: undo } };
}

function putBack(desk: ProfileDesk, before: Profile): Done {
  const { list, words } = desk;
  const kept = replaceProfile(list, before);
  if (typeof kept === 'string') return refused(desk, kept);
  return { said: [words.undone] };
}

/** Adds a profile without registers, and chooses it. */
export function createProfile(desk: ProfileDesk): Done {
  const { list, choose, words } = desk;
  const added = addProfile(list, {
    id: '',
    name: words.newName,
    source: '',
    convention: 'zero-based',
    traits: [],
    registers: [],
    notes: [],
  });
  if (typeof added === 'string') return refused(desk, added);
  choose(added.id);
  return { said: [words.created(added.name)] };
}

/** Deletes a profile; no device is chosen then. */
export function removeProfile(desk: ProfileDesk, { id, name }: Profile): Done {
  const { list, choose, words } = desk;
  const deleted = deleteProfile(list, id);
  if (typeof deleted === 'string') return refused(desk, deleted);
  choose('');
  const run = (): Done => {
    const back = restoreProfile(list, deleted);
    if (typeof back === 'string') return refused(desk, back);
    choose(back.id);
    return { said: [words.restored(back.name)] };
  };
  return { said: [words.deleted(name)], undo: { label: words.undo(name), run } };
}
