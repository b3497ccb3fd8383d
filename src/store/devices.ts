import { computed, effect, type ReadonlySignal, type Signal, signal, untracked } from '@preact/signals-core';
import { builtInProfiles, type Profile } from '../devices/index.ts';
import {
  addProfile,
  type Draft,
  deleteProfile,
  deviceOfLink,
  type FrameNameWords,
  frameNames,
  isMeant,
  type LinkedDevice,
  linkedDevice,
  type Refusal,
  registerNamesOf,
  replaceProfile,
  writeLink,
} from '../workbench/index.ts';
import type { Page } from './page.ts';
import { type ChangeStep, type ProfileChange, ProfileHistory } from './profile-history.ts';
import { ProfileRecords } from './profile-records.ts';
import type { RecordStorage } from './record-storage.ts';
import type { KeptChoice, PageStorage } from './storage.ts';

/** The profiles of devices, and the chosen one. */
export class Devices {
  /** A person's own profiles. */
  readonly list: ProfileRecords;
  /** The id of the chosen profile; blank for none. */
  readonly chosenId: Signal<string>;
  readonly own = computed((): readonly Profile[] => this.list.items.value);
  readonly chosen = computed(() => this.all.value.find(({ id }) => id === this.chosenId.value));
  readonly registerNames = computed(() => this.chosen.value && registerNamesOf(this.chosen.value));
  /** A device that a link brought, which this browser does not keep. */
  readonly linked = computed((): Profile | undefined => {
    const { value } = this.#brought;
    return value && this.own.value.some(({ id }) => id === value.id) ? undefined : value;
  });
  /** Every device that can be chosen. */
  readonly all = computed((): readonly Profile[] => [
    ...builtInProfiles,
    ...this.own.value,
    ...(this.linked.value ? [this.linked.value] : []),
  ]);
  /** Whether the devices that are named here have come, or are surely not kept in this browser. */
  readonly came = computed(() => {
    if (this.list.loaded.value) return true;
    const hasCome = (id: string | undefined) => !id || this.all.value.some((profile) => isMeant(profile, id));
    return hasCome(this.chosenId.value) && hasCome(this.#named.value);
  });
  /** The changes that can be taken back, and made again. */
  readonly history: ProfileHistory;
  readonly #page: Page;
  /** The id that the frame or its link names. */
  readonly #named: ReadonlySignal<string | undefined>;
  /** What the link said that brought the linked device. */
  #given: string | undefined;
  readonly #remembered: KeptChoice<string>;
  readonly #brought: Signal<Profile | undefined> = signal(undefined);
  readonly #linkedOwn = computed(() => {
    const profile = this.chosen.value;
    return profile && this.isOwn(profile) ? linkedDevice(profile) : undefined;
  });

  /** `remembered` is the id of the profile that was chosen by hand; blank if none was. */
  constructor(page: Page, storage: PageStorage, remembered: KeptChoice<string>, records: RecordStorage) {
    this.#page = page;
    this.#remembered = remembered;
    const named = computed(() => page.draft.value.device);
    this.#named = named;
    this.list = new ProfileRecords(records, storage, named.peek() ?? remembered.value);
    this.history = new ProfileHistory(this.list);
    this.chosenId = signal(remembered.value);
    effect(() => {
      const { value: text } = page.profile;
      if (text === undefined || text === this.#given) return;
      const given = { id: untracked(() => named.value) ?? '', text };
      const isOwn = this.own.value.some((own) => isMeant(own, given.id));
      // Until all have come, it may be the person's own.
      if (!isOwn && !this.list.loaded.value) return;
      this.#given = text;
      if (!isOwn) this.#brought.value = deviceOfLink(given);
    });
    // A link or a saved frame may name a device: it is chosen until another is. One that is not known here changes nothing.
    effect(() => {
      const id = named.value;
      const all = this.came.value ? untracked(() => this.all.value) : this.all.value;
      const found = all.find((profile) => isMeant(profile, id));
      if (found) this.chosenId.value = found.id;
    });
    // The frame's link names the chosen device, so that whoever opens it sees the same names and units.
    effect(() => {
      const profile = this.chosen.value;
      const own = this.#linkedOwn.value;
      // Until the device has come, the address is as it was given.
      if (!this.came.value) return;
      untracked(() => {
        page.device.value = profile?.id;
        page.profile.value = profile && profile === this.linked.peek() ? this.#given : undefined;
        page.leavesOut.value = own === 'too-large';
        page.shared.value =
          typeof own === 'object' ? (href) => href.replace(/#.*|$/, `#${this.#linkWith(own)}`) : String;
      });
    });
  }

  /** How the chosen profile names what is in a frame; `undefined` if none is chosen. */
  naming(words: FrameNameWords) {
    const profile = this.chosen.value;
    return profile && frameNames(profile, words);
  }

  /** Chooses a device by hand: this browser remembers it. What was typed with another device is the frame's own from now on. */
  readonly choose = (id: string): void => {
    this.#remembered.value = id;
    this.chosenId.value = id;
    const draft = this.#page.draft.peek();
    if (draft.device !== undefined && draft.device !== id) this.#page.edit({ ...draft, device: id || undefined });
    else this.#page.besideChanged();
  };

  isOwn({ id }: Profile): boolean {
    return this.own.value.some((own) => own.id === id);
  }

  /** Adds a profile without registers, and chooses it. */
  readonly create = (name: string): Profile | Refusal =>
    this.add({ id: '', name, source: '', convention: 'zero-based', traits: [], registers: [], notes: [] });

  /** Adds a profile, and chooses it. Answers it as it was stored. */
  readonly add = (profile: Profile): Profile | Refusal => {
    const added = addProfile(this.list, profile);
    if (typeof added !== 'string') this.choose(added.id);
    return added;
  };

  /** Stores a changed profile; a copy of a built-in one is chosen then. */
  readonly keep = (before: Profile, after: Profile): ProfileChange | Refusal => {
    const own = this.isOwn(before);
    const kept = own ? replaceProfile(this.list, after) : addProfile(this.list, after);
    if (typeof kept === 'string') return kept;
    if (!own) this.choose(kept.id);
    return this.history.made(own ? { kind: 'changed', before } : { kind: 'copied', before, copy: kept });
  };

  /** Deletes a profile; no device is chosen then. */
  readonly delete = ({ id }: Profile): ProfileChange | Refusal => {
    const removed = deleteProfile(this.list, id);
    if (typeof removed === 'string') return removed;
    this.choose('');
    return this.history.made({ kind: 'deleted', removed });
  };

  /** Takes the latest change back. Answers that and the profile as it is then; `gone` if there is no such change. */
  readonly undo = (): ChangeStep | Refusal => {
    const step = this.history.undo();
    if (typeof step !== 'string') this.#showStep(step, step.change.kind === 'changed');
    return step;
  };

  /** Makes the change again that was taken back last. Answers as `undo` does. */
  readonly redo = (): ChangeStep | Refusal => {
    const step = this.history.redo();
    if (typeof step === 'string') return step;
    if (step.change.kind === 'deleted') this.choose('');
    else this.#showStep(step, step.change.kind === 'changed');
    return step;
  };

  /** Chooses the profile of a step; one that was changed only if it would not be seen beside another. */
  #showStep({ profile: { id } }: ChangeStep, isChanged: boolean): void {
    const chosen = this.chosenId.peek();
    if (chosen !== id && !(isChanged && chosen === '')) this.choose(id);
  }

  #linkWith({ id, text }: LinkedDevice): string {
    const { draft, evaluation, tab, line, program } = this.#page;
    const named = (one: Draft): Draft => ({ ...one, device: one.device && id });
    const { partner } = draft.peek();
    return writeLink({ ...named(draft.peek()), partner: partner && named(partner) }, evaluation.peek().controls, {
      tab: tab.peek(),
      line: line.peek(),
      device: id,
      profile: text,
      program: tab.peek() === 'program' ? program.peek() : undefined,
    });
  }
}
