import { type DeviceWords, loadDeviceWords } from '../../../words/index.ts';

/** What the devices say; there as soon as their views are. */
export let deviceWords: DeviceWords;

export async function loadWords(): Promise<void> {
  deviceWords = await loadDeviceWords();
}
