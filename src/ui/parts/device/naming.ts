import type { Profile } from '../../../devices/index.ts';
import type { Reading } from '../../../modbus/index.ts';
import type { FrameNames, RegisterNames } from '../../../workbench/index.ts';
import { Cell } from '../../state/cell.ts';

/** The device that is spoken to; it comes with the devices. */
export const device = new Cell<Profile | undefined>(undefined);

/** Whether the devices have come: before that, nothing can be said of a device's names. */
export const devicesCame = new Cell(false);

/** How frames are named while a device is chosen; it comes with the devices. */
export const naming = new Cell<((reading: Reading) => FrameNames) | undefined>(undefined);

/** The names of registers while a device is chosen; they come with the devices. */
export const registerNames = new Cell<RegisterNames | undefined>(undefined);
