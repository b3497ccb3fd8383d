import type { CrcWay, GuideFault, ProgramPart, TargetGroup, TargetProof } from '../../codegen/index.ts';
import { dictionary } from '../../modbus/index.ts';
import type { NoProgram } from '../../workbench/index.ts';
import { page, plural } from './common.ts';

const parts: Readonly<Record<ProgramPart, string>> = {
  bytes: 'The bytes',
  build: 'What builds the frame',
  check: 'What checks the reply',
  exchange: 'The whole exchange',
};

const groups: Readonly<Record<TargetGroup, string>> = {
  plc: 'PLC',
  c: 'C and microcontrollers',
  pc: 'PC languages',
  library: 'Libraries',
  command: 'Command lines',
};

const crcWays: Readonly<Record<CrcWay, string>> = {
  bitwise: 'bit by bit',
  table: 'with one table of 256 words',
  'two-tables': 'with two tables of 256 bytes',
};

const none: Readonly<Record<NoProgram, string>> = {
  'no-frame': 'Correct the form to see the program of the frame.',
  'no-request': 'A program sends a request. Say which request this reply answers to see its program.',
  broken: 'The frame is not whole: there is no program of it. Repair it first.',
  mixed: 'One program speaks RTU, ASCII or TCP. Choose frames of one transport.',
  'no-requests': 'One of these frames is not a whole request, and does not say which it answers. Choose the others.',
  'nothing-sent': 'Correct the sequence first: a step has a fault, or no step sends anything.',
};

const whyConstant = dictionary({
  reply: 'it is a reply',
  raw: 'nothing is known of its function',
  broken: 'it is not whole',
  forced: 'some of its values are forced',
  'too-many-numbers': 'a part of it is too long for parameters',
});

const offered = dictionary<string>({
  ...parts,
  pdu: 'A bare PDU',
  sequence: 'A sequence',
  function: 'This function',
});

const transports = dictionary<string>(page.transports);

/** What a note of a program has beside its code. */
type NoteData = Readonly<Record<string, unknown>>;
type NoteWords = (data: NoteData, target: string) => string;

function notOffered({ what, baud, instead, request }: NoteData, target: string): string {
  if (what === 'baud') return `${baud} baud cannot be set by this program: it sets ${instead}.`;
  if (what === 'function')
    return `${target} has no call for the function of “${request}”: its bytes are written instead.`;
  if (what === 'sequence') return `${target} cannot carry out a sequence here: its frames are written one by one.`;
  const name = transports[String(what)];
  if (name !== undefined) return `${target} is not written for ${name}: the bytes are written alone.`;
  return `${offered[String(what)] ?? String(what)} is not offered for ${target} by itself: what comes next to it is written.`;
}

const notes: ReadonlyMap<string, NoteWords> = new Map<string, NoteWords>([
  ['not-offered', notOffered],
  ['name-changed', ({ from, to }) => `“${from}” cannot be a name here: it is called ${to}.`],
  [
    'constant',
    ({ request, why }) =>
      `The bytes of “${request}” are constants, because ${whyConstant[String(why)] ?? String(why)}.`,
  ],
  ['raw-only', ({ request, name }) => `“${name}” of “${request}” is given as it is sent, not in its unit.`],
]);

const listingFaults: Readonly<Record<GuideFault, string>> = {
  comment: 'a comment that begins with // came with the third edition; (* … *) is taken everywhere.',
  'shift-operator': 'Structured Text has no operator >>. SHR(value, 8) shifts.',
  'bits-of-number': 'AND, XOR and SHR take bits (BYTE, WORD), not numbers (UINT).',
  'mixed-types': 'a BYTE does not become a WORD by itself. BYTE_TO_WORD makes it one.',
  'no-edge': 'the frame is built in every cycle while Execute is TRUE, not on its rising edge.',
  'never-set': 'nothing ever sets Error.',
  'never-reset': 'once Done is TRUE, it stays so.',
};

const runOn = (frames: number) =>
  `and run on ${frames} requests and their replies in our tests: it builds, refuses and reads what this page does.`;

/** Programs for the frame, for frames and for sequences. What stands in a program is English in every language. */
export const program = {
  target: 'Program for',
  part: 'Part',
  parts,
  groups,
  otherGroup: 'Others',
  none,
  unknownTarget: (name: string) => `The link asks for “${name}”, which this page cannot write.`,
  notWritten: 'There is no program of this: it has no bytes.',
  options: 'Options',
  crc: 'CRC',
  crcWays,
  comments: 'Comments that explain each byte',
  units: (device: string) => `Values in the units of ${device}`,
  echo: 'The adapter gives back what is sent',
  timeout: 'Time-out in ms',
  timeoutWrong: (least: number, most: number) => `A whole number from ${least} to ${most}.`,
  name: 'Name of the request',
  nameHint: 'Blank: made of the function and its address.',
  names: 'Names of your own',
  namesHint: 'One a line: the name in the program = yours.',
  namesWrong: (lines: readonly number[]) =>
    `${plural(lines.length, 'line')} without “name = yours”: ${lines.join(', ')}.`,
  blank: (usual: string) => `Blank: ${usual}`,
  port: 'Serial port',
  host: 'Address of the server',
  tcpPort: 'TCP port',
  tcpPortWrong: (most: number) => `A whole number from 1 to ${most}.`,
  copy: 'Copy',
  copyFile: (file: string) => `Copy ${file}`,
  copied: 'Copied',
  copyFailed: 'The browser does not let this page copy. Select the text, or save it.',
  save: 'Save',
  saveFile: (file: string) => `Save ${file}`,
  picture: (file: string) => `What ${file} draws`,
  saveAll: 'Save all targets as a zip',
  zipName: 'modbus-programs.zip',
  code: (file: string) => `The program ${file}`,
  about: 'About this program',
  note: (code: string, data: NoteData, target: string) => notes.get(code)?.(data, target) ?? `Note: ${code}.`,
  proved: {
    rules: 'Checked by rules only: our tests cannot run it.',
    run: 'Our tests run such programs.',
    by: {
      compiled: ({ command, frames }) => `Compiled with ${command}, ${runOn(frames)}`,
      checked: ({ command, frames }) => `Checked with ${command}, ${runOn(frames)}`,
      interpreted: ({ frames }) => `Read by an interpreter of ours, ${runOn(frames)}`,
      sent: ({ frames }) =>
        `Run for ${frames} requests in our tests: the bytes that came out on the line are those of this page.`,
    } satisfies Readonly<Record<TargetProof['how'], (proof: TargetProof) => string>>,
  },
  titleOf: (name: string) => `Program: ${name}`,
  close: 'Close',
  linesLeft: (count: number) => `${plural(count, 'more line')}, which “Copy” and “Save” have.`,
  listing: {
    open: 'Why the guide’s listing does not compile',
    title: 'The guide’s listing, and ours',
    intro:
      'A guide for PLC programmers prints this block for the frame 06 06 02 AB 10 00 F5 E5. A strict compiler refuses it; CODESYS and TwinCAT, which take some of it, refuse the operator >>, too.',
    theirs: 'As the guide prints it',
    ours: 'As it is written here',
    refused: (fault: GuideFault, section: string) => `Refused (IEC 61131-3, ${section}): ${listingFaults[fault]}`,
    compiles: (fault: GuideFault) => `Compiles, but: ${listingFaults[fault]}`,
  },
};
