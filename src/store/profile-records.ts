import { batch, computed, type ReadonlySignal, type Signal, signal } from '@preact/signals-core';
import { type DeviceFileFault, type Profile, writeProfiles } from '../devices/index.ts';
import {
  asOwn,
  type BadProfile,
  type Change,
  type Kept,
  type ProfileList,
  profileCodec,
  profileRecord,
  type RecordReading,
  type Refusal,
  type Removed,
  readRecord,
  refusalOf,
} from '../workbench/index.ts';
import type { RecordStorage } from './record-storage.ts';
import type { PageStorage } from './storage.ts';
import { StoredList } from './stored-list.ts';

type KeptProfiles = Kept<Profile, DeviceFileFault, BadProfile>;
type List = StoredList<Profile, DeviceFileFault, BadProfile>;
type Why = 'full' | 'refused';
type Held = RecordReading & { readonly key: string };
type Shown = Extract<Held, { readonly profile: Profile }>;

/** A profile of the list, and the key under which it is held here. */
interface Listed {
  readonly key: string;
  readonly profile: Profile;
}

/** The place of what is added before all profiles have come: behind them. */
const LATER = 1e9;

/**
 * The profiles of a person, each a record of its own. A change holds at once and is written then: where it cannot be, it
 * lasts until the page is closed, and `stored` says why. What earlier pages kept as one list in the other storage is taken
 * over: a profile leaves the list only when it is surely written.
 */
export class ProfileRecords implements ProfileList {
  readonly items: ReadonlySignal<readonly Profile[]>;
  /** What is kept, or why not all of it is. */
  readonly stored: ReadonlySignal<KeptProfiles | { readonly kind: 'full' }>;
  /** Whether all profiles have come that the storage gives. */
  readonly loaded: Signal<boolean> = signal(false);
  readonly #records: RecordStorage;
  readonly #storage: PageStorage;
  readonly #held: Signal<ReadonlyMap<string, Held>> = signal(new Map());
  readonly #shown: ReadonlySignal<readonly Shown[]>;
  /** Why records are not written as they are held; under a blank key, why nothing is. */
  readonly #unkept: Signal<ReadonlyMap<string, Why>> = signal(new Map());
  readonly #writing = new Map<string, Promise<boolean>>();
  /** What was changed once more while it was written. */
  readonly #again = new Set<string>();
  /** The list of earlier pages, and what of it is not taken over yet, by id. */
  readonly #list: List;
  readonly #listed = new Map<string, Listed>();
  #taking: Promise<void> = Promise.resolve();

  /** `first` is the id of the profile that is wanted first. */
  constructor(records: RecordStorage, storage: PageStorage, first: string) {
    this.#records = records;
    this.#storage = storage;
    this.#list = new StoredList(storage, 'devices', profileCodec);
    this.#shown = computed(() =>
      [...this.#held.value.values()]
        .filter((held) => 'profile' in held)
        .toSorted((one, other) => one.place - other.place),
    );
    this.items = computed(() => this.#shown.value.map(({ profile }) => profile));
    this.stored = computed(() => {
      const [why] = this.#unkept.value.values();
      const { value: list } = this.#list.stored;
      if (why !== undefined) return { kind: why };
      if (list.kind === 'unreadable') return list;
      const bad = [...this.#held.value.values()].flatMap((held) => ('bad' in held ? [held.bad] : []));
      return { kind: 'list', items: this.items.value, bad: [...bad, ...(list.kind === 'list' ? list.bad : [])] };
    });
    this.#holdList();
    records.listen((key) => void this.#fetch(key, 'again').catch(() => undefined));
    void this.#load(first);
  }

  get kept(): KeptProfiles {
    return { kind: 'list', items: this.items.peek(), bad: [] };
  }

  change<R>(make: (items: readonly Profile[]) => Change<Profile, R>): R | Refusal {
    const before = this.#shown.peek();
    const changed = make(before.map(({ profile }) => profile));
    if (changed === 'gone') return 'gone';
    const gone = new Map(before.map((shown) => [shown.profile.id, shown]));
    const places = changed.items.map(({ id }) => gone.get(id)?.place);
    const held = new Map(this.#held.peek());
    const dirty: string[] = [];
    changed.items.forEach((profile, at) => {
      const was = gone.get(profile.id);
      gone.delete(profile.id);
      if (was?.profile === profile) return;
      const key = was?.key ?? this.#freeKey(profile);
      const place = was?.place ?? this.#placeBetween(places[at - 1], places.slice(at).find(Number.isFinite));
      places[at] = place;
      held.set(key, { key, place, profile });
      dirty.push(key);
    });
    for (const { key } of gone.values()) {
      held.delete(key);
      dirty.push(key);
    }
    batch(() => {
      this.#held.value = held;
      for (const [id, { key }] of this.#listed) if (!held.has(key)) this.#leaveList(id);
      for (const key of dirty) void this.#write(key);
    });
    return changed.result;
  }

  remove(isMeant: (item: Profile) => boolean): Removed<Profile> | Refusal {
    return this.change((items) => {
      const index = items.findIndex(isMeant);
      const item = items[index];
      return item === undefined ? 'gone' : { items: items.toSpliced(index, 1), result: { item, index } };
    });
  }

  /** Moves a list of an earlier page that cannot be read to a key of its own. */
  setUnreadableAside(): { readonly key: string } | Refusal {
    return this.#list.setUnreadableAside();
  }

  readonly #freeKey = ({ id }: Profile) => `${id} ${this.#records.unique()}`;

  #placeBetween(before: number | undefined, behind: number | undefined): number {
    if (before !== undefined && behind !== undefined) return (before + behind) / 2;
    if (behind !== undefined) return behind - 1;
    return Math.max(before === undefined ? 0 : before + 1, this.loaded.peek() ? 0 : LATER);
  }

  async #load(first: string): Promise<void> {
    try {
      const keys = await this.#records.keys();
      const wanted = keys.filter((key) => key.startsWith(`${first} `));
      for (const key of new Set([...wanted, ...keys])) await this.#fetch(key);
      this.#putListBehind();
      const take = () => {
        this.#holdList();
        this.#taking = this.#taking.then(() => this.#records.alone(() => this.#takeList())).catch(() => undefined);
      };
      this.#storage.follow(this.#list.key, take);
      if (this.#listed.size > 0) take();
    } catch (error) {
      this.#say('', refusalOf(error));
    }
    this.loaded.value = true;
  }

  /** Holds a record as it is stored, unless this tab knows better; `again` for one that another tab has changed. */
  async #fetch(key: string, which?: 'again'): Promise<void> {
    const isOurs = () =>
      this.#writing.has(key) || this.#unkept.peek().has(key) || (which === undefined && this.#held.peek().has(key));
    if (isOurs()) return;
    const record = await this.#records.get(key);
    if (!isOurs()) this.#hold(key, record === undefined ? undefined : readRecord(record));
  }

  #hold(key: string, reading: RecordReading | undefined): void {
    const held = new Map(this.#held.peek());
    held.delete(key);
    const others = [...held.values()].flatMap((other) => ('profile' in other ? [other.profile] : []));
    if (reading !== undefined && 'profile' in reading)
      held.set(key, { ...reading, key, profile: asOwn(reading.profile, others) });
    else if (reading !== undefined) held.set(key, { ...reading, key });
    this.#held.value = held;
  }

  /** Writes a record as it is held, and again if it is changed meanwhile. Answers whether it is surely kept. */
  #write(key: string): Promise<boolean> {
    const now = this.#writing.get(key);
    if (now) this.#again.add(key);
    const done = now ?? this.#writeNow(key);
    this.#writing.set(key, done);
    return done;
  }

  async #writeNow(key: string): Promise<boolean> {
    let why: Why | undefined;
    do {
      this.#again.delete(key);
      const held = this.#held.peek().get(key);
      try {
        if (held === undefined) await this.#records.delete(key);
        else if ('profile' in held) await this.#records.set(key, profileRecord(held.profile, held.place));
        why = undefined;
      } catch (error) {
        why = refusalOf(error);
      }
    } while (this.#again.has(key));
    this.#writing.delete(key);
    this.#say(key, why);
    if (why !== undefined) return false;
    this.#records.tell(key);
    // What had no room may have it now.
    if (!this.#held.peek().has(key))
      for (const [other, fault] of this.#unkept.peek()) if (fault === 'full') void this.#write(other);
    return true;
  }

  #say(key: string, why: Why | undefined): void {
    const unkept = new Map(this.#unkept.peek());
    if (why === undefined) unkept.delete(key);
    else unkept.set(key, why);
    this.#unkept.value = unkept;
  }

  readonly #profileAt = (key: string): Profile | undefined => {
    const held = this.#held.peek().get(key);
    return held && 'profile' in held ? held.profile : undefined;
  };

  /** Holds what the list of earlier pages has, as far as it is not held here. */
  #holdList(): void {
    const { kept } = this.#list;
    for (const profile of kept.kind === 'list' ? kept.items : []) {
      if (this.#listed.has(profile.id)) continue;
      // The same key in each tab, and again after an interruption, so that none takes the profile twice.
      const usual = `${profile.id} list`;
      const there = this.#profileAt(usual);
      const isThere = there !== undefined && same(there, profile);
      const key = there === undefined || isThere ? usual : this.#freeKey(profile);
      const last = this.#shown.peek().at(-1)?.place;
      if (!isThere) this.#hold(key, { place: this.#placeBetween(last, undefined), profile });
      this.#listed.set(profile.id, { key, profile });
    }
  }

  /** Gives what is in the list its place behind all records. */
  #putListBehind(): void {
    const keys = new Set([...this.#listed.values()].map(({ key }) => key));
    const others = this.#shown.peek().filter(({ key }) => !keys.has(key));
    const listed = this.#shown.peek().filter(({ key }) => keys.has(key));
    const first = this.#placeBetween(others.at(-1)?.place, undefined);
    for (const [at, { key, profile }] of listed.entries()) this.#hold(key, { place: first + at, profile });
  }

  /** Takes over what is in the list, one profile after another, until one cannot be written. */
  async #takeList(): Promise<void> {
    for (;;) {
      this.#list.reload();
      this.#holdList();
      const [id] = this.#listed.keys();
      if (id === undefined || !(await this.#take(id))) return;
    }
  }

  /** Answers whether a profile of the list is surely written, and out of the list. */
  async #take(id: string): Promise<boolean> {
    const { key = '' } = this.#listed.get(id) ?? {};
    await this.#writing.get(key);
    const record = await this.#records.get(key);
    const held = this.#held.peek().get(key);
    // It was deleted here meanwhile, or changed, which has no room.
    if (held === undefined || !('profile' in held)) return this.#leaveList(id);
    if (this.#unkept.peek().has(key)) return false;
    const stored = record === undefined ? undefined : readRecord(record);
    if (stored && 'profile' in stored && same(stored.profile, held.profile)) return this.#leaveList(id);
    const free = stored ? this.#freeKey(held.profile) : key;
    if (stored) {
      this.#hold(key, stored);
      this.#hold(free, held);
    }
    if (await this.#write(free)) return this.#leaveList(id);
    // It lasts where it is.
    this.#say(free, undefined);
    return false;
  }

  /** Takes a profile out of the list, unless the list has another one by that id now. Answers whether that could be done. */
  #leaveList(id: string): boolean {
    const listed = this.#listed.get(id);
    const outcome = this.#list.remove((item) => item.id === id && listed !== undefined && same(item, listed.profile));
    if (outcome === 'refused' || outcome === 'full') return false;
    this.#listed.delete(id);
    const { kept } = this.#list;
    if (kept.kind === 'list' && kept.items.length + kept.bad.length === 0)
      this.#storage.texts().removeItem(this.#list.key);
    return true;
  }
}

/** Whether two profiles are written as the same. */
const same = (one: Profile, other: Profile): boolean =>
  one === other || writeProfiles([one]) === writeProfiles([other]);
