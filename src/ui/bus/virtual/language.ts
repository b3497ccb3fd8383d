import { loadVirtualWords, type VirtualWords } from '../../../words/index.ts';
import { loadWords as loadDeviceWords } from '../../device/language.ts';

/** The sentences of the virtual devices, once `loadWords` has ended. */
export let virtualWords: VirtualWords;

export async function loadWords(): Promise<void> {
  [virtualWords] = await Promise.all([loadVirtualWords(), loadDeviceWords()]);
}
