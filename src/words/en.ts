import { en as fields } from './en-fields.ts';
import { page, section } from './en-page.ts';

/** The sentences that every page shows, in English. */
export const en = { ...fields, page, section };

/** The shape every language has. */
export type Words = typeof en;
