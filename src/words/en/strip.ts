import { dictionary, fieldValue, functionCodes, type Problem, type Reading, type Span } from '../../modbus/index.ts';
import { entityNumber, formatBytes } from '../../notation/index.ts';
import type { CopyFormat, FrameVerdict, StaleReason } from '../../workbench/index.ts';
import { en as fields } from './fields.ts';
import { byteHex, code, grouped, plural, word } from './numbers.ts';
import { page } from './page.ts';

/** What a frame is: `request`, `reply`, `exception`. */
const kindOf = ({ direction, functionCode = 0 }: Reading) =>
  direction === 'response' && functionCode > 0x7f ? 'exception' : page.directions[direction];

const verdicts: Readonly<Record<FrameVerdict, (reading: Reading) => string>> = {
  valid: (reading) => `Valid ${kindOf(reading)}`,
  doubtful: (reading) => `Doubtful ${kindOf(reading)}`,
  invalid: (reading) => `Invalid ${kindOf(reading)}`,
  incomplete: (reading) => `Incomplete ${kindOf(reading)}`,
  'wrong-checksum': ({ transport }) => (transport === 'ascii' ? 'Wrong LRC' : 'Wrong CRC'),
};

/** What functions do, where there is little room. */
const functions: Readonly<Record<number, string>> = {
  1: 'read coils',
  2: 'read discrete inputs',
  3: 'read holding registers',
  4: 'read input registers',
  5: 'write one coil',
  6: 'write one register',
  15: 'write coils',
  16: 'write registers',
  22: 'mask one register',
  23: 'read and write registers',
  43: 'device information',
};

/** A span of the frame, and what a device calls it. */
export interface StripField {
  readonly reading: Reading;
  readonly span: Span;
  /** The device's name of an address, a value in its unit; empty if there is none. */
  readonly named: string;
  /** Whether its address was typed in six digits. */
  readonly sixDigits?: boolean | undefined;
}

/** What the bytes of a field mean, in a few words; empty if that is plain. */
function note({ reading, span, named, sixDigits }: StripField): string {
  const { name, kind } = span;
  const value = name === 'unitId' || name === 'transactionId' ? reading[name] : fieldValue(reading, name);
  if (name === 'functionCode') return functionNote(reading);
  if (kind === 'checksum') return checksumNote(reading, span);
  if (kind === 'address' && typeof value === 'number')
    return `${value} = ${named || numberOf(reading, value, sixDigits)}`;
  if (Array.isArray(value)) return listNote(reading, name, value.length);
  if (name === 'unitId' && value === 0 && reading.transport !== 'tcp') return '0, broadcast';
  if (typeof value === 'boolean') return value ? 'ON' : 'OFF';
  if (typeof value !== 'number') return byName[name] ?? '';
  const choice = fields.choices[name]?.[value];
  return choice ? `${value}, ${choice.name}` : named ? `${value} = ${named}` : String(value);
}

const byName: Readonly<Record<string, string>> = dictionary({
  start: 'colon',
  end: 'CR LF',
  rest: 'too many',
  after: 'too many',
});

function functionNote({ functionCode = 0 }: Reading): string {
  const plain = functionCode & 0x7f;
  const name = functions[plain] ?? functionCodes.find((each) => each.code === plain)?.name.toLowerCase();
  const known = name ?? `function ${code(plain)}`;
  return functionCode > 0x7f ? `refused: ${known}` : known;
}

function checksumNote({ problems }: Reading, { from, to }: Span): string {
  const wrong = problems.find(
    (problem): problem is Extract<Problem, { code: 'checksum-wrong' }> => problem.code === 'checksum-wrong',
  );
  if (wrong === undefined) return to - from < 2 ? 'cut off' : 'correct';
  const { expected, algorithm } = wrong;
  return `should be ${algorithm === 'lrc' ? byteHex(expected) : formatBytes(Uint8Array.of(expected & 0xff, expected >>> 8))}`;
}

/** The number that manuals print. */
const numberOf = ({ description }: Reading, address: number, sixDigits?: boolean) =>
  description?.table === undefined ? word(address) : entityNumber(description.table, address, sixDigits);

function listNote({ description }: Reading, name: string, count: number): string {
  const { table } = description ?? {};
  if (table === 'coil' || table === 'discrete-input') return plural(count, 'bit');
  return name === 'registers' || name.endsWith('egisters')
    ? plural(count, 'register')
    : plural(count, 'entry', 'entries');
}

const unitOf = ({ transport }: Reading, size: number) =>
  `${transport === 'ascii' ? 'character' : 'byte'}${size === 1 ? '' : 's'}`;

/** The formats in which a frame is copied, on the button. */
const formats: Readonly<Record<CopyFormat, string>> = {
  spaced: 'hex',
  c: 'C',
  arduino: 'Arduino',
  csharp: 'C#',
  st: 'ST',
  python: 'Python',
  javascript: 'JavaScript',
  list: '0x list',
  plain: 'hex, unbroken',
  decimal: 'decimal',
  escapes: 'escaped string',
  brackets: 'bracketed bytes',
  'ascii-line': 'ASCII line',
};

/** What the strip of a frame says. */
export const strip = {
  verdict: (verdict: FrameVerdict, reading: Reading) => verdicts[verdict](reading),
  /** `RTU request, 8 bytes` */
  kindAndSize: (reading: Reading, size: number) =>
    `${page.transports[reading.transport]} ${kindOf(reading)}, ${grouped(size)} ${unitOf(reading, size)}`,
  note,
  /** The name of a byte for those who hear it. */
  byteName: (at: number, shown: string, field: string) => `byte ${at}, ${shown}, ${field}`,
  editByte: (at: number) => `Byte ${at}, two hexadecimal digits`,
  copied: 'Copied',
  /** What the button copies: a format by its short name. */
  copy: (format: CopyFormat) => `Copy ${formats[format]}`,
  noChecksum: 'no checksum',
  copyWrong: 'Copy the wrong frame',
  copyBefore: 'Copy the frame before',
  copyFailed: 'The browser refused. Select the text and copy it:',
  copyAs: 'Other formats',
  link: 'Link',
  linkHint: 'Copies a link to this frame',
  explanation: 'Explain',
  explanationHint: 'Explain: copies the explanation',
  before: 'The frame before',
  noFrame: 'No frame',
  keepInSight: 'Keep the whole frame in sight',
  stale: {
    'no-bytes': () => 'The text above has no bytes.',
    'not-chosen': () => 'Choose what the text above means.',
    field: (label: string) => `“${label}” has no value that can be sent.`,
  } satisfies Record<StaleReason['code'], (label: string) => string>,
  more: (count: number) => `${grouped(count)} more`,
  showAll: (field: string, count: number) => `${field}: show ${plural(count, 'more byte')}`,
  fold: 'Fold',
  foldField: (field: string) => `Fold ${field}`,
};
