import { batch, computed, type Signal, signal } from '@preact/signals-core';
import {
  builtInSequences,
  newSequence,
  readSequences,
  type SequenceFileFault,
  type SequenceTexts,
  writeSequences,
} from '../sequences/index.ts';
import {
  type BadSequence,
  bytesOfLink,
  canBeKept,
  freeName,
  namesOfSequences,
  sequenceCodec,
  text,
} from '../workbench/index.ts';
import type { Naming } from './saved-frames.ts';
import { KeptChoice, type PageStorage } from './storage.ts';
import { StoredList } from './stored-list.ts';

/** Changes that can be undone. */
const MOST_UNDOS = 100;

interface Before {
  readonly custom: readonly SequenceTexts[];
  readonly chosen: string;
  /** Changes with the same text, such as of one field, are undone together. */
  readonly change: string;
}

/** What became of a file of sequences: of each entry, that it was not taken, is here already, or was added. */
export type SequenceImport =
  | { readonly kind: 'unreadable'; readonly fault: SequenceFileFault }
  | { readonly kind: 'entries'; readonly entries: readonly (BadSequence | { readonly already: string } | Naming)[] };

/**
 * The sequences that are built in, and those that were made here; names tell them apart. Changes that the storage refuses
 * last as long as the page.
 */
export class Sequences extends StoredList<SequenceTexts, SequenceFileFault, BadSequence> {
  readonly #chosen: KeptChoice<string>;
  readonly #unkept: Signal<
    { readonly custom: readonly SequenceTexts[]; readonly why: 'refused' | 'full' | 'unreadable' } | undefined
  > = signal(undefined);
  readonly #before: Signal<readonly Before[]> = signal([]);
  /** The sequences that were made here. */
  readonly custom = computed((): readonly SequenceTexts[] => {
    const { value } = this.stored;
    return this.#unkept.value?.custom ?? (value.kind === 'list' ? value.items : []);
  });
  /** The stored sequences that cannot be used. */
  readonly bad = computed(() => (this.stored.value.kind === 'list' ? this.stored.value.bad : []));
  /** Why changes last no longer than the page. */
  readonly notKept = computed(() => {
    const { kind } = this.stored.value;
    return this.#unkept.value?.why ?? (kind === 'list' ? undefined : kind);
  });
  readonly canUndo = computed(() => this.#before.value.length > 0);
  /** The sequence with the chosen name, or else the first. */
  readonly current = computed((): SequenceTexts | undefined => {
    const all = [...builtInSequences, ...this.custom.value];
    return all.find(({ name }) => name === this.#chosen.value) ?? all[0];
  });

  constructor(storage: PageStorage) {
    super(storage, 'sequences', sequenceCodec);
    this.#chosen = new KeptChoice(storage, 'sequence', builtInSequences[0]?.name ?? '', text(), 'tab');
    // Undo must not overwrite the changes of another tab.
    storage.follow(this.key, () =>
      batch(() => {
        this.#unkept.value = undefined;
        this.#before.value = [];
      }),
    );
  }

  isCustom(sequence: SequenceTexts): boolean {
    return this.custom.value.includes(sequence);
  }

  choose(name: string): void {
    this.#chosen.value = name;
  }

  /** Replaces the one that is chosen, or adds a changed copy if that is built in. Answers its name; `undefined` if it is too big. */
  edit(next: SequenceTexts, change = ''): string | undefined {
    const current = this.current.value;
    if (current === undefined || !canBeKept(next)) return undefined;
    if (!this.isCustom(current)) return this.add(next, change);
    const others = new Set(namesOfSequences(this.custom.value));
    others.delete(current.name);
    const kept = { ...next, name: freeName(next.name, others) };
    this.#set(
      this.custom.value.map((each) => (each === current ? kept : each)),
      kept.name,
      change,
    );
    return kept.name;
  }

  /** Adds one under a name that is free, and chooses it. Answers the name. */
  add(sequence: SequenceTexts, change = ''): string {
    const name = freeName(sequence.name, new Set(namesOfSequences(this.custom.value)));
    this.#set([...this.custom.value, { ...sequence, name }], name, change);
    return name;
  }

  create(name: string): void {
    this.add(newSequence(name));
  }

  /** Deletes the one that is chosen. */
  deleteChosen(): void {
    const left = this.custom.value.filter((each) => each !== this.current.value);
    this.#set(left, left.at(-1)?.name ?? builtInSequences[0]?.name ?? '', '');
  }

  undo(): void {
    const before = this.#before.value.at(-1);
    if (before === undefined) return;
    batch(() => {
      this.#before.value = this.#before.value.slice(0, -1);
      this.#store(before.custom, before.chosen);
    });
  }

  /** Adds the sequences of a file and chooses the last; one whose name is taken gets another. */
  import(file: string): SequenceImport {
    const reading = readSequences(file, bytesOfLink);
    if (reading.kind === 'unreadable') return reading;
    const entries = reading.entries.map((entry) => {
      if (entry.kind === 'faults') return entry;
      const { sequence } = entry;
      const text = writeSequences([sequence]);
      const same = [...builtInSequences, ...this.custom.value].find((each) => writeSequences([each]) === text);
      if (same === undefined) return { wanted: sequence.name, got: this.add(sequence) };
      this.choose(same.name);
      return { already: same.name };
    });
    return { kind: 'entries', entries };
  }

  #set(custom: readonly SequenceTexts[], chosen: string, change: string): void {
    batch(() => {
      const together = change !== '' && this.#before.value.at(-1)?.change === change;
      if (!together) {
        const before = { custom: this.custom.value, chosen: this.#chosen.value, change };
        this.#before.value = [...this.#before.value, before].slice(-MOST_UNDOS);
      }
      this.#store(custom, chosen);
    });
  }

  #store(custom: readonly SequenceTexts[], chosen: string): void {
    const refusal = this.change(() => ({ items: custom, result: undefined }));
    this.#unkept.value = refusal === undefined || refusal === 'gone' ? undefined : { custom, why: refusal };
    this.choose(chosen);
  }
}
