import { type BusWords, loadBusWords } from '../../words/index.ts';
import type { LineWords } from '../../workbench/index.ts';
import { words as pageWords } from '../parts/page-words.ts';

/** The sentences of the Bus view, once `loadWords` has ended. */
export let busWords: BusWords;

/** What is said of a line of the log. */
export let lineWords: LineWords;

export async function loadWords(): Promise<void> {
  busWords = await loadBusWords();
  lineWords = { ...busWords.log, frame: pageWords.page.summary };
}
