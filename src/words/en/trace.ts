import type { OtherFile, PrintedClock } from '../../captures/index.ts';
import { describeFunction, dictionary } from '../../modbus/index.ts';
import type { CauseCode, TraceSummary } from '../../trace/index.ts';
import type { OwnLog, RowUnit, SaidCause, SeenFault, TraceFailure, TraceRow } from '../../workbench/index.ts';
import { all, bytesOf, code, grouped, plural } from './common.ts';
import { traceExport } from './trace-export.ts';
import { traceFilter } from './trace-filter.ts';
import { ofAddress, traceProblem } from './trace-problems.ts';
import { about, duration, faults, isFrame, means, remarks, sentence } from './trace-row.ts';
import { traceTabs } from './trace-tabs.ts';

/** A kind of fault, so many times. */
const counts: Readonly<Record<SeenFault, (count: number) => string>> = {
  exception: (count) => plural(count, 'exception'),
  checksum: (count) => plural(count, 'wrong CRC'),
  'no-reply': (count) => `${grouped(count)} without a reply`,
  late: (count) => plural(count, 'late reply', 'late replies'),
  doubtful: (count) => plural(count, 'doubtful reply', 'doubtful replies'),
  mismatch: (count) => plural(count, 'wrong reply', 'wrong replies'),
  broken: (count) => plural(count, 'broken frame'),
  stray: (count) => `${grouped(count)} not asked for`,
  timing: (count) => plural(count, 'short silence'),
  'no-frame': (count) => `${plural(count, 'piece')} in no frame`,
};

const otherFiles: Readonly<Record<OtherFile, string>> = {
  zip: 'an archive (.zip, .xlsx)',
  picture: 'a picture',
  pdf: 'a PDF',
  program: 'a program',
};

/** The time between two frames: `+16 ms`. */
const gapText = (gap: number) => `${gap < 0 ? '−' : '+'}${duration(Math.abs(gap))}`;

/** `200 frames`, `12 exchanges and 1 piece in no frame`: rows, so many of which are such pieces. */
const rows = (count: number, pieces: number, by: RowUnit) =>
  all([
    ...(count > pieces || pieces === 0 ? [plural(count - pieces, by)] : []),
    ...(pieces > 0 ? [counts['no-frame'](pieces)] : []),
  ]);

type CauseWords = { readonly [C in CauseCode]: (cause: Extract<SaidCause, { readonly code: C }>) => string };

/** Why many exchanges fail. */
const causes: CauseWords = {
  'unit-silent': ({ units }) =>
    units.length === 1
      ? `Unit ${units[0]} never answers: it is switched off, not connected, or has another number or speed.`
      : `Units ${all(units)} never answer: they are switched off, not connected, or have other numbers or another speed.`,
  'timeout-short': ({ slowest, timeout }) =>
    `The time-out of ${duration(timeout)} is shorter than the slowest reply, which comes after ${duration(slowest)}.`,
  'one-too-late': ({ from }) =>
    `From exchange ${grouped(from + 1)} on each reply answers the request before: the client takes late replies for those to its next requests.`,
  'addresses-end': ({ unit, functionCode, answered }) =>
    answered === 0
      ? `Unit ${unit} answers all that was asked of it with function ${code(functionCode)} with exception 02.`
      : `Unit ${unit} refuses with exception 02 what was asked of it with function ${code(functionCode)} beyond address ${answered - 1}, the highest that it answered.`,
  'long-frames-damaged': ({ least }) =>
    `Only frames of ${grouped(least)} bytes and more are damaged: look at the termination, the cable and the speed.`,
  'unit-damaged': ({ unit }) =>
    `Only frames of unit ${unit} are damaged: look at its wiring, its termination and the settings of its port.`,
  'requests-overlap': ({ shortest }) =>
    `Requests are sent while another one waits for its reply, the nearest ${duration(shortest)} apart: there are two masters on this line.`,
  echo: () => 'The adapter gives back what it sends: turn off its echo.',
  'polled-too-fast': ({ gap, least }) =>
    `Requests follow after a silence of ${duration(gap)}, where the line needs ${duration(least)}: poll more slowly.`,
};

/** What files of traffic are called. */
const formats: Readonly<Record<string, string>> = dictionary({
  pcap: 'a capture (pcap)',
  pcapng: 'a capture (pcapng)',
  'tshark-json': 'what tshark printed as JSON',
  'tshark-fields': 'what tshark printed as fields',
  json: 'a log saved by this page (JSON)',
  csv: 'a table saved by this page (CSV)',
  text: 'a text',
  bytes: 'the bytes of a serial line',
});

const functionName = (of: number) => `${code(of)} ${describeFunction(of, 'request').name}`;

const ownLog: Record<OwnLog, string> = { demo: 'The demo log: a drive, a power meter and an input module' };

const nothingMatches = 'Nothing matches the filter.';
const faultKeys = 'F8 and Shift+F8: next and previous fault.';

/** What the Log view says. */
export const trace = {
  title: 'Log · Framewright',
  empty: 'Paste a log, or drop a file: a capture (pcap, pcapng, also gzipped), a text, or the bytes of a serial line.',
  openFile: 'Open file…',
  opening: (name: string | undefined) => `Reading ${name ?? 'the text'}…`,
  openingDone: (name: string | undefined, percent: number) => `Reading ${name ?? 'the text'}: ${percent} %`,
  /** What is open, by its file and its format. */
  source: (name: string | undefined, format: string, own?: OwnLog) =>
    own === undefined
      ? [name ?? (format === 'text' ? 'A pasted text' : ''), name === undefined ? '' : formats[format]]
          .filter(Boolean)
          .join(', ')
      : ownLog[own],
  /** Of a file that is neither a text nor a capture, also while it is being read. */
  binary: (name: string, size: number, kind?: OtherFile) =>
    kind === undefined
      ? `${name} is not a text but ${bytesOf(size)}: they are read as what a serial line carried.`
      : `${name} is ${otherFiles[kind]}, not a log: what is found in its ${bytesOf(size)} is found by chance.${kind === 'zip' ? ' A register map is imported in the Devices view.' : ''}`,
  binaryAsFrame: (shown: number, size: number) =>
    shown === size ? 'Show them as a frame' : `Show the first ${bytesOf(shown)} as a frame`,
  cancel: 'Cancel',
  ...ofAddress,
  failed: {
    'too-large': 'The file is larger than 1 GB when it is unpacked. Cut it into parts.',
    unreadable: 'The file could not be read.',
    died: 'The browser ended what was reading, perhaps because there was not enough memory.',
    'not-loaded': 'The part of this page that reads logs did not load. Check the network, and open the log again.',
    forbidden:
      'The browser does not let this page work in the background, which it needs for logs. A policy of the browser or of the server forbids workers: ask who manages them.',
  } satisfies Record<TraceFailure, string>,
  /** `200 frames, 101 exchanges` */
  size: ({ frames, exchanges }: TraceSummary) => `${plural(frames, 'frame')}, ${plural(exchanges, 'exchange')}`,
  faultCount: (kind: SeenFault, count: number) => counts[kind](count),
  fault: (kind: SeenFault) => faults[kind],
  units: (units: readonly number[]) => `${units.length === 1 ? 'unit' : 'units'} ${units.join(', ')}`,
  replyTime: (median: number, maximum: number) =>
    `reply after ${duration(median)} (median), ${duration(maximum)} (maximum)`,
  rows,
  /** Says a cause, and then how many faults of which kind it explains. */
  cause: (of: SaidCause) => (causes[of.code] as (of: SaidCause) => string)(of),
  evidence: ({ kind, explained, all: there }: SaidCause) =>
    `explains ${explained === there ? counts[kind](explained) : `${grouped(explained)} of ${counts[kind](there)}`}`,
  causes: 'What explains the faults',
  summary: 'What is in it',
  allRows: (what: string) => `${what}: show all rows`,
  onlyRows: (what: string) => `${what}: show these rows only`,
  noFaults: 'no faults',
  moreUnits: (count: number) => `and ${grouped(count)} more`,
  nothing: 'No frames were found.',
  problems: (count: number) => `${plural(count, 'problem')} while reading`,
  problem: traceProblem,
  moreProblems: (count: number) => `and ${grouped(count)} more`,
  unitChoice: 'A row for each',
  unitNames: { frame: 'frame', exchange: 'exchange' } satisfies Record<RowUnit, string>,
  /** Below it, silences that are too short for this line are faults. */
  silences: (line: string) => `silences at ${line}`,
  timeChoice: 'Time',
  timeNames: { clock: 'clock', since: 'since the first' },
  columns: {
    number: 'no.',
    time: 'time',
    gap: 'gap',
    unit: 'unit',
    function: 'function',
    means: 'what it says',
    after: 'reply after',
    mark: 'fault',
    hex: 'bytes',
  },
  sides: { request: 'request', response: 'reply' },
  /** The strip beside the list; a click in it goes to the nearest fault. */
  marks: (rows: readonly number[], more: number) =>
    rows.length === 0
      ? 'No faults in the list'
      : `Faults in ${rows.length + more === 1 ? 'row' : 'rows'} ${rows.map((row) => grouped(row + 1)).join(', ')}${more > 0 ? ` and ${grouped(more)} more` : ''}: go to the nearest`,
  /** Below the list: how many rows it has, and how to move in it. */
  shown: (count: number, pieces: number, by: RowUnit, filtering: boolean, percent: number, hasChosen: boolean) =>
    count === 0 && !filtering
      ? nothingMatches
      : `${rows(count, pieces, by)}${filtering ? ` so far, ${percent} % looked at` : ''}. ${faultKeys} ${hasChosen ? 'The chosen frame is explained below.' : 'Choose a frame: it is explained below.'}`,
  /** Whose clock shows the times: of a text or what was saved of it, of the computer, or none. */
  clockOf: (format: string, shows: PrintedClock['shows'] | undefined, zone: string) => {
    if (shows === undefined) return `Times, also those of the filter, are of the time zone of this computer, ${zone}.`;
    if (format === 'text') return 'Times, also those of the filter, are as the text prints them.';
    return shows === 'count'
      ? 'Times have no date: they are as the file counts them, also those of the filter.'
      : 'Times, also those of the filter, are as they were printed in the log that was saved.';
  },
  nothingMatches,
  faultKeys,
  ...traceFilter(faults),
  functionName,
  /** The function of a row. */
  functionOf: (row: TraceRow) => (isFrame(row) ? functionName(row.functionCode) : 'not a frame'),
  isFrame,
  remarks,
  duration,
  gap: gapText,
  means,
  sentence,
  about,
  export: traceExport,
  /** What makes the words of a report of these. */
  report: () => import('./trace-report.ts').then(({ reportWords }) => reportWords),
  tabs: traceTabs({ count: (kind, count) => counts[kind](count), duration }),
};
