import { type ListenWords, loadListenWords } from '../../../words/index.ts';

/** What listening says, once `loadWords` has ended. */
export let listenWords: ListenWords;

export async function loadWords(): Promise<void> {
  listenWords = await loadListenWords();
}
