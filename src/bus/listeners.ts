/**
 * Listeners that are told of something. One that is added or removed while they are being told counts from the next
 * time.
 */
export class Listeners<T> {
  #all: readonly ((event: T) => void)[] = [];

  /** Adds a listener; answers how to remove it. */
  add(listener: (event: T) => void): () => void {
    this.#all = [...this.#all, listener];
    return () => {
      this.#all = this.#all.filter((other) => other !== listener);
    };
  }

  tell(event: T): void {
    for (const listener of this.#all) listener(event);
  }
}
