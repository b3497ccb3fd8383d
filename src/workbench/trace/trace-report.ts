import type { Profile } from '../../devices/index.ts';
import type { Finding } from '../../diagnosis/index.ts';
import { spacedHex, toHex } from '../../modbus/index.ts';
import { writeTableText } from '../../notation/index.ts';
import {
  causesOf,
  type FaultKind,
  faultKinds,
  type Tally,
  type Trace,
  type TraceCause,
  TraceStatistics,
  type TraceSummary,
} from '../../trace/index.ts';
import { rowOf, type TraceRow } from './row.ts';
import { timeCell } from './trace-csv.ts';

/** The sentences of a report. */
export interface ReportWords {
  readonly title: string;
  readonly size: (summary: TraceSummary) => string;
  readonly faultCount: (kind: FaultKind, count: number) => string;
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
const DAMAGED: ReadonlySet<string> = new Set(['checksum', 'broken']);

/** What a trace is about, to paste into a ticket: Markdown with a summary, causes, the faults with their frames, and statistics by unit. */
export function traceReport(trace: Trace, indexes: Iterable<number>, words: ReportWords, profile?: Profile): string {
  const summary = trace.summary();
  const { faults, units, replyTime } = summary;
  const counted = faultKinds.filter((kind) => faults[kind] > 0);
  const causes = causesOf(trace);
  const lines = [
    `# ${words.title}`,
    '',
    `- ${words.size(summary)}`,
    ...(counted.length === 0
      ? [`- ${words.noFault}`]
      : counted.map((kind) => `- ${words.faultCount(kind, faults[kind])}`)),
    ...(units.length > 0 ? [`- ${words.units(units)}`] : []),
    ...(replyTime ? [`- ${words.replyTime(replyTime.median, replyTime.maximum)}`] : []),
    ...(causes.length === 0 ? [] : ['', `## ${words.causes}`, '', ...causes.map((cause) => `- ${words.cause(cause)}`)]),
  ];
  const rows: string[][] = [];
  let left = 0;
  for (const index of indexes) {
    if (trace.faults(trace.exchangeOf(index)).every(({ records }) => records.at(-1) !== index)) continue;
    if (rows.length === MOST_FAULTS) left++;
    else rows.push(faultRow(trace, rowOf(trace, index, profile), words));
  }
  if (rows.length > 0) {
    lines.push('', `## ${words.faults}`, '', table([[...words.faultColumns], ...rows]));
    if (left > 0) lines.push('', words.more(left));
  }
  const tallies = new TraceStatistics(trace).take().by('unit');
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

function faultRow(trace: Trace, row: TraceRow, words: ReportWords): string[] {
  const { index, time, unit, faults } = row;
  const damaged = faults.some(({ kind }) => DAMAGED.has(kind));
  const [finding] = damaged ? trace.record(index).findings : [];
  const says = [words.sentence(row), ...(finding ? [words.finding(finding)] : [])].join('. ');
  const bytes = trace.bytes(index);
  const shown = spacedHex(toHex(bytes.subarray(0, MOST_BYTES)));
  return [
    String(index + 1),
    timeCell(time),
    String(unit),
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
    rows.map((cells) => cells.map((cell) => (cell.startsWith('`') ? cell : cell.replace(/[\\<>*_[\]`\r\n]/g, marked)))),
    'markdown',
  );

const marked = (character: string) => (/[\r\n]/.test(character) ? ' ' : `\\${character}`);
