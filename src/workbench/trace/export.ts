import { type PrintedClock, pcapngBlocks, traceJsonParts } from '../../captures/index.ts';
import type { Profile } from '../../devices/index.ts';
import { joinBytes } from '../../modbus/index.ts';
import { type CaptureRecord, Trace } from '../../trace/index.ts';
import { type ReaderClock, recordTime } from './moment.ts';
import { StandIns } from './replaced.ts';
import type { Replaced } from './replaced-bytes.ts';
import type { TraceRow } from './row.ts';
import { timeCell, traceCsvLines } from './trace-csv.ts';
import { type ReportWords, reportSteps } from './trace-report.ts';

/** What a trace is saved as: a capture for Wireshark, a table, a file for programs, and a report in Markdown. */
export const exportFormats = ['pcapng', 'csv', 'json', 'report'] as const;
export type ExportFormat = (typeof exportFormats)[number];

/** What is to be saved. */
export interface ExportWanted {
  readonly format: ExportFormat;
  readonly replaced: Replaced;
}

/** What is saved: the frames of a trace. */
export interface ExportSource {
  readonly trace: Trace;
  /** The frames by their indexes, in order; all if it is left out. */
  readonly indexes?: ArrayLike<number> | undefined;
  /** Where the trace comes from, and the filter that keeps the frames, as the report says them. */
  readonly source?: string | undefined;
  readonly filter?: string | undefined;
  /** The names that sentences have. */
  readonly profile?: Profile | undefined;
  /** What the source prints for its times; without it they are UTC since 1970, or count from the first record. */
  readonly clock?: PrintedClock | undefined;
  /** The reader's clock: a date without a zone is of it. */
  readonly zone?: ReaderClock | undefined;
}

/** What a table and a report say; a report cannot be made without its own words. */
export interface ExportWords {
  readonly sentence: ((row: TraceRow) => string) | undefined;
  readonly report: ReportWords | undefined;
}

/** A piece of a file. */
export type FilePart = string | Uint8Array<ArrayBuffer>;

export type ExportTask =
  /** Makes a file, of all frames or of those that the filter keeps; `source` and `filter` are what the report says of them. */
  | {
      readonly kind: 'export';
      /** By which its answers are known. */
      readonly order: number;
      readonly wanted: ExportWanted;
      readonly ofFiltered: boolean;
      readonly source: string;
    }
  /** Gives up the file that is being made. */
  | { readonly kind: 'no-export' };

export type ExportAnswer<P = FilePart> =
  /** It cannot be made: its words have not come. */
  | { readonly kind: 'not-exported'; readonly order: number }
  | { readonly kind: 'exporting'; readonly order: number; readonly percent: number }
  | { readonly kind: 'exported'; readonly order: number; readonly frames: number; readonly parts: readonly P[] };

/** Endings and media types. */
export const exportFiles: Readonly<Record<ExportFormat, { readonly ending: string; readonly type: string }>> = {
  pcapng: { ending: 'pcapng', type: 'application/x-pcapng' },
  csv: { ending: 'csv', type: 'text/csv' },
  json: { ending: 'json', type: 'application/json' },
  report: { ending: 'md', type: 'text/markdown' },
};

/** Whether anything is replaced. */
const hides = ({ units, addresses, times }: Replaced): boolean => Boolean(units || addresses || times);

/** The name of a file that is saved: that of the source, which might tell what is replaced, or a plain one. */
export function exportName({ format, replaced }: ExportWanted, source: string | undefined): string {
  const stem = source?.replace(/(?:\.(?:gz|pcap|pcapng|cap|csv|json|md|txt|log|bin))+$/i, '');
  return `${hides(replaced) ? 'log-replaced' : `${stem || 'log'}-saved`}.${exportFiles[format].ending}`;
}

const UTC: ReaderClock = () => 0;
/** Frames that are worked on in one step. */
const STEP = 2000;

/**
 * Makes a file of a trace in steps, each of which tells the part that is done, from 0 to 1. What is replaced is nowhere in the file: names of a
 * device would tell its addresses, and the name of the source and the filter may tell anything.
 */
export function* exportSteps(
  of: ExportSource,
  { format, replaced }: ExportWanted,
  words: ExportWords,
): Generator<number, readonly FilePart[], undefined> {
  const { indexes } = of;
  if (!hides(replaced)) return yield* written(of, format, (index) => of.trace.plain(index), words);
  const stand = new StandIns(of.trace, replaced);
  while (!stand.learn(STEP)) yield LEARNING * stand.learned;
  const isRecords = format === 'pcapng' || format === 'json';
  const before = isRecords ? LEARNING : 2 * LEARNING;
  const trace = isRecords ? of.trace : yield* replacedSteps(of.trace, stand);
  const clock = replaced.times ? undefined : of.clock;
  const steps = written({ trace, indexes, clock, zone: of.zone }, format, (index) => stand.record(index), words);
  for (;;) {
    const step = steps.next();
    if (step.done) return step.value;
    yield before + (1 - before) * step.value;
  }
}

/** The part of the time that goes into learning what is to be replaced, and into tracing what is. */
const LEARNING = 0.3;

function* replacedSteps(trace: Trace, stand: StandIns): Generator<number, Trace, undefined> {
  const made = new Trace({ timeout: trace.timeout / 1000 });
  for (let index = 0; index < stand.size; index++) {
    if (index % STEP === 0) yield LEARNING * (1 + index / stand.size);
    made.add(stand.record(index));
  }
  return made;
}

function* written(
  of: ExportSource,
  format: ExportFormat,
  record: (index: number) => CaptureRecord,
  words: ExportWords,
): Generator<number, readonly FilePart[], undefined> {
  const { trace, indexes, clock, zone = UTC } = of;
  if (format === 'report') {
    if (words.report === undefined) throw new TypeError('No words for a report');
    return [yield* reportSteps(trace, words.report, of)];
  }
  const size = indexes?.length ?? trace.size;
  const chosen = indexes === undefined ? range(size) : range(size, indexes);
  if (format === 'csv') return yield* pieces(traceCsvLines(trace, chosen, words.sentence ?? (() => ''), of), size);
  const records = mapped(chosen, record);
  if (format === 'json')
    return yield* pieces(
      traceJsonParts(records, (time) => timeCell(time, clock)),
      size,
    );
  return yield* pieces(pcapngBlocks(packets(records, clock, zone)), size);
}

function* range(size: number, indexes?: ArrayLike<number>): Generator<number, void, undefined> {
  for (let at = 0; at < size; at++) yield indexes?.[at] ?? at;
}

/** A packet for each record that has bytes. Its time is since 1970 as far as the source has a date, else as its clock prints it. */
function* packets(
  records: Iterable<CaptureRecord>,
  clock: PrintedClock | undefined,
  zone: ReaderClock,
): Generator<CaptureRecord, void, undefined> {
  for (const record of records) {
    const { time, bytes } = record;
    if (bytes.length > 0)
      yield time === undefined || clock === undefined ? record : { ...record, time: sinceEpoch(time) };
  }
  function sinceEpoch(time: number): number {
    if (clock?.shows === 'zone') return time;
    return clock?.shows === 'date' ? recordTime(time, zone) : time + (clock?.shift ?? 0);
  }
}

function* mapped<A, B>(list: Iterable<A>, make: (one: A) => B): Generator<B, void, undefined> {
  for (const one of list) yield make(one);
}

/** The parts of a file in larger pieces, a step for each; there is about one part a frame. */
function* pieces(parts: Iterable<FilePart>, frames: number): Generator<number, readonly FilePart[], undefined> {
  const made: FilePart[] = [];
  let [texts, bytes]: [string[], Uint8Array[]] = [[], []];
  const flush = () => {
    if (texts.length > 0) made.push(texts.join(''));
    if (bytes.length > 0) made.push(joinBytes(bytes));
    [texts, bytes] = [[], []];
  };
  let count = 0;
  for (const part of parts) {
    if (typeof part === 'string') texts.push(part);
    else bytes.push(part);
    count++;
    if (count % STEP !== 0) continue;
    flush();
    yield Math.min(1, count / Math.max(1, frames));
  }
  flush();
  return made;
}
