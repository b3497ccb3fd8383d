import type { Refusal, SequenceEnd, StepOutcome } from '../../bus/index.ts';
import { dictionary } from '../../modbus/index.ts';
import type { SequenceFileFault, ShapeFault, StepFault, StepKind } from '../../sequences/index.ts';
import { plural } from './common.ts';
import { outcomeName } from './sent.ts';

const kinds: Readonly<Record<StepKind, string>> = {
  send: 'Send',
  wait: 'Wait',
  until: 'Wait until',
  repeat: 'Repeat',
};

const fields: Readonly<Record<string, string>> = dictionary({
  bytes: 'Frame (bytes, or a link to a frame)',
  onFailure: 'If it fails',
  duration: 'Time (ms)',
  unit: 'Unit',
  table: 'Table',
  address: 'Address (from 0)',
  type: 'Type',
  order: 'Order of the bytes',
  bit: 'Only bit (empty: all)',
  relation: 'is',
  value: 'Value',
  interval: 'Read every (ms)',
  timeout: 'At most (ms)',
  times: 'Times',
  name: 'Name',
});

/** What the values of a choice are called, where they are not called as they are written. */
const options: Readonly<Record<string, Readonly<Record<string, string>>>> = dictionary({
  onFailure: { stop: 'stop', 'go-on': 'go on' },
  table: {
    coil: 'coils',
    'discrete-input': 'discrete inputs',
    'input-register': 'input registers',
    'holding-register': 'holding registers',
  },
});

const faults: { readonly [C in StepFault['code']]: (fault: Extract<StepFault, { code: C }>) => string } = {
  'field-missing': () => 'A value is needed here.',
  'not-a-number': ({ got }) => `“${got}” is not a number for this: decimal, or hexadecimal as 0x2A9.`,
  'out-of-range': ({ least, most }) => `A number from ${least} to ${most}.`,
  unknown: ({ got, known }) => `“${got}” is not one of ${known.join(', ')}.`,
  'not-bytes': () =>
    'These are not bytes: pairs of hexadecimal digits such as 06 06 02 AB, or a link to a whole frame.',
  'too-long': ({ got, most }) => `${got} bytes are more than any frame has: ${most} at most.`,
  'over-the-end': ({ last }) => `The value would end at address ${last}; the last one is 65535.`,
  'no-steps': () => 'It has no steps yet.',
};

const requests = (count: number) => `after ${plural(count, 'request')}`;

const outcomes: { readonly [K in StepOutcome['kind']]: (outcome: Extract<StepOutcome, { kind: K }>) => string } = {
  sent: ({ duration, ...sent }) =>
    duration === undefined ? outcomeName(sent) : `${outcomeName(sent)}, ${Math.round(duration)} ms`,
  waited: () => 'waited',
  held: ({ value, requests: count }) => `came true: ${value}, ${requests(count)}`,
  'timed-out': ({ value, requests: count }) =>
    value === undefined
      ? `not in time: nothing could be read, ${requests(count)}`
      : `not in time: ${value} at last, ${requests(count)}`,
  repeated: ({ times }) => `done ${plural(times, 'time')}`,
  failed: () => 'ended by a step that failed',
  stopped: () => 'stopped here',
  lost: () => 'the line is lost',
};

const fileFaults: {
  readonly [C in SequenceFileFault['code']]: (fault: Extract<SequenceFileFault, { code: C }>) => string;
} = {
  'not-json': ({ detail }) => `it is not JSON (${detail})`,
  'too-deep': ({ most }) => `it has lists or objects inside each other, more than ${most} deep`,
  'not-sequences': () => 'it is not a file of sequences',
  'newer-version': ({ version }) => `it was written by a newer version of this page (format ${version})`,
};

type PlaceOf = (place: { readonly list: 'steps' | 'finally'; readonly at: readonly number[] }) => string;

const stepName: PlaceOf = ({ list, at }) => {
  const number = at.map((index) => index + 1).join('.');
  return list === 'steps' ? `Step ${number}` : `Finally ${number}`;
};

const shapeFaults: { readonly [C in ShapeFault['code']]: (fault: Extract<ShapeFault, { code: C }>) => string } = {
  'no-name': () => 'it has no name',
  'not-a-transport': ({ got }) => `its transport is “${got}”; it must be rtu or ascii`,
  'not-a-list': ({ place }) => `${place.at.length === 0 ? place.list : stepName(place)} has no list of steps`,
  'not-a-step': ({ place, got }) => `${stepName(place)} has an unknown kind (${got || 'none'})`,
  'field-unknown': ({ place, field }) => `${stepName(place)} has “${field}”, which means nothing there`,
  'too-deep': ({ place, most }) => `${stepName(place)}: repetitions go ${most} deep at most`,
  'too-many': ({ got, most }) => `it has ${got} steps; the maximum is ${most}`,
};

/** What is said when both lists have ended. */
const ends: Readonly<Record<SequenceEnd, string>> = {
  done: 'Done.',
  failed: 'Ended by a step that failed.',
  stopped: 'Stopped.',
  lost: 'The line was lost.',
};

const lastEnds: Readonly<Record<SequenceEnd, string>> = {
  done: '“Finally” was carried out.',
  failed: 'Not all of “Finally” was carried out: look at its steps, and at the machine.',
  stopped: '“Finally” was stopped too: look at the machine.',
  lost: '“Finally” could not be sent, because there is no line any more: look at the machine.',
};

/** The sentences of the panel of sequences. */
export const sequence = {
  choose: 'Sequence',
  builtIn: 'Built in',
  custom: 'Kept in this browser',
  intro:
    'Frames, waits and conditions, one after another. “Finally” is carried out at the end, also when a step fails or the sequence is stopped, and a step that fails in it does not stop the rest. A page that is closed, a computer that sleeps or an adapter that is pulled out can prevent it: this is not an emergency stop.',
  create: 'New',
  newName: 'New sequence',
  remove: 'Delete',
  about: 'What it is for',
  transport: 'Frames are',
  transports: { rtu: 'RTU', ascii: 'ASCII' },
  lists: { steps: 'Steps', finally: 'Finally' },
  noFinally: 'Nothing is sent at the end.',
  noSteps: 'No steps yet.',
  kinds,
  fields,
  options,
  stepName,
  add: {
    frame: 'Add the current frame',
    send: 'Add a frame',
    wait: 'Add a wait',
    until: 'Add a condition',
    repeat: 'Add a repetition',
  },
  addTo: { steps: 'Add to the steps', finally: 'Add to Finally' },
  addIn: (step: string) => `Add into ${step}`,
  actions: { up: 'Up', down: 'Down', duplicate: 'Duplicate', remove: 'Remove', open: 'Open' },
  action: {
    up: (step: string) => `Move up: ${step}`,
    down: (step: string) => `Move down: ${step}`,
    duplicate: (step: string) => `Duplicate: ${step}`,
    remove: (step: string) => `Remove: ${step}`,
    open: (step: string) => `Open in the Frame view: ${step}`,
  },
  withNames: (parts: readonly (readonly [string, string])[]) =>
    parts.map(([name, text]) => `${name} ${text}`).join(', '),
  undo: 'Undo',
  program: 'Program',
  undone: 'Undone.',
  nothingToUndo: 'Nothing has been changed yet.',
  locked: 'Stop the sequence to change this.',
  /** Why a step cannot be moved. */
  useless: { up: 'This is the first step.', down: 'This is the last step.' },
  noCurrentFrame: (transport: string) =>
    `The Frame view has no whole request in ${transport.toUpperCase()}, as this sequence sends them.`,
  noName: 'A name is needed here.',
  fault: (fault: StepFault): string => (faults[fault.code] as (fault: StepFault) => string)(fault),
  faultsLeft: (count: number) => `Cannot start: ${plural(count, 'mistake')} to correct.`,
  notConnected: 'Connect first, to an adapter or to the virtual bus.',
  start: 'Start',
  stop: 'Stop, then Finally (Esc)',
  stopLast: 'Stop Finally too',
  asked: 'Waiting for your answer…',
  running: 'Running…',
  runningLast: 'Carrying out “Finally”…',
  ended: (how: SequenceEnd, last: SequenceEnd | undefined) =>
    last === undefined ? ends[how] : `${ends[how]} ${lastEnds[last]}`,
  notBegun: {
    'read-only': 'Not started: it may change something in a device, and “Read only” is on.',
    serving: 'Not started: the virtual devices answer on this port now.',
    listening: 'Not started: this page is listening, and sends nothing meanwhile. Stop listening first.',
    scanning: 'Not started: a scan tries other speeds and formats. Stop it first, or wait for its end.',
    busy: 'Not started: something else is being sent. Stop it first.',
    declined: 'Not started.',
  } satisfies Record<Refusal | 'declined', string>,
  atStep: (rounds: readonly number[]) =>
    rounds.length === 0 ? 'running' : `running, round ${rounds.map((round) => round + 1).join('.')}`,
  outcome: (outcome: StepOutcome): string => (outcomes[outcome.kind] as (outcome: StepOutcome) => string)(outcome),
  copied: (name: string) => `The built-in sequence stays as it is: the change is in “${name}”.`,
  removed: (name: string) => `“${name}” was deleted.`,
  tooBig: 'Not changed: a sequence has 500 steps at most, and repetitions go 4 deep.',
  export: 'Save as a file',
  import: 'Open a file…',
  fileName: 'sequences.json',
  imported: (name: string) => `“${name}” was added.`,
  renamed: (wanted: string, got: string) => `“${wanted}” was there already: the one from the file is now “${got}”.`,
  already: (name: string) => `“${name}” is here already and is identical.`,
  emptyFile: 'There is no sequence in this file.',
  unreadable: (name: string, fault: SequenceFileFault) =>
    `${name} was not opened: ${(fileFaults[fault.code] as (fault: SequenceFileFault) => string)(fault)}.`,
  fileUnread: (name: string) => `${name} could not be read, or is too big for a file of sequences.`,
  notTaken: (number: number, name: string, fault: ShapeFault) =>
    `Sequence ${number}${name === '' ? '' : ` (“${name}”)`} was not added: ${(shapeFaults[fault.code] as (fault: ShapeFault) => string)(fault)}.`,
  badStored: (count: number) =>
    `${count === 1 ? 'One of your sequences cannot be read, and is not shown. It stays' : `${count} of your sequences cannot be read, and are not shown. They stay`} in the storage unchanged.`,
  badEntry: (number: number, name: string, fault: ShapeFault) =>
    `Sequence ${number}${name === '' ? '' : ` (“${name}”)`}: ${(shapeFaults[fault.code] as (fault: ShapeFault) => string)(fault)}.`,
  notKept: {
    refused: 'This browser does not let the page keep anything: changes last until the page is closed.',
    full: 'The browser’s storage is full: the latest changes last until the page is closed. Save them as a file.',
    unreadable:
      'What this browser keeps as sequences cannot be read, perhaps because a newer version of this page wrote it. It is left alone, and changes last until the page is closed.',
  },
};
