import { signal } from '@preact/signals';
import type { LinkState } from '../../bus/index.ts';
import type { Bus, MapReading } from '../../store/index.ts';

/** How the line of the bus stands, for the header of every view. The bus itself comes with its view, and writes this. */
export const busLink = signal<LinkState>({ kind: 'closed' });

/** The bus, once it has come: what sends the current frame from the Frame view waits for it. */
export const openBus = signal<Bus | undefined>(undefined);

/** Reads the maps of devices on the bus, once that has come. */
export const mapReading = signal<MapReading | undefined>(undefined);
