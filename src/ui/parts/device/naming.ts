import { computed, signal } from '@preact/signals';
import type { Devices } from '../../../store/index.ts';

/** The devices, once they have come: before that, nothing can be said of a device's names. */
export const devices = signal<Devices | undefined>(undefined);

export const devicesCame = computed(() => devices.value !== undefined);

/** The device that is spoken to. */
export const device = computed(() => devices.value?.chosen.value);

/** How frames are named while a device is chosen. */
export const naming = computed(() => devices.value?.naming.value);

export const useNaming = () => naming.value;

/** The names of registers while a device is chosen. */
export const registerNames = computed(() => devices.value?.registerNames.value);
