import { loadSequenceWords, type SequenceWords } from '../../../words/index.ts';

/** The sentences of the panel, once `loadWords` has ended. */
export let sequenceWords: SequenceWords;

export async function loadWords(): Promise<void> {
  sequenceWords = await loadSequenceWords();
}
