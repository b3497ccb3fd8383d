import { type ChecksumWords, loadChecksumWords } from '../../words/index.ts';

/** What is said about checksums; there as soon as the view is. */
export let checksumWords: ChecksumWords;

export async function loadWords(): Promise<void> {
  checksumWords = await loadChecksumWords();
}
