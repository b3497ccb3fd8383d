import { IDBFactory } from 'fake-indexeddb';
import { keptStorage } from './storage.ts';

interface Entry {
  readonly url: URL;
  readonly state: unknown;
}

/** The address and the history of a tab, as the specification of HTML has them; a document in this process has no such thing. */
export class Tab {
  #entries: Entry[];
  #at = 0;
  readonly storage = keptStorage();
  readonly session = keptStorage();
  readonly databases = new IDBFactory();
  readonly #reload: () => void;

  constructor(address: URL, reload: () => void) {
    this.#entries = [{ url: address, state: null }];
    this.#reload = reload;
  }

  get url(): URL {
    return this.#now.url;
  }

  get #now(): Entry {
    const now = this.#entries[this.#at];
    if (!now) throw new RangeError(`entry ${this.#at} of ${this.#entries.length}`);
    return now;
  }

  /** A load of another page, which is an entry of its own. */
  load(address: URL): void {
    if (address.href !== this.url.href) this.#push({ url: address, state: null });
  }

  #push(entry: Entry): void {
    this.#entries = [...this.#entries.slice(0, this.#at + 1), entry];
    this.#at += 1;
  }

  /** A link or a script leads to another place of the page. */
  goToHash(hash: string): void {
    const before = this.url.href;
    const url = new URL(this.url);
    url.hash = hash;
    if (url.href === before) return;
    this.#push({ url, state: null });
    this.#tell(before);
  }

  /** At once, so that nothing is written to the address between its change and this; the hash is told of in a task of its own. */
  #tell(before: string): void {
    const after = this.url.href;
    dispatchEvent(Object.assign(new Event('popstate'), { state: this.#now.state }));
    if (before === after) return;
    setTimeout(() => dispatchEvent(Object.assign(new Event('hashchange'), { oldURL: before, newURL: after })));
  }

  /** What scripts know as `history`. */
  get history(): Pick<History, 'length' | 'state' | 'pushState' | 'replaceState' | 'back' | 'forward' | 'go'> {
    const tab = this;
    const entry = (state: unknown, address?: string | URL | null): Entry => ({
      url: new URL(address ?? tab.url, tab.url),
      state: structuredClone(state),
    });
    // The address changes with the event that tells of it, so that nothing is written into an entry of which a page has not heard.
    const go = (steps = 0) =>
      void setTimeout(() => {
        const before = tab.url.href;
        if (!tab.#entries[tab.#at + steps]) return;
        tab.#at += steps;
        tab.#tell(before);
      });
    return {
      get length() {
        return tab.#entries.length;
      },
      get state() {
        return tab.#now.state;
      },
      pushState: (state, _, address) => tab.#push(entry(state, address)),
      replaceState: (state, _, address) => {
        tab.#entries[tab.#at] = entry(state, address);
      },
      back: () => go(-1),
      forward: () => go(1),
      go,
    };
  }

  /** What scripts know as `location`. */
  get location(): Pick<
    Location,
    'href' | 'hash' | 'origin' | 'protocol' | 'host' | 'hostname' | 'pathname' | 'search' | 'reload'
  > {
    const tab = this;
    const part = (name: 'href' | 'origin' | 'protocol' | 'host' | 'hostname' | 'pathname' | 'search') => ({
      get: () => tab.url[name],
      enumerable: true,
    });
    return Object.defineProperties(
      {
        get hash() {
          return tab.url.hash;
        },
        set hash(hash: string) {
          tab.goToHash(hash);
        },
        reload: () => tab.#reload(),
      },
      {
        href: part('href'),
        origin: part('origin'),
        protocol: part('protocol'),
        host: part('host'),
        hostname: part('hostname'),
        pathname: part('pathname'),
        search: part('search'),
      },
    ) as Location;
  }
}
