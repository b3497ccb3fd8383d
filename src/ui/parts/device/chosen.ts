import type { ComponentType } from 'preact';
import { h } from 'preact';
import { useLayoutEffect } from 'preact/hooks';
import { Devices } from '../../../store/index.ts';
import { page, storage } from '../store.ts';
import { devices, remembered } from './naming.ts';
import { recordStorage } from './record-storage.ts';

/** The devices, for parts of the page that bring them. */
export const allDevices = new Devices(page, storage, remembered, recordStorage);

/** Lets the rest of the page know the devices once the chosen one has come: a part that brings them and their words has this. It shows nothing. */
export function ChosenDevice() {
  const came = allDevices.came.value;
  useLayoutEffect(() => {
    devices.value = came ? allDevices : undefined;
  }, [came]);
  return null;
}

/** A component that stands once the chosen device has come: until then it would say that none is chosen. */
export const onceCame = <P extends object>(component: ComponentType<P>) =>
  function OnceCame(given: P) {
    return allDevices.came.value ? h(component, given) : null;
  };
