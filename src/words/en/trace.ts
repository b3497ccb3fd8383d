import type { OtherFile, PrintedClock } from '../../captures/index.ts';
import type { EntityTable, NamedValue } from '../../devices/index.ts';
import { describeFunction, dictionary } from '../../modbus/index.ts';
import { entityNumber } from '../../notation/index.ts';
import type { Beside, CauseCode, Outcome, Reason, TraceSummary } from '../../trace/index.ts';
import {
  type RowAbout,
  type RowSaying,
  type RowUnit,
  type RowValue,
  registerNumber,
  type SaidCause,
  type SeenFault,
  type TraceFailure,
  type TraceRow,
} from '../../workbench/index.ts';
import { all, bytesOf, code, grouped, plural } from './common.ts';
import { devices } from './devices.ts';
import { exceptionName } from './sent.ts';
import { traceExport } from './trace-export.ts';
import { traceFilter } from './trace-filter.ts';
import { ofAddress, traceProblem } from './trace-problems.ts';
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

/** What went wrong with one frame. */
const faults: Readonly<Record<SeenFault, string>> = {
  exception: 'exception',
  checksum: 'wrong CRC',
  'no-reply': 'no reply',
  late: 'late',
  doubtful: 'may answer the request before',
  mismatch: 'does not answer its request',
  broken: 'broken',
  stray: 'not asked for',
  timing: 'short silence',
  'no-frame': 'in no frame',
};

/** Why a piece of a text or a file is in no frame. */
const reasons: Readonly<Record<Reason, string>> = {
  'no-frame': 'in no frame',
  'not-a-byte': 'not a byte',
  'value-over-255': 'too large for a byte',
  'odd-digits': 'digits that do not make whole bytes',
  'not-of-base': 'not a number of the same base',
  'character-unknown': 'a character that is not a byte',
  'escape-unknown': 'an escape that is not known',
  'left-out': 'bytes are left out here',
};

/** What came beside the replies. */
const besides: Readonly<Record<Beside, string>> = {
  echo: 'echo of the request',
  late: 'late reply',
  copy: 'the same frame again',
  other: 'not asked for',
  noise: 'noise',
};

const otherFiles: Readonly<Record<OtherFile, string>> = {
  zip: 'an archive (.zip, .xlsx)',
  picture: 'a picture',
  pdf: 'a PDF',
  program: 'a program',
};

/** How a request went, where nothing more is to be said of its replies. */
const outcomes: Readonly<Partial<Record<Outcome, string>>> = {
  absent: 'no reply to a probe',
  ended: 'stopped before its reply',
};

/** What is to be said of a row beside what it says itself: what is wrong, and what the bus knows of it. */
function remarks({ known, faults: found }: Pick<TraceRow, 'known' | 'faults'>): readonly string[] {
  if (known?.beside) return [known.why ? reasons[known.why] : besides[known.beside]];
  const outcome = known?.outcome && outcomes[known.outcome];
  return [
    ...found.map(({ kind, code }) =>
      kind === 'doubtful' && code === 'unsure' ? 'may answer another request' : faults[kind],
    ),
    ...(outcome ? [outcome] : []),
  ];
}

/** Bytes that are not a frame have no function. */
const isFrame = ({ known }: Pick<TraceRow, 'known'>) => known?.beside !== 'noise';

/** What is in no frame, and where it stands: `3 bytes in line 12`, `“0G” in line 3`, `4 bytes from byte 1,024`. */
function piece({ known, place, length }: TraceRow): string {
  const what = known?.text === undefined ? plural(length, 'byte') : `“${known.text}”`;
  if (known?.line !== undefined) return `${what} in line ${grouped(known.line)}`;
  return place?.kind === 'bytes' ? `${what} from byte ${grouped(place.from)}` : what;
}

const MILLISECOND = 1000;
const SECOND = 1_000_000;

/** A length of time in microseconds: `210 µs`, `4.1 ms`, `1.5 s`. */
function duration(time: number): string {
  if (time < MILLISECOND) return `${Math.round(time)} µs`;
  if (time < 10 * MILLISECOND) return `${(time / MILLISECOND).toFixed(1)} ms`;
  return time < 10 * SECOND ? `${grouped(Math.round(time / MILLISECOND))} ms` : `${(time / SECOND).toFixed(1)} s`;
}

const isNamed = (value: RowValue): value is NamedValue => 'register' in value;

/** `40108 = 555`, `P0681 = 4096 (30.0 Hz)`, `00001 = ON`. */
function valueText(value: RowValue, { table }: RowSaying): string {
  const isBit = table === 'coil' || table === 'discrete-input';
  const plain = (number: unknown) => (isBit ? (number ? 'ON' : 'OFF') : String(number));
  if (!isNamed(value)) return `${entityNumber(table, value.address)} = ${plain(value.value)}`;
  const means = devices.inUnits(value);
  const name = registerNumber(value.name);
  if (value.raw === undefined) return `${name} …`;
  return `${name} = ${plain(value.raw)}${means === '' ? '' : ` (${means})`}`;
}

/** `40108–40110`, `P0681–P0682`, or the values. */
function saying(said: RowSaying): string {
  const { table, first, count, names, values, more } = said;
  if (values.length > 0)
    return `${values.map((value) => valueText(value, said)).join(', ')}${more > 0 ? ` and ${grouped(more)} more` : ''}`;
  const place = (address: number, name: string | undefined) =>
    name === undefined ? entityNumber(table, address) : registerNumber(name);
  const from = place(first, names[0]);
  return count > 1 ? `${from}–${place(first + count - 1, names[1])}` : from;
}

/** The time between two frames: `+16 ms`. */
const gapText = (gap: number) => `${gap < 0 ? '−' : '+'}${duration(Math.abs(gap))}`;

/** `200 frames`, `12 exchanges and 1 piece in no frame`: rows, so many of which are such pieces. */
const rows = (count: number, pieces: number, by: RowUnit) =>
  all([
    ...(count > pieces || pieces === 0 ? [plural(count - pieces, by)] : []),
    ...(pieces > 0 ? [counts['no-frame'](pieces)] : []),
  ]);

/** What a row says: values, addresses, or how it was refused. */
function means(row: TraceRow): string {
  const { exception, saying: said, reply } = row;
  if (!isFrame(row)) return piece(row);
  const own = said ? saying(said) : '';
  if (reply) return [own, means(reply)].filter(Boolean).join(' → ');
  return exception === undefined ? own : exceptionName(exception);
}

/** What a request does, by its access and its elements. */
function asks(row: TraceRow): string {
  const { saying: said, functionCode } = row;
  const { access, name } = describeFunction(functionCode, 'request');
  if (said === undefined) return name;
  const { table, first, count, values } = said;
  if (values.length > 0) return `${access === 'writes' ? 'Write ' : `${name}: `}${saying(said)}`;
  if (access !== 'reads') return `${name}: ${saying(said)}`;
  const elements = plural(count, kinds[table][0], kinds[table][1]);
  const own = said.names[0] === undefined ? '' : `, ${saying(said)}`;
  return `Read ${elements} from ${first} (${entityNumber(table, first)})${own}`;
}

const kinds: Readonly<Record<EntityTable, readonly [one: string, many: string]>> = {
  coil: ['coil', 'coils'],
  'discrete-input': ['discrete input', 'discrete inputs'],
  'input-register': ['input register', 'input registers'],
  'holding-register': ['holding register', 'holding registers'],
};

/** A row in words, as it stands in a report: what is asked or answered, and what is wrong with it. */
function sentence(row: TraceRow): string {
  const { exception, side, saying: said, functionCode, reply } = row;
  const wrong = remarks({ known: row.known, faults: row.faults.filter(({ kind }) => kind !== 'exception') });
  if (!isFrame(row)) return [piece(row), ...wrong].join(', ');
  const answer = said && said.values.length > 0 ? saying(said) : describeFunction(functionCode, 'request').name;
  const refused = exception === undefined ? [] : [exceptionName(exception)];
  if (side !== 'response') {
    const answered = reply ? [sentence({ ...reply, faults: [] })] : refused;
    return [asks(row), ...answered, ...wrong].join(', ');
  }
  return [...(refused.length > 0 ? refused : [answer]), ...wrong].join(', ');
}

/** What is to be said of a chosen row beside its bytes; `undefined` if they say all. */
function about({ row, silence }: RowAbout): string | undefined {
  if (!isFrame(row)) {
    const why = row.known?.why;
    return `In no frame: ${piece(row)}${why && why !== 'no-frame' ? `, ${reasons[why]}` : ''}.`;
  }
  if (silence === undefined || row.faults.every(({ kind }) => kind !== 'no-reply')) return undefined;
  const { timeout, next, after } = silence;
  if (next === undefined)
    return timeout === undefined
      ? 'No reply within the time-out.'
      : 'No reply: nothing follows this request in the log.';
  const came = sentence({ ...next, faults: [] });
  if (after === undefined) return `No reply. What comes next: ${came}.`;
  if (timeout === undefined) return `No reply within the time-out. ${duration(after)} later: ${came}.`;
  return after > timeout
    ? `No reply within ${duration(timeout)}. ${duration(after)} later: ${came}.`
    : `No reply before what comes ${duration(after)} later: ${came}.`;
}

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
  source: (name: string | undefined, format: string) =>
    [name ?? (format === 'text' ? 'A pasted text' : ''), name === undefined ? '' : formats[format]]
      .filter(Boolean)
      .join(', '),
  /** Of a file that is neither a text nor a capture, also while it is being read. */
  binary: (name: string, size: number, kind?: OtherFile) =>
    kind === undefined
      ? `${name} is not a text but ${bytesOf(size)}: they are read as what a serial line carried.`
      : `${name} is ${otherFiles[kind]}, not a log: what is found in its ${bytesOf(size)} is found by chance.${kind === 'zip' ? ' A register map is imported in the Devices view.' : ''}`,
  binaryAsFrame: (shown: number, size: number) =>
    shown === size ? 'Show them as a frame' : `Show the first ${bytesOf(shown)} as a frame`,
  cancel: 'Cancel',
  demo: 'The demo log: a drive, a power meter and an input module',
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
