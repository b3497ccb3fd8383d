import { loadPollWords, type PollWords } from '../../words/index.ts';

/** What polling says, once `loadWords` has ended. */
export let pollWords: PollWords;

export async function loadWords(): Promise<void> {
  pollWords = await loadPollWords();
}
