/** As many characters as browsers keep for one page. */
const QUOTA = 5 * 2 ** 20;

/** What a page keeps by name: a document in this process has no limit for it. */
export class KeptStorage implements Storage {
  [name: string]: unknown;
  readonly #kept = new Map<string, string>();

  get length(): number {
    return this.#kept.size;
  }

  key(index: number): string | null {
    return [...this.#kept.keys()][index] ?? null;
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
