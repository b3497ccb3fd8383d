/** As many characters as browsers keep for one page. */
const QUOTA = 5 * 2 ** 20;

/** What a page keeps by name: a document in this process has no limit for it. */
export const keptStorage = (): Storage =>
  new Proxy(new KeptStorage(), {
    get(kept, name) {
      const own: unknown = Reflect.get(kept, name, kept);
      if (typeof own === 'function') return own.bind(kept);
      return own ?? kept.getItem(String(name)) ?? undefined;
    },
    set(kept, name, value) {
      kept.setItem(String(name), String(value));
      return true;
    },
    has: (kept, name) => name in KeptStorage.prototype || kept.getItem(String(name)) !== null,
    deleteProperty(kept, name) {
      kept.removeItem(String(name));
      return true;
    },
    ownKeys: (kept) => kept.names,
    getOwnPropertyDescriptor(kept, name) {
      const value = kept.getItem(String(name));
      return value === null ? undefined : { value, writable: true, enumerable: true, configurable: true };
    },
  });

class KeptStorage implements Storage {
  [name: string]: unknown;
  readonly #kept = new Map<string, string>();

  get names(): string[] {
    return [...this.#kept.keys()];
  }

  get length(): number {
    return this.#kept.size;
  }

  key(index: number): string | null {
    return this.names[index] ?? null;
  }

  getItem(key: string): string | null {
    return this.#kept.get(key) ?? null;
  }

  setItem(key: string, value: string): void {
    let size = key.length + value.length;
    for (const [name, text] of this.#kept) if (name !== key) size += name.length + text.length;
    if (size > QUOTA) throw new DOMException('The quota has been exceeded.', 'QuotaExceededError');
    this.#kept.set(key, value);
  }

  removeItem(key: string): void {
    this.#kept.delete(key);
  }

  clear(): void {
    this.#kept.clear();
  }
}
