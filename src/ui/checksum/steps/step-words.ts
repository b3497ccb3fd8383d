import { loadStepWords, type StepWords } from '../../../words/index.ts';

/** What is said about the steps of a checksum; there as soon as they are. */
export let stepWords: StepWords;

export async function loadWords(): Promise<void> {
  stepWords = await loadStepWords();
}
