import { profileCodec } from '../../../workbench/index.ts';
import { BrowserList } from '../../state/browser-list.ts';

/** The profiles of a person's own, kept in this browser. */
export const keptProfiles = new BrowserList('devices', profileCodec);
