import type { PrintedClock } from '../../captures/index.ts';
import type { Profile } from '../../devices/index.ts';
import type { Finding } from '../../diagnosis/index.ts';
import { spacedHex, toHex } from '../../modbus/index.ts';
import { writeTableText } from '../../notation/index.ts';
import {
  causesOf,
  faultKinds,
  type Tally,
  type Trace,
  type TraceCause,
  TraceStatistics,
  type TraceSummary,
} from '../../trace/index.ts';
import { rowOf, type TraceRow } from './row.ts';
import { type SeenFault, seenCounts } from './seen-fault.ts';
import { timeCell } from './trace-csv.ts';

/** The sentences of a report. */
export interface ReportWords {
  readonly title: string;
  readonly size: (summary: TraceSummary) => string;
  readonly faultCount: (kind: SeenFault, count: number) => string;
  readonly units: (units: readonly number[]) => string;
  readonly replyTime: (median: number, maximum: number) => string;
  readonly noFault: string;
  readonly causes: string;
  readonly cause: (cause: TraceCause) => string;
  readonly faults: string;
  /** The columns of the table of faults: number, time, unit, what is said, and the bytes. */
  readonly faultColumns: readonly [string, string, string, string, string];
  readonly sentence: (row: TraceRow) => string;
  /** What is known of damaged bytes beyond that. */
  readonly finding: (finding: Finding) => string;
  /** The table has the faults of so many frames only, those that a filter keeps. */
  readonly filtered: (frames: number, filter: string | undefined) => string;
  /** Faults that the table leaves out. */
  readonly more: (count: number) => string;
  readonly statistics: string;
  /** Unit, exchanges, replies, faults, median, 95th percentile and maximum of the time to reply. */
  readonly unitColumns: readonly [string, string, string, string, string, string, string];
  readonly duration: (microseconds: number) => string;
}

/** Faults of which a report shows the frames. */
const MOST_FAULTS = 100;
/** Bytes of a frame that a report shows. */
const MOST_BYTES = 64;
/** Exchanges and frames that are looked at in one step. */
const EXCHANGES = 4000;
const FRAMES = 50_000;
/** The part of the time that goes into counting. */
const COUNTING = 0.8;
const DAMAGED: ReadonlySet<string> = new Set(['checksum', 'broken']);

/** What a report is of, beside the trace. */
export interface ReportSource {
  /** Where the trace comes from. */
  readonly source?: string | undefined;
  /** The frames whose faults are shown; all if it is left out. */
  readonly indexes?: ArrayLike<number> | undefined;
  /** The filter that keeps them; `undefined` if it is not to be shown. */
  readonly filter?: string | undefined;
  readonly profile?: Profile | undefined;
  /** What the source prints for its times. */
  readonly clock?: PrintedClock | undefined;
}

/** What a trace is about, to paste into a ticket: Markdown with a summary, causes, the faults with their frames, and statistics by unit. */
export function traceReport(trace: Trace, words: ReportWords, of: ReportSource = {}): string {
  const steps = reportSteps(trace, words, of);
  for (;;) {
    const step = steps.next();
    if (step.done) return step.value;
  }
}

/** Makes a report in steps, each of which tells the part that is done, from 0 to 1. */
export function* reportSteps(
  trace: Trace,
  words: ReportWords,
  { source, indexes, filter, profile, clock }: ReportSource,
): Generator<number, string, undefined> {
  const statistics = new TraceStatistics(trace);
  while (statistics.take(0, EXCHANGES).taken < trace.exchangeCount)
    yield (COUNTING * statistics.taken) / trace.exchangeCount;
  const lines = overview(trace, words, source);
  const rows: string[][] = [];
  let left = 0;
  let frames = indexes?.length ?? trace.size;
  const { length: size } = indexes ?? { length: trace.size };
  for (let at = 0; at < size; at++) {
    if (at % FRAMES === 0) yield COUNTING + ((1 - COUNTING) * at) / size;
    const index = indexes?.[at] ?? at;
    if (!trace.isFrame(index)) frames--;
    if (trace.faults(trace.exchangeOf(index)).every(({ records }) => records.at(-1) !== index)) continue;
    if (rows.length === MOST_FAULTS) left++;
    else rows.push(faultRow(trace, rowOf(trace, index, profile), words, clock));
  }
  if (rows.length > 0 || indexes) lines.push('', `## ${words.faults}`, '');
  if (indexes) lines.push(words.filtered(frames, filter && codeSpan(filter)), '');
  if (rows.length > 0) lines.push(table([[...words.faultColumns], ...rows]));
  else if (indexes) lines.push(words.noFault);
  if (left > 0) lines.push('', words.more(left));
  const tallies = statistics.by('unit');
  if (tallies.length > 0) {
    lines.push(
      '',
      `## ${words.statistics}`,
      '',
      table([[...words.unitColumns], ...tallies.map((one) => tallyRow(one, words))]),
    );
  }
  return `${lines.join('\n')}\n`;
}

/** What the whole is, and what explains its faults. */
function overview(trace: Trace, words: ReportWords, source: string | undefined): string[] {
  const summary = trace.summary();
  const { units, replyTime } = summary;
  const counted = [...seenCounts(summary, trace.pieces)];
  const causes = causesOf(trace);
  return [
    `# ${words.title}`,
    '',
    ...(source ? [`- ${escaped(source)}`] : []),
    `- ${words.size(summary)}`,
    ...(counted.length === 0
      ? [`- ${words.noFault}`]
      : counted.map(([kind, count]) => `- ${words.faultCount(kind, count)}`)),
    ...(units.length > 0 ? [`- ${words.units(units)}`] : []),
    ...(replyTime ? [`- ${words.replyTime(replyTime.median, replyTime.maximum)}`] : []),
    ...(causes.length === 0 ? [] : ['', `## ${words.causes}`, '', ...causes.map((cause) => `- ${words.cause(cause)}`)]),
  ];
}

/** A text as code, whatever backticks it has. */
function codeSpan(text: string): string {
  const longest = Math.max(0, ...[...text.matchAll(/`+/g)].map(([run]) => run.length));
  if (longest === 0) return `\`${text}\``;
  const marks = '`'.repeat(longest + 1);
  return `${marks} ${text} ${marks}`;
}

function faultRow(trace: Trace, row: TraceRow, words: ReportWords, clock: PrintedClock | undefined): string[] {
  const { index, time, unit, faults } = row;
  const damaged = faults.some(({ kind }) => DAMAGED.has(kind));
  const [finding] = damaged ? trace.record(index).findings : [];
  const says = [words.sentence(row), ...(finding ? [words.finding(finding)] : [])].join('. ');
  const bytes = trace.bytes(index);
  const shown = spacedHex(toHex(bytes.subarray(0, MOST_BYTES)));
  return [
    String(index + 1),
    timeCell(time, clock),
    trace.isFrame(index) ? String(unit) : '',
    says,
    `\`${shown}${bytes.length > MOST_BYTES ? ' …' : ''}\``,
  ];
}

function tallyRow({ unit, exchanges, replies, faults, replyTime }: Tally, { duration }: ReportWords): string[] {
  const all = faultKinds.reduce((sum, kind) => sum + faults[kind], 0);
  const times = replyTime ? [replyTime.median, replyTime.p95, replyTime.maximum].map(duration) : ['', '', ''];
  return [unit, exchanges, replies, all, ...times].map((cell) => String(cell ?? ''));
}

/** A name of a device may hold what Markdown or HTML would take for a mark. */
const table = (rows: readonly (readonly string[])[]): string =>
  writeTableText(
    rows.map((cells) => cells.map((cell) => (cell.startsWith('`') ? cell : escaped(cell)))),
    'markdown',
  );

const escaped = (text: string) => text.replace(/[\\<>*_[\]`\r\n]/g, marked);
const marked = (character: string) => (/[\r\n]/.test(character) ? ' ' : `\\${character}`);
