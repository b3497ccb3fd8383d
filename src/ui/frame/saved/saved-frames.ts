import { SavedFrames } from '../../../store/index.ts';
import { storage } from '../../state/draft.ts';

/** The frames kept in this browser. */
export const savedFrames = new SavedFrames(storage);
