import { computed, signal } from '@preact/signals';
import { useMemo } from 'preact/hooks';
import { type Devices, rememberedDevice } from '../../../store/index.ts';
import { page, storage } from '../store.ts';
import { useVocabulary } from '../words.ts';

/** The device that was chosen by hand, also before the devices have come. */
export const remembered = rememberedDevice(storage);

/** The devices, once one of them is chosen and they and their words have come. */
export const devices = signal<Devices | undefined>(undefined);

/** Whether a device is chosen, by hand or by the frame's link. */
export const devicesWanted = computed(() => remembered.value !== '' || page.draft.value.device !== undefined);

/** Whether all is known of the device that is chosen: until then nothing can be said of names that are unknown. */
export const devicesCame = computed(() => devices.value !== undefined || !devicesWanted.value);

/** The device that is spoken to. */
export const device = computed(() => devices.value?.chosen.value);

/** The names of registers while a device is chosen. */
export const registerNames = computed(() => devices.value?.registerNames.value);

/** How frames are named while a device is chosen. */
export function useNaming() {
  const vocabulary = useVocabulary();
  const profile = device.value;
  return useMemo(() => profile && devices.value?.naming(vocabulary.of('devices')), [profile]);
}
