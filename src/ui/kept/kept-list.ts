import { Cell } from '../cell.ts';

/** What the browser holds: a list, a text that is none and is left alone, or nothing because it refuses. */
export type Kept<T, Fault, Bad = never> =
  | { readonly kind: 'list'; readonly items: readonly T[]; readonly bad: readonly Bad[] }
  | { readonly kind: 'unreadable'; readonly fault: Fault; readonly text: string }
  | { readonly kind: 'refused' };

/** A list as its text reads: its items, with rows that are none, or why it is no list. */
export type ListReading<T, Fault, Bad = never> =
  | { readonly kind: 'list'; readonly items: readonly T[]; readonly bad: readonly Bad[] }
  | { readonly kind: 'unreadable'; readonly fault: Fault };

/** How a list is written as a text and read again; rows that are no items are kept as they are. */
export interface ListCodec<T, Fault, Bad = never> {
  readonly read: (text: string) => ListReading<T, Fault, Bad>;
  readonly write: (items: readonly T[], bad: readonly Bad[]) => string;
}

/** Why a change was not stored. Nothing was changed then. */
export type Refusal = 'refused' | 'full' | 'unreadable' | 'gone';

/** What was removed, and its place in the list. */
export interface Removed<T> {
  readonly item: T;
  readonly index: number;
}

/** A changed list and what the change answers; `gone` where what was to be changed is no longer there. */
type Change<T, R> = { readonly items: readonly T[]; readonly result: R } | 'gone';

/** A list kept in this browser, under a key of its own, which other tabs may change too. */
export class KeptList<T, Fault, Bad = never> {
  private readonly key: string;
  private readonly codec: ListCodec<T, Fault, Bad>;
  /** The list as this tab knows it. */
  readonly stored: Cell<Kept<T, Fault, Bad>>;

  constructor(name: string, codec: ListCodec<T, Fault, Bad>) {
    this.key = `framewright.${name}`;
    this.codec = codec;
    this.stored = new Cell(this.load());
  }

  private load(): Kept<T, Fault, Bad> {
    let text: string | null;
    try {
      text = localStorage.getItem(this.key);
    } catch {
      return { kind: 'refused' };
    }
    if (text === null) return { kind: 'list', items: [], bad: [] };
    const reading = this.codec.read(text);
    return reading.kind === 'list' ? reading : { ...reading, text };
  }

  /** Follows what other tabs store. Answers how to stop. */
  followOtherTabs(onChange: () => void): () => void {
    const follow = ({ key }: StorageEvent) => {
      if (key !== this.key && key !== null) return;
      this.stored.value = this.load();
      onChange();
    };
    addEventListener('storage', follow);
    return () => removeEventListener('storage', follow);
  }

  /** Changes the list as it is stored now, whatever this tab last saw of it. */
  change<R>(make: (items: readonly T[]) => Change<T, R>): R | Refusal {
    const now = this.load();
    this.stored.value = now;
    if (now.kind !== 'list') return now.kind;
    const changed = make(now.items);
    if (changed === 'gone') return 'gone';
    const refusal = put(this.key, this.codec.write(changed.items, now.bad));
    if (refusal !== undefined) return refusal;
    this.stored.value = { ...now, items: changed.items };
    return changed.result;
  }

  remove(isMeant: (item: T) => boolean): Removed<T> | Refusal {
    return this.change((items) => {
      const index = items.findIndex(isMeant);
      const item = items[index];
      return item === undefined ? 'gone' : { items: items.toSpliced(index, 1), result: { item, index } };
    });
  }

  /** Moves a stored text that cannot be read to a key of its own, and begins an empty list. */
  setUnreadableAside(): { readonly key: string } | Refusal {
    const now = this.load();
    this.stored.value = now;
    if (now.kind === 'refused') return 'refused';
    if (now.kind === 'list') return 'gone';
    let number = 1;
    while (localStorage.getItem(`${this.key}.unreadable-${number}`) !== null) number++;
    const key = `${this.key}.unreadable-${number}`;
    const refusal = put(key, now.text);
    if (refusal !== undefined) return refusal;
    localStorage.removeItem(this.key);
    this.stored.value = this.load();
    return { key };
  }
}

function put(key: string, text: string): Refusal | undefined {
  try {
    localStorage.setItem(key, text);
    return undefined;
  } catch (error) {
    return error instanceof DOMException && /quota/i.test(error.name) ? 'full' : 'refused';
  }
}
