import type { makeWorker as made } from './worker-script.ts';

/**
 * Takes the place of `worker-script.ts` in the one file, where workers run the page's own script, from the address that
 * its policy has let through. It is no module: from a disk, Chromium starts no module of a blob.
 */
export const makeWorker: typeof made = (_, name) =>
  new Worker((globalThis as unknown as { framewrightScript: string }).framewrightScript, { name });

/** What the one file does not have: it is its own copy. */
export const offlineWorker = '';
