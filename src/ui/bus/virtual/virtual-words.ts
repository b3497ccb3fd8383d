import { loadVirtualWords, type VirtualWords } from '../../../words/index.ts';
import { loadWords as loadDeviceWords } from '../../parts/device/device-words.ts';

/** The sentences of the virtual devices, once `loadWords` has ended. */
export let virtualWords: VirtualWords;

export async function loadWords(): Promise<void> {
  [virtualWords] = await Promise.all([loadVirtualWords(), loadDeviceWords()]);
}
