import { loadReadWords, type ReadWords } from '../../../words/index.ts';

/** What the reading of bytes says; there as soon as its views are. */
export let readWords: ReadWords;

export async function loadWords(): Promise<void> {
  readWords = await loadReadWords();
}
