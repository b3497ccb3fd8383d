import { computed, signal } from '@preact/signals';
import { useMemo } from 'preact/hooks';
import { type Devices, KeptChoice } from '../../../store/index.ts';
import { text } from '../../../workbench/index.ts';
import { page, storage } from '../store.ts';
import { useVocabulary } from '../words.ts';

/** The id of the device that was chosen by hand, also before the devices have come. Another tab's choice does not change it. */
export const remembered = new KeptChoice(storage, 'device', '', text(), 'tab');

/** The devices, once one of them is chosen and they and their words have come. */
export const devices = signal<Devices | undefined>(undefined);

/** Whether a device is chosen, by hand or by the frame's link. */
export const devicesWanted = computed(() => remembered.value !== '' || page.draft.value.device !== undefined);

/** Whether all is known of the device that is chosen: until then nothing can be said of names that are unknown. */
export const devicesCame = computed(() => devices.value !== undefined || !devicesWanted.value);

/** The chosen device. */
export const device = computed(() => devices.value?.chosen.value);

/** The names of registers while a device is chosen. */
export const registerNames = computed(() => devices.value?.registerNames.value);

/** How frames are named while a device is chosen. */
export function useNaming() {
  const vocabulary = useVocabulary();
  const profile = device.value;
  return useMemo(() => profile && devices.value?.naming(vocabulary.of('devices')), [profile]);
}
