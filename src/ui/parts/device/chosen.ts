import { useEffect } from 'preact/hooks';
import type { Profile } from '../../../devices/index.ts';
import { Devices } from '../../../store/index.ts';
import { page, storage } from '../store.ts';
import { devices, remembered } from './naming.ts';

// While parts that show devices bring their words themselves.
export { loadWords as loadDevices } from './device-words.ts';

const all = new Devices(page, storage, remembered);

/** The devices, for parts of the page that bring them. */
export const allDevices = (): Devices => all;

export const chosenProfile = (): Profile | undefined => all.chosen.value;

/** Lets the page name what is in a frame as the chosen device does. Shows nothing. */
export function ChosenDevice() {
  useEffect(() => {
    devices.value = all;
  }, []);
  return null;
}
