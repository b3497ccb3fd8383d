import { computed } from '@preact/signals';
import { Line } from '../../store/index.ts';
import { busLink } from './bus-link.ts';
import { device, remembered } from './device/naming.ts';
import { page, storage } from './store.ts';

/** The serial line of this page: shown in the header, drawn on the wire, timed, and opened by the bus. */
export const line = new Line(
  page,
  storage,
  // Until the devices have come, only the id of the chosen one is known.
  computed(() => device.value ?? { id: page.draft.value.device ?? remembered.value, name: '' }),
  computed(() => ['opening', 'open', 'closing'].includes(busLink.value.kind)),
);
