import { createStore, del, get, keys, set } from 'idb-keyval';
import type { RecordStorage } from '../../../store/index.ts';

const NAME = 'framewright-devices';
/** Milliseconds after which a storage that has not answered is taken for one that refuses. */
const PATIENCE = 5000;

const store = createStore(NAME, 'profiles');
const channel = typeof BroadcastChannel === 'undefined' ? undefined : new BroadcastChannel(NAME);

/** The records of this page in the browser's IndexedDB. */
export const recordStorage: RecordStorage = {
  // What is forbidden throws before it promises anything.
  async keys() {
    const all = await Promise.race([keys<string>(store), refusalAfter(PATIENCE)]);
    return all;
  },
  get: async (key) => get(key, store),
  set: async (key, record) => set(key, record, store),
  delete: async (key) => del(key, store),
  tell: (key) => channel?.postMessage(key),
  listen: (told) => channel?.addEventListener('message', ({ data }: MessageEvent<string>) => told(data)),
  // Where the page is served without encryption there are no locks.
  alone: (act) => navigator.locks?.request(NAME, act) ?? act(),
  unique: () => Math.random().toString(36).slice(2),
};

const refusalAfter = (milliseconds: number) =>
  new Promise<never>((_, refuse) => setTimeout(() => refuse(new Error('No answer.')), milliseconds));
