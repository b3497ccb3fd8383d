import { signal } from '@preact/signals';

/** How the bus stands, for the header of every view: empty while nothing is connected. */
export const busStatus = signal('');
