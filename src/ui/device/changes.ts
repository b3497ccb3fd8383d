import type { Profile } from '../../devices/index.ts';
import type { Refusal } from '../../workbench/index.ts';
import { choose, isOwn, refresh } from './chosen.ts';
import { deviceWords as words } from './language.ts';
import { addProfile, deleteProfile, replaceProfile, restoreProfile } from './store.ts';

/** What was done, and how to take it back. */
export interface Done {
  readonly said: readonly string[];
  readonly undo?: { readonly label: string; readonly run: () => Done } | undefined;
}

const refused = (refusal: Refusal): Done => ({ said: [words.refusals[refusal]] });

/** Stores a changed profile; a built-in one stays as it is, and the change is in a copy. */
export function keepChange(before: Profile, after: Profile, said: string): Done {
  if (isOwn(before)) {
    const kept = replaceProfile(after);
    if (typeof kept === 'string') return refused(kept);
    refresh();
    return { said: [said], undo: { label: words.undoChange, run: () => putBack(before) } };
  }
  const copy = addProfile(after);
  if (typeof copy === 'string') return refused(copy);
  choose(copy.id);
  const undo = () => {
    const gone = deleteProfile(copy.id);
    if (typeof gone === 'string') return refused(gone);
    choose(before.id);
    return { said: [words.undone] };
  };
  return { said: [said, words.copied(before.name, copy.name)], undo: { label: words.undoChange, run: undo } };
}

function putBack(before: Profile): Done {
  const kept = replaceProfile(before);
  if (typeof kept === 'string') return refused(kept);
  refresh();
  return { said: [words.undone] };
}

export function createProfile(): Done {
  const added = addProfile({
    id: '',
    name: words.newName,
    source: '',
    convention: 'zero-based',
    traits: [],
    registers: [],
    notes: [],
  });
  if (typeof added === 'string') return refused(added);
  choose(added.id);
  return { said: [words.created(added.name)] };
}

export function removeProfile({ id, name }: Profile): Done {
  const deleted = deleteProfile(id);
  if (typeof deleted === 'string') return refused(deleted);
  choose('');
  const run = (): Done => {
    const back = restoreProfile(deleted);
    if (typeof back === 'string') return refused(back);
    choose(back.id);
    return { said: [words.restored(back.name)] };
  };
  return { said: [words.deleted(name)], undo: { label: words.undo(name), run } };
}
