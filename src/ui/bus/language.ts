import { type BusWords, loadBusWords } from '../../words/index.ts';

/** The sentences of the Bus view, once `loadWords` has ended. */
export let busWords: BusWords;

export async function loadWords(): Promise<void> {
  busWords = await loadBusWords();
}
