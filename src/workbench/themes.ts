import { oneOf } from './stored.ts';

/** The colours of the page: those of the system, light, or dark. */
export const themes = ['system', 'light', 'dark'] as const;
export type Theme = (typeof themes)[number];

/** The theme that was chosen, out of storage. */
export const storedTheme = oneOf(themes);
