import { batch, computed, type Signal, signal } from '@preact/signals-core';
import type { Profile } from '../devices/index.ts';
import { deleteProfile, type Refusal, type Removed, replaceProfile, restoreProfile } from '../workbench/index.ts';
import type { ProfileRecords } from './profile-records.ts';

/** A change of a profile; a built-in one stays as it is, and the change is in a copy. */
export type ProfileChange =
  | { readonly kind: 'changed'; readonly before: Profile }
  | { readonly kind: 'copied'; readonly before: Profile; readonly copy: Profile }
  | { readonly kind: 'deleted'; readonly removed: Removed<Profile> };

/** A change that was taken back or made again, and the profile as it is then. */
export interface ChangeStep {
  readonly change: ProfileChange;
  readonly profile: Profile;
}

/** A change that was taken back, and what makes it again: the change as it is then, or why it cannot be made. */
interface Undone {
  readonly change: ProfileChange;
  readonly again: () => ChangeStep | Refusal;
}

/** Older changes stay as they are. */
const MOST = 100;

/** The changes of a person's profiles in this window, which are taken back one by one, and made again. */
export class ProfileHistory {
  readonly #past: Signal<readonly ProfileChange[]> = signal([]);
  readonly #undone: Signal<readonly Undone[]> = signal([]);
  /** The change that is taken back next, and the one that is made again next. */
  readonly latest = computed(() => this.#past.value.at(-1));
  readonly next = computed(() => this.#undone.value.at(-1)?.change);
  readonly #list: ProfileRecords;

  constructor(list: ProfileRecords) {
    this.#list = list;
  }

  /** Notes a change that was made; those that were taken back are not made again. */
  made(change: ProfileChange): ProfileChange {
    batch(() => {
      this.#past.value = [...this.#past.peek(), change].slice(-MOST);
      this.#undone.value = [];
    });
    return change;
  }

  /** Takes the latest change back; `gone` if there is none, or if its profile is not there any more. */
  undo(): ChangeStep | Refusal {
    const change = this.latest.peek();
    if (change === undefined) return 'gone';
    const done = this.#takeBack(change);
    if (typeof done === 'string') return done;
    batch(() => {
      this.#past.value = this.#past.peek().slice(0, -1);
      this.#undone.value = [...this.#undone.peek(), { change, again: done.again }];
    });
    return { change, profile: done.profile };
  }

  /** Makes the change again that was taken back last; `gone` as with `undo`. */
  redo(): ChangeStep | Refusal {
    const step = this.#undone.peek().at(-1)?.again() ?? 'gone';
    if (typeof step === 'string') return step;
    batch(() => {
      this.#undone.value = this.#undone.peek().slice(0, -1);
      this.#past.value = [...this.#past.peek(), step.change];
    });
    return step;
  }

  #takeBack(change: ProfileChange): (Pick<ChangeStep, 'profile'> & Pick<Undone, 'again'>) | Refusal {
    const list = this.#list;
    switch (change.kind) {
      case 'changed': {
        const after = list.items.peek().find(({ id }) => id === change.before.id);
        const profile = replaceProfile(list, change.before);
        return typeof profile === 'string'
          ? profile
          : { profile, again: () => stepOf(change, after ? replaceProfile(list, after) : 'gone') };
      }
      case 'copied': {
        const removed = deleteProfile(list, change.copy.id);
        return typeof removed === 'string'
          ? removed
          : { profile: change.before, again: () => stepOf(change, restoreProfile(list, removed)) };
      }
      case 'deleted': {
        const profile = restoreProfile(list, change.removed);
        if (typeof profile === 'string') return profile;
        const again = (): ChangeStep | Refusal => {
          const removed = deleteProfile(list, profile.id);
          return typeof removed === 'string' ? removed : { change: { kind: 'deleted', removed }, profile };
        };
        return { profile, again };
      }
    }
  }
}

const stepOf = (change: ProfileChange, profile: Profile | Refusal): ChangeStep | Refusal =>
  typeof profile === 'string' ? profile : { change, profile };
