import { Listeners } from '../../../bus/index.ts';
import {
  builtInSequences,
  newSequence,
  readSequences,
  type SequenceTexts,
  writeSequences,
} from '../../../sequences/index.ts';
import { bytesOfLink, freeName } from '../../../workbench/index.ts';
import { Remembered } from '../../tools/remembered.ts';

const KEY = 'framewright.sequences';
/** Changes that can be undone. */
const MOST_UNDOS = 100;

/** Why changes last no longer than the page. */
export type NotKept = 'refused' | 'full' | 'unreadable';

interface Kept {
  readonly own: readonly SequenceTexts[];
  readonly notKept: NotKept | undefined;
}

function load(): Kept {
  let text: string | null;
  try {
    text = localStorage.getItem(KEY);
  } catch {
    return { own: [], notKept: 'refused' };
  }
  if (text === null) return { own: [], notKept: undefined };
  const reading = readSequences(text, bytesOfLink);
  if (reading.kind === 'unreadable') return { own: [], notKept: 'unreadable' };
  const own = reading.entries.flatMap((entry) => (entry.kind === 'sequence' ? [entry.sequence] : []));
  // Storing the list again would lose what could not be read.
  return own.length < reading.entries.length ? { own: [], notKept: 'unreadable' } : { own, notKept: undefined };
}

/** Whether it can be stored, so that it can be read again. */
const canBeKept = (sequence: SequenceTexts): boolean => {
  const reading = readSequences(writeSequences([sequence]), bytesOfLink);
  return reading.kind === 'sequences' && reading.entries[0]?.kind === 'sequence';
};

interface Before {
  readonly own: readonly SequenceTexts[];
  readonly chosen: string;
  /** Changes with the same text, such as of one field, are undone together. */
  readonly what: string;
}

const chosenMemory = new Remembered('sequence', builtInSequences[0]?.name ?? '', (stored) =>
  typeof stored === 'string' ? stored : undefined,
);

/** The sequences that are built in, and a person's own, which the browser keeps; names tell them apart. */
class Library {
  readonly listeners = new Listeners<undefined>();
  #kept = load();
  #before: readonly Before[] = [];

  get own(): readonly SequenceTexts[] {
    return this.#kept.own;
  }

  get notKept(): NotKept | undefined {
    return this.#kept.notKept;
  }

  get canUndo(): boolean {
    return this.#before.length > 0;
  }

  get current(): SequenceTexts | undefined {
    const all = [...builtInSequences, ...this.own];
    return all.find(({ name }) => name === chosenMemory.value) ?? all[0];
  }

  isOwn(sequence: SequenceTexts): boolean {
    return this.own.includes(sequence);
  }

  choose(name: string): void {
    chosenMemory.value = name;
    this.listeners.tell(undefined);
  }

  /** Puts another in the place of the one that is chosen, or beside it if that is built in. Answers its name. */
  edit(next: SequenceTexts, what: string): string | undefined {
    const { current } = this;
    if (current === undefined || !canBeKept(next)) return undefined;
    if (!this.isOwn(current)) return this.add(next, what);
    const others = new Set([...builtInSequences, ...this.own].map(({ name }) => name));
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
    const name = freeName(sequence.name, new Set([...builtInSequences, ...this.own].map((each) => each.name)));
    this.#set([...this.own, { ...sequence, name }], name, what);
    return name;
  }

  create(name: string): void {
    this.add(newSequence(name));
  }

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

  /** Follows what other tabs store; what was changed here before cannot be undone then. Answers how to stop. */
  followOtherTabs(): () => void {
    const follow = ({ key }: StorageEvent) => {
      if (key !== KEY && key !== null) return;
      this.#kept = load();
      this.#before = [];
      this.listeners.tell(undefined);
    };
    addEventListener('storage', follow);
    return () => removeEventListener('storage', follow);
  }

  #set(own: readonly SequenceTexts[], chosen: string, what: string): void {
    const together = what !== '' && this.#before.at(-1)?.what === what;
    if (!together) {
      const before = { own: this.own, chosen: chosenMemory.value, what };
      this.#before = [...this.#before, before].slice(-MOST_UNDOS);
    }
    this.#store(own, chosen);
  }

  #store(own: readonly SequenceTexts[], chosen: string): void {
    let { notKept } = this.#kept;
    if (notKept !== 'unreadable') {
      try {
        localStorage.setItem(KEY, writeSequences(own));
        notKept = undefined;
      } catch (error) {
        notKept = error instanceof DOMException && /quota/i.test(error.name) ? 'full' : 'refused';
      }
    }
    this.#kept = { own, notKept };
    this.choose(chosen);
  }
}

export const library = new Library();
