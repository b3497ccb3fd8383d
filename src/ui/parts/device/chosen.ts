import type { Profile } from '../../../devices/index.ts';
import { Devices } from '../../../store/index.ts';
import { page, storage } from '../store.ts';
import { deviceWords, loadWords } from './device-words.ts';
import { devices } from './naming.ts';

/** Brings the devices, with their sentences. */
export async function loadDevices(): Promise<void> {
  await loadWords();
  devices.value ??= new Devices(page, storage, deviceWords);
}

/** The devices, for what is drawn only once they have come. */
export function allDevices(): Devices {
  if (devices.value === undefined) throw new TypeError('The devices are asked for before they have come.');
  return devices.value;
}

export const chosenProfile = (): Profile | undefined => devices.value?.chosen.value;
