import { signal } from '@preact/signals';

/** What the device sent, as typed, and whether it is being compared: both while the page is open. */
export const sentText = signal('');
export const comparing = signal(false);
