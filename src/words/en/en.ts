import { en as fields } from './fields.ts';
import { page, section } from './page.ts';
import { strip } from './strip.ts';
import { views } from './views.ts';

/** The sentences that every page shows, in English. */
export const en = { ...fields, page, section, strip, views };

/** The shape every language has. */
export type Words = typeof en;
