import { loadVirtualWords, type VirtualWords } from '../../../words/index.ts';
import { loadDevices } from '../../parts/device/chosen.ts';

/** The sentences of the virtual devices, once `loadWords` has ended. */
export let virtualWords: VirtualWords;

export async function loadWords(): Promise<void> {
  [virtualWords] = await Promise.all([loadVirtualWords(), loadDevices()]);
}
