import { fetchComplaints } from './language.ts';
import { fetchTools } from './lazy.ts';
import type * as DeviceViews from './device/views.ts';
import type * as ReadViews from './read/views.ts';

// The parts of the page that come right behind the first view, each with its sentences.

/** What is typed and pasted as bytes, with its sentences. */
export const readViews = async (): Promise<typeof ReadViews> => {
  const loaded = await import('./read/views.ts');
  await loaded.loadWords();
  return loaded;
};

const Nothing = () => null;

/** What comes whatever is shown, and has its own places: sentences, tools, and reading. Nothing stands where it is asked for. */
export const loadBehind = async () => {
  await Promise.all([fetchComplaints(), fetchTools(), readViews()]);
  return Nothing;
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

const deviceViews = async (): Promise<typeof DeviceViews> => {
  const loaded = await import('./device/views.ts');
  await loaded.start();
  return loaded;
};

export const loadDevicePanel = () => deviceViews().then(({ DevicePanel }) => DevicePanel);
export const loadDeviceAddress = () => deviceViews().then(({ DeviceAddress }) => DeviceAddress);
