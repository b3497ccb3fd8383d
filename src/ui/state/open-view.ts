import { Cell } from './cell.ts';

/** The views beside the Frame view. The name of each is its address behind `#`; what it shows follows behind `?`. */
export const otherViews = ['checksum', 'timing', 'bus', 'reference'] as const;
export type OtherView = (typeof otherViews)[number];

/** The view that is open; `undefined` is the Frame view, where the frame at hand waits meanwhile. */
export const openView = new Cell<OtherView | undefined>(undefined);

/** The view that an address names; `undefined` for the address of a frame. */
export const viewAt = (hash: string): OtherView | undefined => otherViews.find((view) => hash.startsWith(`#${view}`));
