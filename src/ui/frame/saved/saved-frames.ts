import { SavedFrames } from '../../../store/index.ts';
import { storage } from '../../parts/store.ts';

/** The frames kept in this browser. */
export const savedFrames = new SavedFrames(storage);
