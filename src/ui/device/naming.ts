import type { Reading } from '../../modbus/index.ts';
import { Cell } from '../cell.ts';

/** What a device calls what is in a frame; empty where it has no name for it. */
export interface FrameNames {
  /** Of the field of this name. */
  readonly field: (name: string) => string;
  /** Of an item of the list of this name, by its index from 0. */
  readonly item: (list: string, index: number) => string;
}

/** How frames are named while a device is chosen; it comes with the devices. */
export const naming = new Cell<((reading: Reading) => FrameNames) | undefined>(undefined);
