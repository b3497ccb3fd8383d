/** Those who want to know of something. One that is added or goes away while all are told counts from the next time. */
export class Listeners<T> {
  #all: readonly ((event: T) => void)[] = [];

  /** Adds a listener; answers how to take it away. */
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
