import type * as ReadViews from './views.ts';

/** What types, pastes and reads bytes comes right behind the first view, with its sentences. */
const views = async (): Promise<typeof ReadViews> => {
  const loaded = await import('./views.ts');
  await loaded.loadWords();
  return loaded;
};

export const loadBytesField = () => views().then(({ BytesField }) => BytesField);
export const loadReadPanel = () => views().then(({ ReadPanel }) => ReadPanel);
export const loadFindings = () => views().then(({ Findings }) => Findings);

/** The comparison is read from text too, and comes in a chunk of its own. */
export const loadComparePanel = () =>
  import('../compare/compare-panel.tsx').then(async ({ ComparePanel, loadWords }) => {
    await loadWords();
    return ComparePanel;
  });
