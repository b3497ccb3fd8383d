import { Listeners } from '../../bus/index.ts';
import {
  builtInSequences,
  newSequence,
  readSequences,
  type SequenceEntry,
  type SequenceFileFault,
  type SequenceTexts,
  writeSequences,
} from '../../sequences/index.ts';
import type { KeptList, ListCodec } from '../kept-list.ts';
import { freeName } from '../names.ts';
import { bytesOfLink } from './sequence-frame.ts';

/** A stored sequence that cannot be used, and why; it stays in the storage as it is. */
export type BadSequence = Extract<SequenceEntry, { readonly kind: 'faults' }>;

/** The sequences of a person's own, in a storage. */
export type SequenceList = KeptList<SequenceTexts, SequenceFileFault, BadSequence>;

const namesOf = (sequences: readonly SequenceTexts[]) => [...builtInSequences, ...sequences].map(({ name }) => name);

/** Sequences as the text of their file. */
export const sequenceCodec: ListCodec<SequenceTexts, SequenceFileFault, BadSequence> = {
  read(text) {
    const reading = readSequences(text, bytesOfLink);
    if (reading.kind === 'unreadable') return reading;
    const items: SequenceTexts[] = [];
    const bad: BadSequence[] = [];
    for (const entry of reading.entries) {
      if (entry.kind === 'faults') bad.push(entry);
      // A list that was edited by hand may have a name twice.
      else items.push({ ...entry.sequence, name: freeName(entry.sequence.name, new Set(namesOf(items))) });
    }
    return { kind: 'list', items, bad };
  },
  write: (sequences, bad) =>
    writeSequences(
      sequences,
      bad.map(({ raw }) => raw),
    ),
};

/** Whether it can be stored in such a way that it can be read again. */
function canBeKept(sequence: SequenceTexts): boolean {
  const reading = readSequences(writeSequences([sequence]), bytesOfLink);
  return reading.kind === 'sequences' && reading.entries[0]?.kind === 'sequence';
}

/** Why changes last no longer than the page. */
export type NotKept = 'refused' | 'full' | 'unreadable';

/** Changes that can be undone. */
const MOST_UNDOS = 100;

interface Before {
  readonly own: readonly SequenceTexts[];
  readonly chosen: string;
  /** Changes with the same text, such as of one field, are undone together. */
  readonly what: string;
}

/**
 * The sequences that are built in, and a person's own; names tell them apart. What the storage does not take lasts as
 * long as the page.
 */
export class SequenceLibrary {
  readonly listeners = new Listeners<undefined>();
  readonly #list: SequenceList;
  readonly #chosen: { value: string };
  #unkept: { readonly own: readonly SequenceTexts[]; readonly why: NotKept } | undefined;
  #before: readonly Before[] = [];

  /** `chosen` holds the name of the sequence that is shown. */
  constructor(list: SequenceList, chosen: { value: string }) {
    this.#list = list;
    this.#chosen = chosen;
  }

  get own(): readonly SequenceTexts[] {
    const { kept } = this.#list;
    return this.#unkept?.own ?? (kept.kind === 'list' ? kept.items : []);
  }

  /** The stored sequences that cannot be used. */
  get bad(): readonly BadSequence[] {
    const { kept } = this.#list;
    return kept.kind === 'list' ? kept.bad : [];
  }

  get notKept(): NotKept | undefined {
    const { kind } = this.#list.kept;
    return this.#unkept?.why ?? (kind === 'list' ? undefined : kind);
  }

  get canUndo(): boolean {
    return this.#before.length > 0;
  }

  get current(): SequenceTexts | undefined {
    const all = [...builtInSequences, ...this.own];
    return all.find(({ name }) => name === this.#chosen.value) ?? all[0];
  }

  isOwn(sequence: SequenceTexts): boolean {
    return this.own.includes(sequence);
  }

  choose(name: string): void {
    this.#chosen.value = name;
    this.listeners.tell(undefined);
  }

  /** Puts another in the place of the one that is chosen, or beside it if that is built in. Answers its name. */
  edit(next: SequenceTexts, what: string): string | undefined {
    const { current } = this;
    if (current === undefined || !canBeKept(next)) return undefined;
    if (!this.isOwn(current)) return this.add(next, what);
    const others = new Set(namesOf(this.own));
    others.delete(current.name);
    const kept = { ...next, name: freeName(next.name, others) };
    this.#set(
      this.own.map((each) => (each === current ? kept : each)),
      kept.name,
      what,
    );
    return kept.name;
  }

  /** Adds one under a name that is free, and chooses it. Answers the name. */
  add(sequence: SequenceTexts, what = ''): string {
    const name = freeName(sequence.name, new Set(namesOf(this.own)));
    this.#set([...this.own, { ...sequence, name }], name, what);
    return name;
  }

  create(name: string): void {
    this.add(newSequence(name));
  }

  /** Removes the one that is chosen. */
  remove(): void {
    const { current } = this;
    const left = this.own.filter((each) => each !== current);
    this.#set(left, left.at(-1)?.name ?? builtInSequences[0]?.name ?? '', '');
  }

  undo(): void {
    const before = this.#before.at(-1);
    if (before === undefined) return;
    this.#before = this.#before.slice(0, -1);
    this.#store(before.own, before.chosen);
  }

  /** Others have changed the list: what was changed here before cannot be undone then. */
  changedElsewhere(): void {
    this.#unkept = undefined;
    this.#before = [];
    this.listeners.tell(undefined);
  }

  #set(own: readonly SequenceTexts[], chosen: string, what: string): void {
    const together = what !== '' && this.#before.at(-1)?.what === what;
    if (!together) {
      const before = { own: this.own, chosen: this.#chosen.value, what };
      this.#before = [...this.#before, before].slice(-MOST_UNDOS);
    }
    this.#store(own, chosen);
  }

  #store(own: readonly SequenceTexts[], chosen: string): void {
    const refusal = this.#list.change(() => ({ items: own, result: undefined }));
    this.#unkept = refusal === undefined || refusal === 'gone' ? undefined : { own, why: refusal };
    this.choose(chosen);
  }
}
