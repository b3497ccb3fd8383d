import { type OwnLog, ownLogs, type RowUnit } from './messages.ts';

/** Where a log comes from: the page's own one, a text that was pasted, or a file. Neither of the others is kept. */
export type LogSource = OwnLog | 'pasted' | 'file';
const sources: readonly LogSource[] = [...ownLogs, 'pasted', 'file'];

/** The list of a log, and what is counted of it. */
export const logTabs = ['rows', 'timeline', 'statistics', 'values'] as const;
export type LogTab = (typeof logTabs)[number];
const units: readonly RowUnit[] = ['frame', 'exchange'];

/** What of a log the address says. */
export interface LogPlace {
  readonly source: LogSource | undefined;
  /** The text of the filter, also one with mistakes. */
  readonly filter: string;
  readonly by: RowUnit;
  /** The frame that is chosen, counted from 0; `undefined` if none is. */
  readonly record: number | undefined;
  readonly tab: LogTab;
}

/** A part of an address that was not taken. */
export interface UntakenPart {
  readonly code: 'not-known' | 'log' | 'rows' | 'row' | 'tab';
  readonly name: string;
  readonly text: string;
}

const ROW = /^[1-9]\d{0,8}$/;

/** Reads the parts of an address. What cannot be read is as if it were not there, and told. */
export function readLogPlace(parts: ReadonlyMap<string, string>): {
  readonly place: LogPlace;
  readonly untaken: readonly UntakenPart[];
} {
  const untaken: UntakenPart[] = [];
  const one = <T extends string>(name: 'log' | 'rows' | 'tab', of: readonly T[]): T | undefined => {
    const text = parts.get(name);
    const found = of.find((value) => value === text);
    if (text !== undefined && found === undefined) untaken.push({ code: name, name, text });
    return found;
  };
  const source = one('log', sources);
  const by = one('rows', units) ?? 'frame';
  const tab = one('tab', logTabs) ?? 'rows';
  const row = parts.get('row');
  const record = row !== undefined && ROW.test(row) ? Number(row) - 1 : undefined;
  if (row !== undefined && record === undefined) untaken.push({ code: 'row', name: 'row', text: row });
  const own = Object.keys(logParts({ source, by, tab, record, filter: '' }));
  for (const [name, text] of parts) if (!own.includes(name)) untaken.push({ code: 'not-known', name, text });
  return { place: { source, filter: parts.get('filter') ?? '', by, record, tab }, untaken };
}

/** The parts of the address of a log, by name; what need not be said is empty. */
export const logParts = ({ source, filter, by, record, tab }: LogPlace): Readonly<Record<string, string>> => ({
  log: source ?? '',
  filter,
  rows: by === 'frame' ? '' : by,
  row: record === undefined ? '' : String(record + 1),
  tab: tab === 'rows' ? '' : tab,
});
