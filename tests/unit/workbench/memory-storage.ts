import type { TextStorage } from '../../../src/workbench/kept-list.ts';

/** A storage in a map, which is full for texts that are longer than `room`. */
export function storageOf(texts: Map<string, string>, room = 100_000): TextStorage {
  return {
    getItem: (key) => texts.get(key) ?? null,
    setItem(key, text) {
      if (text.length > room) throw Object.assign(new Error('no room'), { name: 'QuotaExceededError' });
      texts.set(key, text);
    },
    removeItem: (key) => void texts.delete(key),
  };
}
