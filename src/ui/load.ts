import type * as ReadViews from './read/views.ts';

// The parts of the page that come right behind the first view, each with its sentences.

/** Reading is listened for everywhere on the page, so that it is loaded whatever is shown. */
export const readViews = async (): Promise<typeof ReadViews> => {
  const loaded = await import('./read/views.ts');
  await loaded.loadWords();
  return loaded;
};

export const loadBytesField = () => readViews().then(({ BytesField }) => BytesField);
export const loadReadPanel = () => readViews().then(({ ReadPanel }) => ReadPanel);
export const loadFindings = () => readViews().then(({ Findings }) => Findings);

/** The comparison is read from text too, and comes in a chunk of its own. */
export const loadComparePanel = () =>
  import('./compare/compare-panel.tsx').then(async ({ ComparePanel, loadWords }) => {
    await loadWords();
    return ComparePanel;
  });

const shelfViews = () => import('./examples/index.ts').then(({ loadViews }) => loadViews());

export const loadShelf = () => shelfViews().then(({ Shelf }) => Shelf);
export const loadSourceNote = () => shelfViews().then(({ SourceNote }) => SourceNote);

export const loadDevicePanel = () =>
  import('./device/views.ts').then(async ({ DevicePanel, start }) => {
    await start();
    return DevicePanel;
  });
