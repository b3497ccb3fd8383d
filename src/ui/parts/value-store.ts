import { Values } from '../../store/index.ts';
import { device } from './device/naming.ts';
import { storage } from './store.ts';

/** How values are looked at and written in this page. */
export const valueStore = new Values(storage, device);
