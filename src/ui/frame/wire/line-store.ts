import { Line } from '../../../store/index.ts';
import { device } from '../../parts/device/naming.ts';
import { storage } from '../../parts/store.ts';

/** The line on which this page draws frames. */
export const line = new Line(storage, device);
