import { en, type Words } from '../../words/index.ts';

/** The language of the page. */
export const words: Words = en;
