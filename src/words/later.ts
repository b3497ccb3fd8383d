import type { CompareWords } from './en/compare.ts';
import type { ValueWords } from './en/values.ts';
import type { WireWords } from './en/wire.ts';

// Loaders of sentences that come after the first view. In a file of their own, because what loads at first holds whole files.

/** What the comparison of two frames says, which comes with it. */
export const loadCompareWords = (): Promise<CompareWords> => import('./en/compare.ts').then(({ compare }) => compare);

/** The sentences about values in registers, which come with the views for them. */
export const loadValueWords = (): Promise<ValueWords> => import('./en/values.ts').then(({ values }) => values);

/** What is said about a frame on its line, which comes when that is opened. */
export const loadWireWords = (): Promise<WireWords> => import('./en/wire.ts').then(({ wire }) => wire);
