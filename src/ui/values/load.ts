import type * as ValueViews from './views.ts';

/** The views of values in registers come right behind the first view, with their sentences. */
const views = async (): Promise<typeof ValueViews> => {
  const loaded = await import('./views.ts');
  await loaded.loadWords();
  return loaded;
};

export const loadValues = () => views().then(({ Values }) => Values);
export const loadWriteValues = () => views().then(({ WriteValues }) => WriteValues);
