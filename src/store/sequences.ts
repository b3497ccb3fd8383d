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
import { KeptChoice, type PageStorage, StoredList } from './storage.ts';

/** Changes that can be undone. */
const MOST_UNDOS = 100;

interface Before {
  readonly own: readonly SequenceTexts[];
  readonly chosen: string;
  /** Changes with the same text, such as of one field, are undone together. */
  readonly change: string;
}

/** What became of a file of sequences: of each entry, that it was not taken, is here already, or was added. */
export type SequenceImport =
  | { readonly kind: 'unreadable'; readonly fault: SequenceFileFault }
  | { readonly kind: 'entries'; readonly entries: readonly (BadSequence | { readonly already: string } | Naming)[] };

/**
 * The sequences that are built in, and a person's own; names tell them apart. What the storage does not take lasts as
 * long as the page.
 */
export class Sequences extends StoredList<SequenceTexts, SequenceFileFault, BadSequence> {
  readonly #chosen: KeptChoice<string>;
  readonly #unkept: Signal<
    { readonly own: readonly SequenceTexts[]; readonly why: 'refused' | 'full' | 'unreadable' } | undefined
  > = signal(undefined);
  readonly #before: Signal<readonly Before[]> = signal([]);
  readonly own = computed((): readonly SequenceTexts[] => {
    const { value } = this.stored;
    return this.#unkept.value?.own ?? (value.kind === 'list' ? value.items : []);
  });
  /** The stored sequences that cannot be used. */
  readonly bad = computed(() => (this.stored.value.kind === 'list' ? this.stored.value.bad : []));
  /** Why changes last no longer than the page. */
  readonly notKept = computed(() => {
    const { kind } = this.stored.value;
    return this.#unkept.value?.why ?? (kind === 'list' ? undefined : kind);
  });
  readonly canUndo = computed(() => this.#before.value.length > 0);
  /** The sequence that is chosen, or the first if there is none of its name. */
  readonly current = computed((): SequenceTexts | undefined => {
    const all = [...builtInSequences, ...this.own.value];
    return all.find(({ name }) => name === this.#chosen.value) ?? all[0];
  });

  constructor(storage: PageStorage) {
    super(storage, 'sequences', sequenceCodec);
    this.#chosen = new KeptChoice(storage, 'sequence', builtInSequences[0]?.name ?? '', text(), 'tab');
    // Nothing is undone over what another tab has stored.
    storage.follow(this.key, () =>
      batch(() => {
        this.#unkept.value = undefined;
        this.#before.value = [];
      }),
    );
  }

  isOwn(sequence: SequenceTexts): boolean {
    return this.own.value.includes(sequence);
  }

  choose(name: string): void {
    this.#chosen.value = name;
  }

  /** Replaces the one that is chosen, or adds a changed copy if that is built in. Answers its name; `undefined` if it is too big. */
  edit(next: SequenceTexts, change = ''): string | undefined {
    const current = this.current.value;
    if (current === undefined || !canBeKept(next)) return undefined;
    if (!this.isOwn(current)) return this.add(next, change);
    const others = new Set(namesOfSequences(this.own.value));
    others.delete(current.name);
    const kept = { ...next, name: freeName(next.name, others) };
    this.#set(
      this.own.value.map((each) => (each === current ? kept : each)),
      kept.name,
      change,
    );
    return kept.name;
  }

  /** Adds one under a name that is free, and chooses it. Answers the name. */
  add(sequence: SequenceTexts, change = ''): string {
    const name = freeName(sequence.name, new Set(namesOfSequences(this.own.value)));
    this.#set([...this.own.value, { ...sequence, name }], name, change);
    return name;
  }

  create(name: string): void {
    this.add(newSequence(name));
  }

  /** Deletes the one that is chosen. */
  deleteChosen(): void {
    const left = this.own.value.filter((each) => each !== this.current.value);
    this.#set(left, left.at(-1)?.name ?? builtInSequences[0]?.name ?? '', '');
  }

  undo(): void {
    const before = this.#before.value.at(-1);
    if (before === undefined) return;
    batch(() => {
      this.#before.value = this.#before.value.slice(0, -1);
      this.#store(before.own, before.chosen);
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
      const same = [...builtInSequences, ...this.own.value].find((each) => writeSequences([each]) === text);
      if (same === undefined) return { wanted: sequence.name, got: this.add(sequence) };
      this.choose(same.name);
      return { already: same.name };
    });
    return { kind: 'entries', entries };
  }

  #set(own: readonly SequenceTexts[], chosen: string, change: string): void {
    batch(() => {
      const together = change !== '' && this.#before.value.at(-1)?.change === change;
      if (!together) {
        const before = { own: this.own.value, chosen: this.#chosen.value, change };
        this.#before.value = [...this.#before.value, before].slice(-MOST_UNDOS);
      }
      this.#store(own, chosen);
    });
  }

  #store(own: readonly SequenceTexts[], chosen: string): void {
    const refusal = this.change(() => ({ items: own, result: undefined }));
    this.#unkept.value = refusal === undefined || refusal === 'gone' ? undefined : { own, why: refusal };
    this.choose(chosen);
  }
}
