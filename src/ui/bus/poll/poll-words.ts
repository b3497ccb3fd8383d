import { loadBusWords, type PollWords } from '../../../words/index.ts';

/** What polling says, once `loadWords` has ended. */
export let pollWords: PollWords;

export async function loadWords(): Promise<void> {
  const { loadPoll } = await loadBusWords();
  pollWords = await loadPoll();
}
