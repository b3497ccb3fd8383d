import { loadShelfWords, type ShelfWords } from '../../../words/index.ts';

export let exampleWords!: ShelfWords['examples'];
export let savedWords!: ShelfWords['saved'];

/** Loads the sentences of the examples and the saved frames, which are there before anything shows them. */
export async function loadWords(): Promise<void> {
  ({ examples: exampleWords, saved: savedWords } = await loadShelfWords());
}
