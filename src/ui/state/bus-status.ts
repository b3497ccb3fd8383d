import { Cell } from './cell.ts';

/** How the bus stands, for the header of every view: empty while nothing is connected. */
export const busStatus = new Cell('');
