import { loadWireWords, type WireWords } from '../../../words/index.ts';

/** What is said about the wire; there as soon as its panel is. */
export let wireWords: WireWords;

export async function loadWords(): Promise<void> {
  wireWords = await loadWireWords();
}
