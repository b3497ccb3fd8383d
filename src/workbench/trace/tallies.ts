import { type TableFormat, writeTableText } from '../../notation/index.ts';
import { type FaultKind, faultKinds, type Spread, type Tallied, type Tally } from '../../trace/index.ts';

/** What exchanges are counted by. */
const subjects = ['unit', 'functionCode', 'address', 'quantity', 'connection'] as const;
type TallySubject = (typeof subjects)[number];
type TallyCount = 'exchanges' | 'replies' | 'faults';
type TallyTime = keyof Spread | 'interval';
/** Columns of the table of tallies. Times are microseconds; `faults` is how many there are of all kinds. */
export type TallyColumn = TallySubject | TallyCount | TallyTime;

const ofSubject: Readonly<Record<Tallied, readonly TallySubject[]>> = {
  unit: ['unit'],
  function: ['functionCode'],
  address: ['unit', 'functionCode', 'address'],
  connection: ['connection'],
  poll: ['unit', 'functionCode', 'address', 'quantity'],
};

/** The columns of a table, those that say what is counted first. */
export const tallyColumns = (by: Tallied): readonly TallyColumn[] => [
  ...ofSubject[by],
  'exchanges',
  'replies',
  'faults',
  'minimum',
  'median',
  'p95',
  'maximum',
  ...(by === 'poll' ? (['interval'] as const) : []),
];

/** How many columns say what is counted. */
export const subjectColumns = (by: Tallied): number => ofSubject[by].length;

/** How many faults a tally has of all kinds. */
const faultCount = ({ faults }: Tally): number => faultKinds.reduce((sum, kind) => sum + faults[kind], 0);

/** What a column has of a tally; `undefined` if it has nothing to say. The interval is the median one. */
export function tallyValue(tally: Tally, column: TallyColumn): number | string | undefined {
  switch (column) {
    case 'unit':
    case 'functionCode':
    case 'address':
    case 'quantity':
    case 'connection':
    case 'exchanges':
    case 'replies':
      return tally[column];
    case 'faults':
      return faultCount(tally);
    case 'interval':
      return tally.interval?.median;
    default:
      return tally.replyTime?.[column];
  }
}

/** Rows of statistics that are shown. */
export const MOST_TALLIES = 2000;

export interface TallySort {
  readonly by: TallyColumn;
  readonly down: boolean;
}

/** Tallies in the order of a column, those without a value last; in their own order if none is given. */
export function sortedTallies(tallies: readonly Tally[], sort: TallySort | undefined): readonly Tally[] {
  if (sort === undefined) return tallies;
  const sign = sort.down ? -1 : 1;
  const valued = tallies.map((tally) => ({ tally, value: tallyValue(tally, sort.by) }));
  valued.sort(({ value: one }, { value: other }) => {
    if (one === undefined || other === undefined) return Number(one === undefined) - Number(other === undefined);
    return sign * (one < other ? -1 : Number(one > other));
  });
  return valued.map(({ tally }) => tally);
}

/** What a table of tallies says, in words. */
export interface TallyWords {
  readonly columns: Readonly<Record<TallyColumn, string>>;
  /** The head of a column of faults, and of one with the name of each exception. */
  readonly fault: (kind: FaultKind) => string;
  readonly exceptions: string;
  readonly exception: (code: number, count: number) => string;
  readonly functionName: (code: number) => string;
  readonly noConnection: string;
}

const MILLISECOND = 1000;
const TIMES: ReadonlySet<TallyColumn> = new Set(['minimum', 'median', 'p95', 'maximum', 'interval']);

/** Tallies as a text, with a column for each kind of fault that occurs. Times are milliseconds; addresses are as sent. */
export function talliesText(by: Tallied, tallies: readonly Tally[], words: TallyWords, format: TableFormat): string {
  const kinds = faultKinds.filter((kind) => tallies.some(({ faults }) => faults[kind] > 0));
  const columns = tallyColumns(by);
  const cell = (tally: Tally, column: TallyColumn): readonly string[] => {
    if (column === 'faults') return kinds.map((kind) => String(tally.faults[kind]));
    const value = tallyValue(tally, column);
    if (column === 'functionCode' && typeof value === 'number') return [words.functionName(value)];
    if (column === 'connection') return [value === undefined ? words.noConnection : String(value)];
    if (TIMES.has(column) && typeof value === 'number') return [String(value / MILLISECOND)];
    return [String(value ?? '')];
  };
  const head = columns.flatMap((column) =>
    column === 'faults'
      ? kinds.map(words.fault)
      : [TIMES.has(column) ? `${words.columns[column]} (ms)` : words.columns[column]],
  );
  const exceptions = ({ exceptions }: Tally) =>
    [...exceptions].map(([code, count]) => words.exception(code, count)).join('; ');
  const hasExceptions = kinds.includes('exception');
  return writeTableText(
    [
      [...head, ...(hasExceptions ? [words.exceptions] : [])],
      ...tallies.map((tally) => [
        ...columns.flatMap((column) => cell(tally, column)),
        ...(hasExceptions ? [exceptions(tally)] : []),
      ]),
    ],
    format,
  );
}
