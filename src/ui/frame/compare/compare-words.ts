import { type CompareWords, loadCompareWords } from '../../../words/index.ts';

export let compareWords!: CompareWords;

/** Loads the sentences of the comparison, which are there before anything shows them. */
export async function loadWords(): Promise<void> {
  compareWords = await loadCompareWords();
}
