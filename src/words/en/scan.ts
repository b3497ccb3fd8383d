import type { LinkSettings, Refusal, ScanAnswer } from '../../bus/index.ts';
import { describeFunction, serialFormatName } from '../../modbus/index.ts';
import { bus } from './bus.ts';
import { byteHex, code, plural, word } from './common.ts';
import { exceptionName, milliseconds } from './sent.ts';

/** A time as people say it: `26 s`, `4 min`. */
export function duration(milliseconds: number): string {
  const seconds = milliseconds / 1000;
  if (seconds < 1) return 'less than a second';
  if (seconds < 100) return `${Math.round(seconds)} s`;
  if (seconds < 6000) return `${Math.round(seconds / 60)} min`;
  return `${(seconds / 3600).toFixed(1)} h`;
}

const startsLarge = (text: string) => `${text[0]?.toUpperCase()}${text.slice(1)}`;

function answer({ outcome, exceptionCode, late }: ScanAnswer): string {
  const said = {
    reply: 'Reply',
    exception: startsLarge(exceptionName(exceptionCode ?? 0)),
    broken: 'Broken reply',
    silent: 'No reply',
  }[outcome];
  return late ? `${said} (late: the time-out is short)` : said;
}

/** What scanning says. */
export const scan = {
  target: 'What to look for',
  targets: { units: 'Units on the line', functions: 'Functions of a unit', addresses: 'Addresses of a unit' },
  intro: {
    units: 'Each unit is asked for one holding register. Any reply, an exception too, proves that it is there.',
    functions:
      'Each function that changes nothing is asked for once. Exception 01 means that the unit does not have it, any other reply that it has.',
    addresses:
      'Only reads are sent. A block that is refused is halved until its parts answer. What is silent is not asked again.',
  },
  first: 'First unit',
  last: 'Last unit',
  unit: 'Unit to scan',
  transport: 'Mode',
  transports: { rtu: 'RTU', ascii: 'ASCII' },
  timeout: 'Wait for a reply (ms)',
  timeoutHint: 'Most devices answer within 50 ms; adapters and gateways add to that.',
  table: 'Table to scan',
  tables: {
    coil: 'Coils (01)',
    'discrete-input': 'Discrete inputs (02)',
    'holding-register': 'Holding registers (03)',
    'input-register': 'Input registers (04)',
  },
  from: 'First address',
  to: 'Last address',
  addressHint: 'Addresses as they are sent, counted from 0.',
  most: 'Maximum addresses per request',
  least: 'Smallest block',
  leastHint: '1 finds every address; a bigger block needs fewer requests where much is missing.',
  wrong: (least: number, most: number) => `A whole number from ${least} to ${most}, decimal or hexadecimal (0x…).`,
  backwards: 'The first is after the last.',
  speeds: 'Speeds to try',
  formats: 'Formats to try',
  otherLines: 'Other speeds and formats',
  lines:
    'If none is chosen, the line stays as it is. Otherwise the port is opened again with each, and at the end with the previous settings. Meanwhile nothing else can be sent.',
  start: 'Start the scan',
  stop: 'Stop the scan',
  notConnected: 'Connect first, to an adapter or to the virtual bus.',
  estimate: (requests: number, time: number, what: 'units' | 'functions' | 'addresses') =>
    what === 'addresses'
      ? `At least ${plural(requests, 'request')}, ${duration(time)}; more where addresses are missing.`
      : `${plural(requests, 'request')}, ${duration(time)} at most.`,
  progress: (done: number, total: number, left: number, what: 'units' | 'functions' | 'addresses') =>
    `${done} of ${plural(total, what === 'addresses' ? 'address' : 'request', what === 'addresses' ? 'addresses' : 'requests')}${
      done < total ? `; ${duration(left)} left` : ''
    }.`,
  progressLabel: 'Progress of the scan',
  running: 'Scanning.',
  locked: 'Stop the scan to change this.',
  ended: {
    done: 'The scan is complete.',
    stopped: 'The scan was stopped.',
    lost: 'The adapter was lost, and the scan has ended. What was found is kept.',
    disconnected: 'The connection was closed, and the scan has ended. What was found is kept.',
    declined: 'Not begun.',
  },
  refused: (why: Refusal) => bus.guard.refusals[why],
  found: {
    units: (count: number) => `${plural(count, 'unit')} found`,
    functions: (count: number) => `${plural(count, 'function')} found`,
    addresses: (count: number) => `${plural(count, 'address', 'addresses')} found`,
  },
  noUnits:
    'No unit has answered. Check wires A and B, the power and termination, and try other speeds and formats, or a longer time-out.',
  results: 'What was found',
  columns: {
    unit: 'Unit',
    hex: 'Hex',
    line: 'Speed and format',
    answer: 'Answer',
    time: 'Time',
    code: 'Function',
    name: 'Name',
    supported: 'Supported',
    addresses: 'Addresses',
    count: 'Count',
    open: 'Frame',
  },
  answer,
  /** Of a unit that is looked for: any answer proves that it is there. */
  unitAnswer: (found: ScanAnswer) => `${answer(found)}${found.outcome === 'exception' ? ' (present)' : ''}`,
  notOpened: 'The port does not open with this',
  line: (settings: LinkSettings) => `${settings.baud} baud, ${serialFormatName(settings)}`,
  time: (answer: ScanAnswer) => (answer.duration === undefined ? '' : milliseconds(answer.duration)),
  functionName: (code: number) => describeFunction(code, 'request').name,
  functionCode: code,
  hexUnit: byteHex,
  hexRange: (first: number, last: number) => (first === last ? word(first) : `${word(first)}–${word(last)}`),
  range: (first: number, last: number) => (first === last ? String(first) : `${first}–${last}`),
  supported: { yes: 'yes', no: 'no', unsure: 'not sure', silent: 'no answer' },
  open: 'Open',
  openOf: (what: string) => `Open the answer of ${what} in the Frame view`,
  more: (count: number) => `${plural(count, 'line')} more: copy the table to see all.`,
  copyCsv: 'Copy as CSV',
  copyMarkdown: 'Copy as Markdown',
  copied: 'Copied.',
  copyFailed: 'The browser did not let this page copy.',
};
