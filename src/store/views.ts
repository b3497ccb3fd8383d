import { readQuery, writeQuery } from '../workbench/index.ts';

/** The views beside the Frame view, in the order of the header. The name of each is its address behind `#`; what it shows follows behind `?`. */
export const otherViews = ['log', 'bus', 'devices', 'checksum', 'timing', 'reference'] as const;
export type OtherView = (typeof otherViews)[number];

/** The view that an address names; `undefined` for the address of a frame. */
export const viewAt = (hash: string): OtherView | undefined => otherViews.find((view) => hash.startsWith(`#${view}`));

/** What stands behind `?` in the address of a view, by name; of two with one name the first. */
export const partsAt = (hash: string): ReadonlyMap<string, string> =>
  new Map(readQuery(hash.split('?').slice(1).join('?')).toReversed());

/** What of a view's state stands in its address, by name, as typed. */
export type ViewParts = Readonly<Record<string, string>>;

/** Longer texts, in characters, are not put into an address. */
const MOST_ADDRESSED = 8000;

/** The address of a view that shows these parts of its state; parts with an empty or a very long text are left out. */
export function addressOf(view: OtherView, parts: ViewParts): string {
  const query = writeQuery(Object.entries(parts).filter(([, text]) => text !== '' && text.length <= MOST_ADDRESSED));
  return `#${view}${query === '' ? '' : `?${query}`}`;
}
