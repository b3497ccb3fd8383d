// The parts of the page that come right behind the first view.

/** A chunk of the page; its sentences are a chunk of their own. */
interface Chunk {
  readonly loadWords: () => Promise<void>;
}

/** Brings a view of a chunk, with its sentences. */
const from =
  <C extends Chunk, V>(load: () => Promise<C>, view: (chunk: C) => V) =>
  async (): Promise<V> => {
    const chunk = await load();
    await chunk.loadWords();
    return view(chunk);
  };

const values = () => import('./values/value-views.ts');

export const loadValues = from(values, ({ Values }) => Values);
export const loadWriteValues = from(values, ({ WriteValues }) => WriteValues);
export const loadComparePanel = () => import('./compare/compare-panel.tsx').then(({ ComparePanel }) => ComparePanel);
export const loadWire = from(
  () => import('./wire/wire-panel.tsx'),
  ({ WirePanel }) => WirePanel,
);
