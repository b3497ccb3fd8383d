/** What the browser holds: a list, a text that is not one and is left alone, or nothing because it refuses. */
export type Kept<T, Fault, Bad = never> =
  | { readonly kind: 'list'; readonly items: readonly T[]; readonly bad: readonly Bad[] }
  | { readonly kind: 'unreadable'; readonly fault: Fault; readonly text: string }
  | { readonly kind: 'refused' };

/** A stored text as it reads: its items and the rows that are not items, or why it is not a list. */
export type ListReading<T, Fault, Bad = never> =
  | Exclude<Kept<T, Fault, Bad>, { readonly kind: 'unreadable' | 'refused' }>
  | { readonly kind: 'unreadable'; readonly fault: Fault };

/** How a list is written as a text and read again; rows that are not items are kept as they are. */
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

/** Texts by key. Each call may throw; an error whose name speaks of a quota means that the storage is full. */
export interface TextStorage {
  getItem(key: string): string | null;
  setItem(key: string, text: string): void;
  removeItem(key: string): void;
}

/** Why a storage that threw an error does not keep something. */
export const refusalOf = (error: unknown): 'full' | 'refused' =>
  error instanceof Error && /quota/i.test(error.name) ? 'full' : 'refused';

/** A changed list and the result of the change; `gone` if the entry to be changed no longer exists. */
export type Change<T, R> = { readonly items: readonly T[]; readonly result: R } | 'gone';

/** A list kept in a storage under a key of its own. Others may change it there too, such as another tab. */
export class KeptList<T, Fault, Bad = never> {
  readonly key: string;
  readonly #codec: ListCodec<T, Fault, Bad>;
  readonly #storage: () => TextStorage;
  #held: Kept<T, Fault, Bad>;

  /** `storage` is asked each time and may throw, as `localStorage` does where it is forbidden. */
  constructor(name: string, codec: ListCodec<T, Fault, Bad>, storage: () => TextStorage) {
    this.key = `framewright.${name}`;
    this.#codec = codec;
    this.#storage = storage;
    this.#held = this.#load();
  }

  /** The list as it was last seen here. */
  get kept(): Kept<T, Fault, Bad> {
    return this.#held;
  }

  /** Is called when the list is seen to be another. */
  protected changed(_kept: Kept<T, Fault, Bad>): void {}

  /** Looks at what is stored now. */
  reload(): void {
    this.#hold(this.#load());
  }

  /** Changes the list as it is stored now, whatever was last seen of it. */
  change<R>(make: (items: readonly T[]) => Change<T, R>): R | Refusal {
    this.reload();
    const now = this.#held;
    if (now.kind !== 'list') return now.kind;
    const changed = make(now.items);
    if (changed === 'gone') return 'gone';
    const refusal = this.#put(this.key, this.#codec.write(changed.items, now.bad));
    if (refusal !== undefined) return refusal;
    this.#hold({ ...now, items: changed.items });
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
    this.reload();
    const now = this.#held;
    if (now.kind === 'refused') return 'refused';
    if (now.kind === 'list') return 'gone';
    let number = 1;
    while (this.#storage().getItem(`${this.key}.unreadable-${number}`) !== null) number++;
    const key = `${this.key}.unreadable-${number}`;
    const refusal = this.#put(key, now.text);
    if (refusal !== undefined) return refusal;
    this.#storage().removeItem(this.key);
    this.reload();
    return { key };
  }

  #hold(kept: Kept<T, Fault, Bad>): void {
    this.#held = kept;
    this.changed(kept);
  }

  #load(): Kept<T, Fault, Bad> {
    let text: string | null;
    try {
      text = this.#storage().getItem(this.key);
    } catch {
      return { kind: 'refused' };
    }
    if (text === null) return { kind: 'list', items: [], bad: [] };
    const reading = this.#codec.read(text);
    return reading.kind === 'list' ? reading : { ...reading, text };
  }

  #put(key: string, text: string): 'full' | 'refused' | undefined {
    try {
      this.#storage().setItem(key, text);
      return undefined;
    } catch (error) {
      return refusalOf(error);
    }
  }
}
