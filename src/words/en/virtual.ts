import type { CounterName, Fault, HeardBy, ModelName, SilenceReason } from '../../bus/index.ts';
import type { EntityTable } from '../../devices/index.ts';
import { byteHex, plural } from './common.ts';

const models: Readonly<Record<ModelName, string>> = {
  's7-200': 'Siemens S7-200',
  'weg-drive': 'WEG drive',
  'i-8xx7': 'ICP DAS I-8xx7',
  'modicon-17': 'Modicon 984, with all functions',
  'modicon-33': 'Modicon 984',
  plain: 'Plain device, 1000 addresses of each kind',
};

const silences: Readonly<Record<SilenceReason, string>> = {
  'other-unit': 'not its unit, so it says nothing',
  broadcast: 'a broadcast: it obeys if it knows the function, and says nothing',
  'listen-only': 'its unit, but it is in listen only mode and says nothing',
  'broken-frame': 'not a whole frame, or the checksum is wrong, so it says nothing',
  'no-reply': 'its unit, and the function has no reply',
  'other-settings': 'its line has other settings: it hears only noise',
};

const faults: Readonly<Record<Fault['kind'], string>> = {
  silence: 'Silence: no reply',
  late: 'Late reply',
  exception: 'Exception instead',
  'bad-crc': 'Wrong checksum',
  'cut-off': 'Reply cut off',
  echo: 'Echo of the request first',
  noise: 'Noise before the reply',
  merged: 'The previous reply comes again',
  'byte-loss': 'One byte lost',
};

const counters: Readonly<Record<CounterName, string>> = {
  busMessages: 'Messages on the bus',
  busErrors: 'Broken frames',
  exceptions: 'Exceptions answered',
  serverMessages: 'Messages for it',
  noResponses: 'Not answered',
  naks: 'NAK',
  busies: 'Busy',
  overruns: 'Overruns',
};

const heardBy = ({ does, why, exceptionCode, reply, fault }: HeardBy): string => {
  if (does === 'nothing') return why === undefined ? 'says nothing' : silences[why];
  const spoiled = fault === undefined ? '' : ` Fault asked for: ${faults[fault]}.`;
  if (reply?.length === 0) return `its unit; it would answer.${spoiled}`;
  const answer =
    exceptionCode === undefined ? 'its unit: it answers' : `its unit: it refuses, exception ${exceptionCode}`;
  return fault === undefined ? answer : `${answer}.${spoiled}`;
};

/** The sentences of the virtual devices. */
export const virtual = {
  intro:
    'Devices inside this page. They answer on the virtual bus, or on a real port to a PLC that is the master. What you change is kept in this browser.',
  models,
  lost: (count: number) =>
    `${count === 1 ? 'One device that this browser kept cannot be read, and is' : `${count} devices that this browser kept cannot be read, and are`} left out.`,
  devices: {
    heading: 'Devices on the line',
    on: (unit: number) => `Unit ${unit} has power`,
    onHead: 'On',
    unitHead: 'Unit',
    unit: (name: string) => `Unit of ${name}`,
    unitWrong: 'A unit is 1 to 247, decimal or hexadecimal (0x…).',
    nameHead: 'Device',
    twice: (units: readonly number[]) =>
      `Unit ${units.join(', ')} is there more than once: both answer, and their replies overlap.`,
    remove: (name: string, unit: number) => `Remove ${name}, unit ${unit}`,
    removeShort: 'Remove',
    undo: 'Undo',
    add: 'Add',
    addKind: 'Add a device',
    restart: 'Put back the first devices',
    none: 'There is no device on the line, so nothing answers.',
  },
  cells: {
    heading: (name: string, unit: number) => `Contents of unit ${unit}, ${name}`,
    notConnected: 'Connect to the virtual bus, or answer on a port, to see and change what the devices hold.',
    table: 'Table',
    from: 'From address',
    fromWrong: 'An address is 0 to 65535, decimal or hexadecimal (0x…).',
    jump: 'By name',
    jumpNone: 'choose…',
    before: 'Previous',
    next: 'Next',
    atFirst: 'These are the first addresses.',
    atLast: 'These are the last addresses.',
    address: 'Address',
    value: 'Value',
    hex: 'Hex',
    name: 'Name',
    valueOf: (address: number) => `Value at ${address}`,
    bitOf: (address: number) => `Bit at ${address} is on`,
    valueWrong: '−32768 to 65535, or 0x0000 to 0xFFFF.',
    absent: 'The device has none of these addresses.',
    counters: 'Counters',
    counterNames: counters,
    events: 'Carried out',
    listenOnly: 'It is in listen only mode: it hears, and answers nothing until it is restarted (08, sub-function 01).',
  },
  tables: {
    coil: 'Coils',
    'discrete-input': 'Discrete inputs',
    'input-register': 'Input registers',
    'holding-register': 'Holding registers',
  } satisfies Readonly<Record<EntityTable, string>>,
  faults: {
    heading: 'Faults on request',
    kind: 'What goes wrong',
    kinds: faults,
    who: 'With replies of',
    anyone: 'every device',
    unit: (unit: number) => `unit ${unit}`,
    often: 'How often',
    once: 'once',
    always: 'always',
    add: 'Ask for this fault',
    remove: 'Remove',
    removeThis: (rule: string) => `Remove: ${rule}`,
    none: 'Nothing goes wrong.',
    parameters: {
      late: 'Late by (ms)',
      exception: 'Exception code',
      'cut-off': 'Bytes that come',
      noise: 'Bytes of noise',
    },
    parameterWrong: (least: number, most: number) => `A whole number from ${least} to ${most}.`,
    rule: (fault: Fault, unit: number | undefined, times: number | undefined) => {
      const size =
        fault.kind === 'late'
          ? ` (${fault.by} ms)`
          : fault.kind === 'exception'
            ? ` (${byteHex(fault.exceptionCode)})`
            : fault.kind === 'cut-off'
              ? ` (${plural(fault.keep, 'byte')} come)`
              : fault.kind === 'noise'
                ? ` (${plural(fault.bytes, 'byte')})`
                : '';
      const often = times === undefined ? 'always' : times === 1 ? 'once' : `${times} times`;
      return `${faults[fault.kind]}${size}, ${unit === undefined ? 'every device' : `unit ${unit}`}, ${often}`;
    },
  },
  heard: {
    heading: 'Who hears what',
    intro: 'Every device hears every frame. Only the one whose unit is asked answers.',
    none: 'Nothing has been on the line since this was opened.',
    clear: 'Clear',
    by: heardBy,
    device: (name: string, unit: number) => `Unit ${unit} (${name})`,
    nobody: 'No device hears it.',
  },
  serve: {
    heading: 'Answer on the real port',
    start: 'Answer what arrives on the adapter',
    stop: 'Stop answering',
    mode: 'in mode',
    notPort: 'Connect to an adapter first. A PLC or another program at its other end is then the master.',
    on: 'The devices answer on the adapter. Meanwhile the page sends nothing of its own; the log shows each request, and after each reply how long it took.',
    latency:
      'Answers take longer than those of a real device: a USB adapter hands over what it hears up to 16 ms late (FTDI; 1 ms if its latency timer is set so), the end of a frame is known only by the silence behind it, and a busy computer adds some more. Give the master a time-out of 100 ms or more.',
  },
};
