import { type BusWords, loadBusWords, type PollWords } from '../../../words/index.ts';

/** What polling says, once `loadWords` has ended. */
export let pollWords: PollWords;

export let busWords: BusWords;

export async function loadWords(): Promise<void> {
  busWords = await loadBusWords();
  pollWords = await busWords.loadPoll();
}
