import { computed, effect, type Signal, signal, untracked } from '@preact/signals-core';
import { builtInProfiles, type Profile } from '../devices/index.ts';
import { type FrameNameWords, frameNames, profileCodec, registerNamesOf, text } from '../workbench/index.ts';
import type { Page } from './page.ts';
import { KeptChoice, type PageStorage, StoredList } from './storage.ts';

/** The profiles of devices, and the one that is spoken to. */
export class Devices {
  /** A person's own profiles. */
  readonly list;
  /** The id of the chosen profile; blank for none. Another tab's choice does not change it. */
  readonly chosenId: Signal<string>;
  readonly own = computed((): readonly Profile[] => {
    const { value } = this.list.stored;
    return value.kind === 'list' ? value.items : [];
  });
  readonly chosen = computed(() => this.#all().find(({ id }) => id === this.chosenId.value));
  readonly registerNames = computed(() => this.chosen.value && registerNamesOf(this.chosen.value));
  /** How the chosen profile names what is in a frame. */
  readonly naming = computed(() => this.chosen.value && frameNames(this.chosen.value, this.#words));
  readonly #page: Page;
  readonly #remembered: KeptChoice<string>;
  readonly #words: FrameNameWords;

  constructor(page: Page, storage: PageStorage, words: FrameNameWords) {
    this.#page = page;
    this.#words = words;
    this.list = new StoredList(storage, 'devices', profileCodec);
    this.#remembered = new KeptChoice(storage, 'device', '', text(), 'tab');
    this.chosenId = signal(this.#remembered.value);
    const named = computed(() => page.draft.value.device);
    // A link or a saved frame names a device: it is spoken to until another is chosen; one that is not known here changes nothing.
    effect(() => {
      const id = named.value;
      if (untracked(() => this.#all().some((profile) => profile.id === id))) this.chosenId.value = id ?? '';
    });
  }

  /** Chooses a device by hand: this browser remembers it. What was typed with another device is the frame's own from now on. */
  readonly choose = (id: string): void => {
    this.#remembered.value = id;
    this.chosenId.value = id;
    const draft = this.#page.draft.peek();
    if (draft.device !== undefined && draft.device !== id) this.#page.edit({ ...draft, device: id || undefined });
  };

  isOwn({ id }: Profile): boolean {
    return this.own.value.some((own) => own.id === id);
  }

  #all(): readonly Profile[] {
    return [...builtInProfiles, ...this.own.value];
  }
}
