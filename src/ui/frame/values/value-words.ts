import { loadValueWords, type ValueWords } from '../../../words/index.ts';

/** What is said about values; there as soon as their views are. */
export let valueWords: ValueWords;

export async function loadWords(): Promise<void> {
  valueWords = await loadValueWords();
}
