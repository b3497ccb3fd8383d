import type { WorkerEnd } from '../../bus/index.ts';
import type { CaptureProblem, PrintedClock } from '../../captures/index.ts';
import type { Profile } from '../../devices/index.ts';
import type { CaptureRecord, TraceCause, TraceInput, TraceOptions, TraceSummary } from '../../trace/index.ts';
import type { ExportAnswer, ExportTask, FilePart } from './export.ts';
import type { TraceRow } from './row.ts';
import type { TabAnswer, TabTask } from './tab-messages.ts';

/** A row of the list stands for a frame, or for an exchange. */
export type RowUnit = 'frame' | 'exchange';

/** Logs that the page has itself. */
export const ownLogs = ['demo'] as const;
export type OwnLog = (typeof ownLogs)[number];

/** Where a trace comes from: a text, a log of the page's own, or the bytes of a file as `F`, which a browser hands to a worker. */
export type TraceSource<F> =
  | { readonly kind: 'text'; readonly text: string }
  | { readonly kind: 'own'; readonly log: OwnLog }
  | { readonly kind: 'file'; readonly file: F };

/** What the window asks of what holds the trace. Rows are counted in the list as it is filtered, from 0. */
export type TraceTask<F = unknown> =
  /** Reads a source, whose records take the place of all others. */
  | { readonly kind: 'open'; readonly source: TraceSource<F> }
  /** Of a trace that is more than twice as long, the last `most` records are kept. */
  | { readonly kind: 'append'; readonly records: readonly TraceInput[]; readonly most: number | undefined }
  | { readonly kind: 'clear' }
  /**
   * Makes the list anew; `list` is its number, which all that is said of its rows has. `record` is chosen from now on, and none if it is
   * −1; without it, the record stays that was chosen before.
   */
  | {
      readonly kind: 'filter';
      readonly text: string;
      readonly by: RowUnit;
      readonly list: number;
      readonly record?: number;
    }
  | { readonly kind: 'rows'; readonly from: number; readonly to: number }
  /** All of a row's frame, and the other frame of its exchange. */
  | { readonly kind: 'frame'; readonly row: number }
  /** The next row with a fault behind a row, or the one before it. */
  | { readonly kind: 'fault'; readonly from: number; readonly by: 1 | -1 }
  /** By the speed of which line silences are judged; none are without it. */
  | { readonly kind: 'line'; readonly line: TraceOptions['line'] }
  /** Whose names the rows have. */
  | { readonly kind: 'device'; readonly profile: Profile | undefined }
  | TabTask
  | ExportTask;

/** A cause, without the list of the exchanges that it explains: the filter `cause:` finds them. */
export type SaidCause = TraceCause extends infer One
  ? One extends TraceCause
    ? Omit<One, 'exchanges'>
    : never
  : never;

/** How a record was spoken, all its bytes, and the other frame of its exchange. */
export interface TraceFrame extends Pick<CaptureRecord, 'bytes' | 'transport' | 'side'> {
  readonly index: number;
  readonly request: Uint8Array | undefined;
  readonly reply: Uint8Array | undefined;
  readonly about: RowAbout;
}

/** What is to be said of a row beside what its bytes say. */
export interface RowAbout {
  readonly row: TraceRow;
  /** Of a request that has no reply. */
  readonly silence?: RowSilence | undefined;
}

/** What came in place of a reply. Times are microseconds. */
export interface RowSilence {
  /** How long a reply was waited for; `undefined` where its source waited. */
  readonly timeout: number | undefined;
  /** The next record between the same ends, and how long after the request it was made. */
  readonly next?: TraceRow | undefined;
  readonly after?: number | undefined;
}

/** Where the faults of a list stand: the row of each, and how grave it is, at most 2,000. */
export interface TraceMark {
  readonly row: number;
  readonly severity: 'error' | 'warning';
}

/** What is said of the list: how many rows there are, of the filter's number. */
interface OfList {
  readonly list: number;
}

/** What is answered; `P` are the pieces of files. */
export type TraceAnswer<P = FilePart> =
  | TabAnswer
  | ExportAnswer<P>
  /** How much of the source has been read, in percent. */
  | { readonly kind: 'progress'; readonly percent: number }
  | {
      readonly kind: 'opened';
      readonly format: string;
      /** The first of them. */
      readonly problems: readonly CaptureProblem[];
      readonly problemCount: number;
      /** What the source prints for its times; `undefined` for times since 1970, which are shown by the reader's clock. */
      readonly clock: PrintedClock | undefined;
    }
  /** The trace has other records than before. */
  | {
      readonly kind: 'grown';
      readonly summary: TraceSummary;
      /** How many records are in no frame. */
      readonly pieces: number;
      readonly causes: readonly SaidCause[];
      /** How many there were before the first, which are not kept any more. */
      readonly gone: Readonly<Record<RowUnit, number>>;
    }
  /** The list has other rows than before, `done` says whether all records have been looked at. */
  | (OfList & {
      readonly kind: 'list';
      /** The first row that may be another one than when this was told last. */
      readonly from: number;
      readonly count: number;
      /** How many of the rows are pieces in no frame. */
      readonly pieces: number;
      readonly done: boolean;
      /** How much of the trace has been looked at. */
      readonly percent: number;
      readonly marks: readonly TraceMark[];
      /** The row of the frame that was chosen last. */
      readonly chosen: number | undefined;
    })
  | (OfList & { readonly kind: 'rows'; readonly from: number; readonly rows: readonly TraceRow[] })
  | (OfList & { readonly kind: 'frame'; readonly row: number; readonly frame: TraceFrame })
  /** `row` is absent if there is no other row with a fault. */
  | (OfList & { readonly kind: 'fault'; readonly row: number | undefined })
  | { readonly kind: 'failed'; readonly code: TraceFailure };

/** Why a source could not be read: it is larger than a page takes, its bytes did not come, or nothing reads them. */
export type TraceFailure = 'too-large' | 'unreadable' | WorkerEnd;
