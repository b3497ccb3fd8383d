/** What a worker says first. */
export const ALIVE = 'alive';

/** Lets the window know that this worker lives, and, by a lock that the browser takes from it, when it does no longer. */
export function sayAlive(): void {
  const worker = globalThis as unknown as Worker & { readonly name: string };
  const say = () => worker.postMessage(ALIVE);
  const forever = new Promise(() => undefined);
  if (navigator.locks) {
    navigator.locks
      .request(worker.name, () => {
        say();
        return forever;
      })
      .catch(say);
  } else say();
}
