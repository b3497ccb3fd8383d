type Act = () => unknown;

/** What a window knows as `navigator.locks`: who asks for a name has it when all who asked before have done what they wanted it for. */
export class Locks {
  readonly #last = new Map<string, Promise<unknown>>();

  request(name: string, ...rest: [Act] | [{ signal?: AbortSignal }, Act]): Promise<unknown> {
    const [{ signal }, act] = rest.length === 1 ? [{} as { signal?: AbortSignal }, rest[0]] : rest;
    const mine = Promise.allSettled([this.#last.get(name)]).then(() => {
      signal?.throwIfAborted();
      return act();
    });
    this.#last.set(name, mine);
    return mine;
  }
}
