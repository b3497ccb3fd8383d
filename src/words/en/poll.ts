import { exactValue, inUnits, isBitTable, isScaled, namesOf, type Register, saysNothing } from '../../devices/index.ts';
import { isNumberType, numberTypes, type Value } from '../../modbus/index.ts';
import { formatHex, formatValueHex } from '../../notation/index.ts';
import type { FailureCount, PollWindow, SourceRefusal } from '../../workbench/index.ts';
import { all, code, fields, grouped, page, plural } from './common.ts';
import { numberText, valueText } from './register-numbers.ts';
import { failureName } from './sent.ts';

const capital = (text: string) => text.charAt(0).toUpperCase() + text.slice(1);

/** A mean, or another number that no register held: six digits say enough. */
const roughly = (value: number) => String(Number(value.toPrecision(6))).replace(/^-/, '−');

/** What a value says, in the unit of its line if it has one; `power` is what its scale register holds. */
function reading(raw: Value, register: Register, power?: number): string {
  if (saysNothing(raw, register)) return 'not implemented';
  if (typeof raw === 'string') return `“${raw}”`;
  const names = namesOf(raw, isBitTable(register.table) ? { ...register, type: 'u16' } : register);
  const also = names.length > 0 ? ` (${names.join(', ')})` : '';
  if (isBitTable(register.table)) return `${raw ? 'ON' : 'off'}${also}`;
  if (isNumberType(register.type) && numberTypes[register.type].kind === 'bits')
    return `${formatValueHex(raw, register.type)}${also}`;
  if (register.scaleRegister && power === undefined) return `raw ${raw}, scale unknown${also}`;
  const exactly = isScaled(register) ? exactValue(raw, register, power) : undefined;
  return `${valueText(inUnits(raw, register, power), register, exactly)}${unitText(register)}${also}`;
}

const inUnit = (value: number | bigint, register: Register) => `${numberText(value, register)}${unitText(register)}`;

const unitText = ({ unit }: Register) => unit && ` ${unit}`;

function duration(milliseconds: number): string {
  const seconds = milliseconds / 1000;
  // Tenths would change each time a line is drawn, and say nothing.
  if (seconds < 1) return '< 1 s';
  if (seconds < 120) return `${Math.floor(seconds)} s`;
  if (seconds < 7200) return `${Math.round(seconds / 60)} min`;
  return `${(seconds / 3600).toFixed(1)} h`;
}

/** What polling says. */
export const poll = {
  source: 'What is read',
  frame: 'The current frame',
  device: 'Registers of a device',
  refusals: {
    'no-frame': 'The form has no whole frame: see the Frame view.',
    'not-request': 'The current frame is a reply. Choose Request in the Frame view.',
    'not-serial': 'The current frame is not for a serial line: choose RTU or ASCII in the Frame view.',
    'reads-nothing': `The current frame reads no registers or bits: ${all([1, 2, 3, 4, 0x17].map(code))} do.`,
    broadcast: 'Unit 0 is every device, and no device answers: choose a single unit.',
    'nothing-chosen': 'Choose what to read.',
    'too-many': 'These are more than 2000 values: choose fewer.',
  } satisfies Record<SourceRefusal, string>,
  frameTitle: page.summary,
  deviceTitle: (name: string, unit: number) => `${name}, unit ${unit}`,
  profile: 'Device profile',
  noProfile: 'Choose one…',
  unit: 'Unit of the device',
  search: 'Find registers to poll',
  lines: 'Registers',
  chosen: (count: number) => `${count} chosen`,
  more: (count: number) => `${plural(count, 'register')} more: narrow the search.`,
  none: 'No register matches.',
  chooseNone: 'Choose none',
  how: 'How they are read',
  registers: 'Maximum registers',
  bits: 'Maximum bits',
  gap: 'Largest gap',
  gapHint:
    'The most that the device allows in one request. Registers near each other are read in one, with gaps of up to so many between them that were not asked for: 0 where the device refuses those.',
  wrong: (least: number, most: number) => `A whole number from ${least} to ${most}, decimal or hexadecimal (0x…).`,
  plan: (values: number, requests: number) => `${plural(values, 'value')} in ${plural(requests, 'request')} a round.`,
  unreadable: (names: readonly string[]) =>
    `Longer than a request may be, and left out: ${names.slice(0, 5).join(', ')}${names.length > 5 ? ' …' : ''}.`,
  interval: 'Interval (ms)',
  intervalHint: 'From the beginning of a round to the next; 0 is as fast as the line goes.',
  start: 'Start',
  stop: 'Stop',
  goOn: 'Go on',
  notConnected: 'Connect first, to an adapter or to the virtual bus.',
  running: 'Polling.',
  locked: 'Stop the poll to change this.',
  noValues: 'Nothing that is chosen can be read in one request.',
  nothingRead: 'Nothing has been read yet.',
  ended: {
    stopped: 'Stopped.',
    lost: 'The adapter was lost, and the poll has ended. What was read is kept. Plug the adapter in, connect again, then go on.',
    disconnected: 'The connection was closed, and the poll has ended. Connect again, then go on.',
    declined: 'Not begun.',
  },
  values: (title: string) => `Values: ${title}`,
  progress: (rounds: number, requests: number, failed: number, doubtful: number, reasons: readonly FailureCount[]) =>
    [
      `${plural(rounds, 'round')}.`,
      failed === 0
        ? 'Every request was answered.'
        : `${grouped(failed)} of ${grouped(requests)} requests failed (${percent(failed, requests)}): ${reasonList(reasons)}.`,
      ...(doubtful === 0
        ? []
        : [
            `${plural(doubtful, 'reply', 'replies')} came that may be the answer to another request (${percent(doubtful, requests)}); ${doubtful === 1 ? 'its values are' : 'their values are'} not counted.`,
          ]),
    ].join(' '),
  slow: (took: number, timeout: number) =>
    `The device answers after ${Math.round(took)} ms, and the time-out is ${timeout} ms: raise it under Transactions.`,
  keeps: (most: number) =>
    `The chart and the file have the last ${grouped(most)} rounds; minimum, maximum, mean and errors are of all.`,
  columns: {
    name: 'Value',
    place: 'Address',
    last: 'Last',
    hex: 'Hex',
    least: 'Minimum',
    most: 'Maximum',
    mean: 'Mean',
    errors: 'Errors',
    age: 'Age',
    time: 'Time',
  },
  find: 'Find a value',
  moreValues: (count: number) => `${plural(count, 'value')} more: narrow the search.`,
  draw: (name: string) => `Draw ${name}`,
  drawMost: (most: number) => `At most ${most} values are drawn at once.`,
  name: (register: Register) => `${capital(fields.tables[register.table].one)} ${register.address}`,
  place: (printed: string, address: number) =>
    printed === String(address) ? formatHex(address, 4) : `${printed}, ${formatHex(address, 4)}`,
  reading,
  inUnit,
  mean: (mean: number, { unit, table }: Register) => `${roughly(mean)}${unit && !isBitTable(table) ? ` ${unit}` : ''}`,
  errors: (errors: number, tries: number) => (errors === 0 ? '0' : `${grouped(errors)} (${percent(errors, tries)})`),
  age: duration,
  missing: '–',
  /** Why the last reading of a value failed: `exception 02, Illegal data address`. */
  failed: failureName,
  doubtful: 'doubtful',
  chart: 'Chart',
  chartIs: (names: readonly string[], span: number) =>
    `Chart of ${names.join(', ')} over ${duration(span)}. The table behind it has the last rounds.`,
  noChart: 'Tick the values to draw.',
  window: 'Shows',
  windows: {
    60: 'the last minute',
    600: 'the last 10 minutes',
    3600: 'the last hour',
    0: 'all that is kept',
  } satisfies Record<PollWindow, string>,
  asTable: 'The last rounds as a table',
  pointHint: 'Point at the chart to read the values there.',
  save: 'Save as CSV',
  timeColumn: 'Time (UTC)',
};

/** `exception 02, Illegal data address`; where there are several, each with how often it came. */
const reasonList = (reasons: readonly FailureCount[]): string =>
  reasons
    .map(({ failure, count }) => `${failureName(failure)}${reasons.length > 1 ? ` × ${grouped(count)}` : ''}`)
    .join('; ');

const percent = (part: number, all: number) => {
  const value = (100 * part) / all;
  return `${value > 0 && value < 0.1 ? '< 0.1' : value.toFixed(value < 10 ? 1 : 0)} %`;
};
