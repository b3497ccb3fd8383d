import type { FormatStanding, GapEffect, SerialMode, Silences } from '../../modbus/index.ts';
import { formatHex, type TableFormat } from '../../notation/index.ts';
import type { ExchangeStepKind, ReplySource } from '../../workbench/index.ts';
import { code, plural } from './common.ts';

// All times are microseconds.
const MILLISECOND = 1000;
const SECOND = 1_000_000;

/** At most three decimals; a whole number has no decimals. */
const short = (value: number): string => value.toFixed(3).replace(/\.000$/, '');
const inMicroseconds = (time: number) => `${short(time)} µs`;
const inMilliseconds = (time: number) => `${short(time / MILLISECOND)} ms`;

/** A time in the unit that suits it. */
function time(microseconds: number): string {
  if (microseconds < MILLISECOND) return inMicroseconds(microseconds);
  return microseconds < SECOND ? inMilliseconds(microseconds) : `${short(microseconds / SECOND)} s`;
}

/** The same time in another unit. */
const otherTime = (microseconds: number) =>
  microseconds < MILLISECOND || microseconds >= SECOND ? inMilliseconds(microseconds) : inMicroseconds(microseconds);

const bits = (count: number) => plural(Number(count.toFixed(1)), 'bit');
const characters = (count: number) => plural(count, 'character');

const standings: Readonly<Record<FormatStanding, string>> = {
  default: 'Default',
  named: 'Also in the specification',
  common: 'Common, not in the specification',
  unusual: 'Unusual',
  impossible: 'Not possible',
};

const formatHints: Readonly<Record<SerialMode, Readonly<Record<FormatStanding, string>>>> = {
  rtu: {
    default: 'The default: every RTU device must support it.',
    named: 'In the specification beside 8E1; a device does not have to support it.',
    common:
      'Common, but not in the specification: without parity it asks for two stop bits, so that there are 11 bits.',
    unusual: 'Not in the specification, whose characters have 11 bits: 8E1, 8O1, 8N2.',
    impossible: 'RTU sends bytes of eight bits; seven have no room for them. Choose 8 data bits, or ASCII.',
  },
  ascii: {
    default: 'The default of ASCII.',
    named: 'In the specification beside 7E1; a device does not have to support it.',
    common: 'Common, but not in the specification, which has 7 data bits for ASCII.',
    unusual: 'Not in the specification, which has 7E1, 7O1 and 7N2 for ASCII.',
    impossible: '',
  },
};

const effects: Readonly<Record<GapEffect, string>> = {
  whole: 'One frame',
  discarded: 'To be discarded',
  'two-frames': 'Two frames',
};

const range = ({ t15, t35 }: Silences) => `t1.5 is ${time(t15)} and t3.5 is ${time(t35)} here`;

const replyHints: Readonly<Record<ReplySource, (count: number | undefined) => string>> = {
  known: (count) => `Empty: the expected reply, ${characters(count ?? 0)}.`,
  open: (count) => `Only the device knows. Empty: an example reply, ${characters(count ?? 0)}.`,
  broadcast: () => 'A broadcast is not answered. Empty: no reply.',
  silent: () => 'This request is not answered. Empty: no reply.',
  current: (count) => `Empty: the current reply, ${characters(count ?? 0)}.`,
  typed: () => '0 if no device answers.',
  none: () => 'No reply is known. Type how long it is; 0 if no device answers.',
};

const silentSteps: Readonly<Record<Exclude<ExchangeStepKind, 'request' | 'reply'>, string>> = {
  answer: 'The device answers',
  'silence-and-answer': 'Silence t3.5, in which the device answers',
  turnaround: 'Turnaround: no device answers',
  silence: 'Silence t3.5',
};

/** What the timing of a line says. */
export const timing = {
  title: 'Modbus timing: t1.5, t3.5, frame times, polling. Framewright',
  time,
  otherTime,
  bits,
  line: 'The line',
  mode: 'Transmission mode',
  modes: { rtu: 'RTU', ascii: 'ASCII' } satisfies Record<SerialMode, string>,
  speed: 'Speed, bits a second',
  speedHint: (baud: number, bit: number) =>
    `${baud} = ${formatHex(baud, 4)}; a bit takes ${time(bit)}. 9600 and 19200 are required, 19200 is the default.`,
  format: 'Format',
  formatOption: (name: string, count: number) => `${name}, ${bits(count)}`,
  standings,
  formatHint: (mode: SerialMode, standing: FormatStanding) => formatHints[mode][standing],
  counted: 'Count silences with',
  countedBits: (count: number) => bits(count),

  exchange: 'The exchange',
  request: (mode: SerialMode) => (mode === 'rtu' ? 'Request, bytes' : 'Request, characters'),
  reply: (mode: SerialMode) => (mode === 'rtu' ? 'Reply, bytes' : 'Reply, characters'),
  requestHint: (count: number | undefined) =>
    count === undefined
      ? 'The current frame has no request. Type how long it is.'
      : `Empty: the current request, ${characters(count)}.`,
  replyHint: (source: ReplySource, count: number | undefined) => replyHints[source](count),
  delay: 'The device answers after',
  delayHint:
    'From the end of the request; see its manual, or measure. With 0, as soon as the rules allow: in RTU after t3.5.',
  turnaround: 'Turnaround after a broadcast',
  turnaroundHint: 'So that devices can work on it: usually 100 to 200 ms.',
  timeHint: (microseconds: number, bitCount: number) =>
    `${time(microseconds)} = ${otherTime(microseconds)} = ${bits(bitCount)}.`,

  devices: 'Devices',
  devicesCount: 'Devices asked in turn',
  devicesHint: 'Each by an exchange such as this one. 247 have an address.',
  missing: 'Of these, not answering',
  timeout: 'Response time-out',
  timeoutHint: 'One second to several at 9600 bits a second.',

  silences: 'Character and silences',
  readings: 'Counted with',
  character: 'Character',
  t15: 't1.5',
  t35: 't3.5',
  reading: (count: number) => bits(count),
  fixed: 'Fixed, above 19200',
  inForce: 'in force',
  means: 't1.5 is the longest pause between two characters of one frame, t3.5 the shortest between two frames.',
  asciiSilences:
    'ASCII frames begin with a colon and end with CR LF, so no silence separates them. Up to 1 s may pass between two characters, 4 to 5 s on wide area networks.',
  whyTwo:
    'At 9600 bits a second and 8N1 some sources print 3.645 ms for t3.5, others 4 ms. The first count the 10 bits that a character of 8N1 has, 3.5 × 10 / 9600 = 3.6458 ms; the others the 11 bits of the specification, 3.5 × 11 / 9600 = 4.0104 ms. The specification gives no formula for 10 bits. To be understood by everybody, keep the longer silence between frames, and let no gap inside a frame reach the shorter t1.5.',
  aboveFixed:
    'Above 19200 the specification recommends 750 µs and 1.750 ms at any speed, because shorter times burden the processor. Some devices and manuals go on counting characters, as 1 ms for t3.5 at 38400. Keep the longer pause between frames, and inside a frame less than the shorter t1.5, so that all understand it.',

  thisExchange: 'This exchange',
  of: (functionCode: number, name: string, unit: number | undefined) =>
    `${code(functionCode)} ${name}${unit === undefined ? '' : `, unit ${unit}`}`,
  currentFrame: (asItIs: boolean) =>
    asItIs ? 'The current frame:' : 'The current frame, as this serial line carries it:',
  noFrame: 'There is no current frame.',
  toFrame: 'Correct it',
  steps: 'Steps of the exchange',
  step: 'Step',
  takes: 'Takes',
  share: 'Share',
  percent: (share: number) => `${(100 * share).toFixed(1)} %`,
  steppedRequest: (count: number) => `Request, ${characters(count)}`,
  steppedReply: (count: number) => `Reply, ${characters(count)}`,
  silentSteps,
  total: 'Until the next request',
  most: (perSecond: number) =>
    perSecond >= 1
      ? `At most ${floored(perSecond)} exchanges a second.`
      : `At most ${floored(60 * perSecond)} exchanges a minute.`,
  silent: (share: number) => `The line is silent for ${(100 * share).toFixed(1)} % of the time.`,
  correct: 'Correct what is marked to see the times.',
  tooLate: 'The device answers only after the response time-out: the client gives up first.',

  /** In place of a round that cannot be worked out. */
  noRound: 'A round',
  round: (devices: number) => `${plural(devices, 'device')} in turn`,
  toAll: (microseconds: number) =>
    `No device answers: a broadcast goes to all devices at once, and takes ${time(microseconds)}.`,
  roundTakes: (microseconds: number) => `A round takes ${time(microseconds)}.`,
  eachDevice: (perSecond: number) =>
    perSecond >= 1
      ? `Each device is asked ${floored(perSecond)} times a second.`
      : `Each device is asked every ${time(SECOND / perSecond)}.`,
  lostToMissing: (microseconds: number, count: number) =>
    `Of this, ${time(microseconds)} is spent on ${plural(count, 'device')} that ${count === 1 ? 'does' : 'do'} not answer.`,

  gapTitle: 'A gap inside a frame',
  gap: 'Gap between two characters',
  effects,
  rtuGap: (effect: GapEffect, silences: Silences): string =>
    ({
      whole: `The characters before and after it belong together: ${range(silences)}.`,
      discarded: `Longer than t1.5 and shorter than t3.5: the receiver must treat the frame as incomplete; ${range(silences)}. Many receivers accept it nevertheless.`,
      'two-frames': `The frame ends before the gap, and another begins after it: the CRC of neither holds; ${range(silences)}.`,
    })[effect],
  asciiGap: (effect: GapEffect): string =>
    effect === 'whole'
      ? 'Up to 1 s may pass between two characters.'
      : 'More than 1 s is an error, unless both sides are set to wait longer; 4 to 5 s are usual on wide area networks.',
  otherReading: (count: number, effect: GapEffect) =>
    `To a receiver that counts, with ${bits(count)} a character: ${effects[effect].toLowerCase()}.`,

  speeds: 'Usual speeds',
  speedsIntroduction:
    'In microseconds. Above 19200 the silences are fixed; what counting would give is in brackets, and has its own columns when copied.',
  formatsOfBits: (count: number, names: readonly string[]) => `${bits(count)}: ${names.join(', ')}`,
  speedColumn: 'Speed',
  counted15: 't1.5 counted',
  counted35: 't3.5 counted',
  columnOf: (what: string, count: number) => `${what}, ${bits(count)}`,
  inMicroseconds: (column: string) => `${column}, µs`,
  /** Always with three decimals, so that the points line up. */
  microseconds: (value: number) => value.toFixed(3),
  copy: 'Copy the table',
  copyAs: 'Copy as',
  formats: { tsv: 'Spreadsheet', markdown: 'Markdown', csv: 'CSV' } satisfies Record<TableFormat, string>,
  copied: 'Copied',
  copyFailed: 'The browser refused. Select the table and copy it.',
};

/** Never more than there are, so that “at most” holds. */
const floored = (value: number): string => String(Math.floor(value * 10) / 10);
