import { Addresses } from '../../../store/index.ts';
import { device, registerNames } from '../../parts/device/naming.ts';
import { page, storage } from '../../parts/store.ts';

/** Addresses as the chosen manual and the chosen device have them. */
export const addresses = new Addresses(page, storage, { device, registerNames });
