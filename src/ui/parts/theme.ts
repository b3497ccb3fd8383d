import { KeptChoice } from '../../store/index.ts';
import { storedTheme, type Theme } from '../../workbench/index.ts';
import { storage } from './store.ts';

/** The colours that were chosen, the same in every tab; `public/theme.js` reads them before anything is drawn. */
export const theme = new KeptChoice<Theme>(storage, 'theme', 'system', storedTheme);

/** Lets an element, that of the whole page, have the colours that are chosen. */
export const showTheme = (root: HTMLElement): void => {
  root.dataset['theme'] = theme.value;
};
