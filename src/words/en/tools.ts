import { addresses } from './addresses.ts';
import { byteMeaning, groupFieldMeaning, itemMeaning, itemsMeaning, meaning } from './meanings.ts';
import { plural } from './numbers.ts';

/** What the tools around a frame say. */
export const tools = {
  addresses,
  byteMeaning,
  groupFieldMeaning,
  itemMeaning,
  itemsMeaning,
  meaning,
  unfoldAll: 'Unfold all bytes',
  /** A button that shows the single bytes of a field. */
  unfold: (bytes: string) => `The single bytes of ${bytes}`,
  moreLines: (count: number) => `${plural(count, 'more line')} not shown.`,
  showMoreLines: (count: number) => `Show the next ${count}`,
};

export type ToolWords = typeof tools;
