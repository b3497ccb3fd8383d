import { loadScanWords, type ScanWords } from '../../../words/index.ts';

/** What scanning says, once `loadWords` has ended. */
export let scanWords: ScanWords;

export async function loadWords(): Promise<void> {
  scanWords = await loadScanWords();
}
