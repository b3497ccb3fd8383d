import { useLayoutEffect } from 'preact/hooks';
import { Devices } from '../../../store/index.ts';
import { page, storage } from '../store.ts';
import { devices, remembered } from './naming.ts';

/** The devices, for parts of the page that bring them. */
export const allDevices = new Devices(page, storage, remembered);

/** Lets the rest of the page know the devices: a part that brings them and their words has this. It shows nothing. */
export function ChosenDevice() {
  useLayoutEffect(() => {
    devices.value = allDevices;
  }, []);
  return null;
}
