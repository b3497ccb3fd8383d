import {
  diagnosticSubFunctions,
  dictionary,
  fieldByName,
  fieldValue,
  firstAddress,
  inPairs,
  LAST_UNIT,
  type Problem,
  quantityOf,
  type Reading,
  type Span,
  type Table,
  TCP_DIRECT,
} from '../../modbus/index.ts';
import { entityNumber, formatBinary, formatBytes } from '../../notation/index.ts';
import { addressSentence, capital, elementIn, lastAddress } from './address.ts';
import { en as fields } from './fields.ts';
import { byte, byteHex, bytesOf, code, plural, word } from './numbers.ts';

/** A span to explain, with its frame. */
export interface Explained {
  readonly reading: Reading;
  readonly bytes: Uint8Array;
  readonly span: Span;
  /** Whether the address was typed in six digits. */
  readonly sixDigits?: boolean | undefined;
}

/** What the bytes of a field mean in this frame. */
export function meaning(explained: Explained): string {
  const { reading, span } = explained;
  const value =
    span.name === 'unitId' || span.name === 'transactionId' || span.name === 'functionCode'
      ? reading[span.name]
      : fieldValue(reading, span.name);
  const own = byName[span.name] ?? byKind[span.kind];
  if (value === undefined && !frameParts.has(span.name)) return 'Cut off: the frame ends inside this field.';
  return own?.(explained, value) ?? numberAndHex(value);
}

const frameParts = new Set(['start', 'end', 'rest', 'after', 'checksum', 'characters']);

type Meaning = (explained: Explained, value: unknown) => string;

const numberAndHex = (value: unknown) =>
  typeof value === 'number' ? `${value} (${word(value)}).` : String(value ?? '');

const following = (count: number) => `${bytesOf(count)} ${count === 1 ? 'follows' : 'follow'}`;

const byName: Readonly<Record<string, Meaning>> = dictionary({
  unitId: ({ reading }) => unit(reading),
  functionCode: ({ reading }) => functionCode(reading),
  transactionId: (_explained, value) =>
    `Transaction ${numberAndHex(value)} The reply repeats it, so that replies find their requests.`,
  protocolId: (_explained, value) =>
    value === 0 ? 'Protocol 0: Modbus.' : `Protocol ${word(value as number)}, which is not Modbus.`,
  length: (_explained, value) => `${following(value as number)}: the unit identifier and the PDU.`,
  checksum: (explained) => checksum(explained),
  start: () => 'A colon starts an ASCII frame.',
  end: () => 'Carriage return and line feed end the frame.',
  characters: () => 'These characters are not a byte.',
  rest: () => 'Bytes that no field of this function takes.',
  after: () => 'Bytes behind the end of the frame.',
  outputData: (_explained, value) =>
    `Eight status bits of the device's own meaning, lowest first: ${bitString(value as number)}.`,
  subFunction: (_explained, value) => subFunction(value as number),
  eventCount: (_explained, value) => `${plural(value as number, 'message')} completed since the last restart or clear.`,
  messageCount: (_explained, value) =>
    `${plural(value as number, 'message')} processed since the last restart or clear.`,
  nextObjectId: (_explained, value) =>
    value === 0 ? 'No object is left to ask for.' : `Ask again from object ${byte(value as number)}.`,
  andMask: (_explained, value) => `Bits that are 1 here are kept: ${bits16(value as number)}.`,
  orMask: (_explained, value) =>
    `Bits set where the AND mask is 0: ${bits16(value as number)}. The register becomes (current AND and) OR (or AND NOT and).`,
  recordLength: (_explained, value) => plural(value as number, 'register'),
});

const byKind: Readonly<Record<string, Meaning>> = dictionary({
  address: ({ reading, span, sixDigits }, value) =>
    `${addressSentence(tableOf(reading), value as number, sixDigits)}${quantityAfter(reading, span.name, value as number)} High byte first.`,
  quantity: ({ reading, span }, value) => quantityWords(reading, span, value as number),
  count: (_explained, value) => `${following(value as number)} in what this counts.`,
  choice: ({ reading, span }, value) =>
    choiceWords(span.name, value as number, fieldByName(reading, span.name)?.width === 2 ? word : byte),
  flag: ({ reading }, value) => flagWords(reading, value as boolean),
  registers: ({ span }, value) =>
    `${plural((value as unknown[]).length, 'register')}, each high byte first, ${bytesOf(span.to - span.from)}.`,
  bits: ({ reading }, value) => bitsWords(reading, value as readonly number[]),
  list: (_explained, value) => `${plural((value as unknown[]).length, 'entry', 'entries')}.`,
  groups: (_explained, value) => `${plural((value as unknown[]).length, 'group')}.`,
  bytes: (_explained, value) => `${bytesOf((value as string).length / 2)} of raw data${asText(value as string)}.`,
  number: (_explained, value) =>
    `${value} (${(value as number) > 0xff ? word(value as number) : byte(value as number)}).`,
});

function unit({ transport, direction, unitId = 0 }: Reading): string {
  if (transport === 'tcp') {
    if (unitId === TCP_DIRECT) return 'The TCP server itself, not a device behind a gateway.';
    if (unitId === 0) return 'The TCP server itself; behind a gateway, a broadcast on the serial line.';
    return unitId <= LAST_UNIT
      ? `Behind a gateway this is device ${unitId} on the serial line.`
      : `Unit ${unitId}, without an agreed meaning.`;
  }
  if (unitId === 0)
    return direction === 'request'
      ? 'Unit 0, broadcast: every device listens, and no device answers.'
      : 'Unit 0, from which no reply comes.';
  if (unitId > LAST_UNIT) return `Unit ${unitId}, which is reserved.`;
  return direction === 'request'
    ? `Unit ${unitId} is addressed; every other device on the line stays silent.`
    : `Unit ${unitId} answers. A reply carries the address of the device, not of the client.`;
}

function functionCode({ functionCode: got = 0, direction, description }: Reading): string {
  if (got < 0x80)
    return `Function ${code(got)}, ${description?.code === got ? description.name : 'raw data'}. Its top bit is 0: not an exception.`;
  return direction === 'response'
    ? `${byteHex(got)} = 80 + ${code(got & 0x7f)}: function ${code(got & 0x7f)} was refused. The next byte says why.`
    : `Code ${byte(got)}: raw data.`;
}

function checksum({ reading, span, bytes }: Explained): string {
  const wrong = reading.problems.find(
    (problem): problem is Extract<Problem, { code: 'checksum-wrong' }> => problem.code === 'checksum-wrong',
  );
  const got = reading.derived['checksum'];
  if (typeof got !== 'number') return 'Cut off: the frame ends inside its checksum.';
  if (reading.transport === 'ascii') {
    const range = 'LRC of the bytes before it: their sum and this make 0 in the low byte.';
    return wrong
      ? `${range} Here ${byteHex(got)} does not hold; it should be ${byteHex(wrong.expected)}.`
      : `${range} It holds.`;
  }
  const stands = formatBytes(bytes.subarray(span.from, span.to));
  return wrong
    ? `CRC-16/MODBUS of bytes 0–${span.from - 1} is ${word(wrong.expected)}, sent low byte first. ${stands} does not hold.`
    : `CRC-16/MODBUS of bytes 0–${span.from - 1} is ${word(got)}, sent low byte first. It holds.`;
}

const tableOf = ({ description }: Reading): Table | undefined => description?.table;

/** The last address, where a quantity follows. */
function quantityAfter(reading: Reading, name: string, first: number): string {
  const partner = quantityOf(name);
  const quantity = partner === undefined ? undefined : fieldValue(reading, partner);
  return typeof quantity === 'number' && quantity > 1 ? ` The last is ${lastAddress(first, quantity)}.` : '';
}

function quantityWords(reading: Reading, span: Span, value: number): string {
  if (span.name === 'numberOfObjects') return `${plural(value, 'object')}.`;
  const table = tableOf(reading);
  if (table === undefined || table === 'file-record') return `${value}.`;
  return `${value} ${value === 1 ? fields.tables[table].one : fields.tables[table].many}.`;
}

function choiceWords(name: string, value: number, hex: (value: number) => string): string {
  const choice = fields.choices[name]?.[value];
  if (choice === undefined) return `${hex(value)}.`;
  return `${hex(value)}, ${choice.name}${choice.hint ? `: ${choice.hint}` : ''}.`;
}

function flagWords(reading: Reading, value: boolean): string {
  const raw = reading.derived['rawValue'] as number;
  if (raw !== 0xff00 && raw !== 0) return `${word(raw)}: neither ON nor OFF.`;
  return value ? 'ON, which is FF 00.' : 'OFF, which is 00 00.';
}

function bitsWords(reading: Reading, value: readonly number[]): string {
  const table = tableOf(reading);
  const many = table ? fields.tables[table].many : 'bits';
  const on = value.filter((bit) => bit === 1).length;
  return `${value.length} ${many}, ${on} of them ON. The first is the lowest bit of the first byte.`;
}

const bitString = (value: number) => Array.from({ length: 8 }, (_, bit) => (value >> bit) & 1).join(' ');
const bits16 = (value: number) => formatBinary(value, 16);

/** Longest text that is written out: no legal frame has a longer one. */
const LONGEST_TEXT = 600;

const beginning = (characters: readonly number[]): string =>
  String.fromCharCode(...characters.slice(0, LONGEST_TEXT)) + (characters.length > LONGEST_TEXT ? '…' : '');

function asText(hexPairs: string): string {
  const characters = hexPairs.match(/../g)?.map((pair) => Number.parseInt(pair, 16)) ?? [];
  return characters.length > 1 && characters.every((character) => character >= 0x20 && character < 0x7f)
    ? `, as text “${beginning(characters)}”`
    : '';
}

function subFunction(value: number): string {
  const known = diagnosticSubFunctions.find(({ code: number }) => number === value);
  return `Sub-function ${word(value)}${known ? `, ${known.name}` : ''}.`;
}

interface Item {
  readonly reading: Reading;
  readonly name: string;
  readonly kind: Span['kind'];
  readonly index: number;
  readonly values: Readonly<Record<string, unknown>>;
  /** Where the item is, if a device does not count one address for each. */
  readonly address?: number | undefined;
  readonly sixDigits?: boolean | undefined;
}

interface Byte {
  readonly span: Span;
  readonly index: number;
  readonly value: number;
  /** How many bytes the field or item has. */
  readonly many: number;
}

/** What one byte of several means: half of a number, or a character. */
export function byteMeaning({ span: { kind, name }, index, value, many }: Byte): string {
  if (name === 'end') return value === 0x0d ? 'Carriage return.' : value === 0x0a ? 'Line feed.' : '';
  if (kind === 'checksum') return index === 0 ? 'Low byte of the CRC, sent first.' : 'High byte of the CRC.';
  if (inPairs.has(kind) && many % 2 === 0) {
    return index % 2 === 0 ? `High byte: ${value} × 256 = ${256 * value}.` : `Low byte: ${value}.`;
  }
  return value > 0x20 && value < 0x7f ? `As a character: ${String.fromCharCode(value)}` : '';
}

/** What a field of a group means. */
export const groupFieldMeaning = (name: string, values: Readonly<Record<string, unknown>>): string =>
  name === 'recordNumber'
    ? addressSentence('file-record', values[name] as number)
    : `${capital(fields.labels[name] ?? name)}: ${valueWords(name, values[name])}.`;

/** What one item of a list means: a register, eight coils, an event, a group. */
export function itemMeaning({ reading, name, kind, index, values, address, sixDigits }: Item): string {
  const first = firstAddress(reading, name);
  const table = tableOf(reading);
  const { value } = values;
  switch (kind) {
    case 'registers': {
      const number = value as number;
      const at = address ?? (first === undefined ? undefined : first + index);
      const where = at === undefined ? `Register ${index + 1} of the list` : capital(elementIn(table, at, sixDigits));
      const signed = number > 0x7fff ? `, signed ${number - 0x10000}` : '';
      return `${where} = ${number} (${word(number)})${signed}.`;
    }
    case 'bits': {
      const one = table ? fields.tables[table].one : 'bit';
      const printed = (address: number) => (table ? ` (${entityNumber(table, address, sixDigits)})` : '');
      const which = (at: number) => (first === undefined ? String(at) : `${first + at}${printed(first + at)}`);
      const states = (value as readonly number[]).map((bit, i) => `${which(8 * index + i)} ${bit ? 'ON' : 'off'}`);
      return `From the lowest bit, ${one} ${first === undefined ? 'number in the list ' : ''}${states.join(', ')}.`;
    }
    case 'list':
      return `Event ${index + 1}: ${event(value as number)}.`;
    default:
      return `${capital(name === 'objects' ? 'object' : 'group')} ${index + 1}: ${groupWords(values)}.`;
  }
}

interface Items {
  readonly reading: Reading;
  readonly name: string;
  readonly index: number;
  readonly count: number;
  readonly address: number | undefined;
  readonly sixDigits?: boolean | undefined;
}

/** Registers that hold one value together. */
export function itemsMeaning({ reading, name, index, count, address, sixDigits }: Items): string {
  const table = tableOf(reading);
  if (address !== undefined)
    return `${capital(elementIn(table, address, sixDigits))}, sent as ${plural(count, 'register')}.`;
  const first = (firstAddress(reading, name) ?? 0) + index;
  const last = first + count - 1;
  if (table === undefined) return `Registers ${first}–${last}.`;
  const many = table === 'holding-register' ? 'registers' : fields.tables[table].many;
  return `${capital(many)} ${entityNumber(table, first, sixDigits)}–${entityNumber(table, last, sixDigits)} (addresses ${first}–${last}).`;
}

function groupWords(values: Readonly<Record<string, unknown>>): string {
  return Object.entries(values)
    .map(([name, value]) => `${(fields.labels[name] ?? name).toLowerCase()} ${valueWords(name, value)}`)
    .join(', ');
}

function valueWords(name: string, value: unknown): string {
  if (name === 'valueHex') return `${value}${asText(value as string)}`;
  const choice = typeof value === 'number' ? fields.choices[name]?.[value] : undefined;
  return `${Array.isArray(value) ? value.join(' ') : String(value)}${choice ? ` (${choice.name})` : ''}`;
}

const RECEIVE: readonly (readonly [number, string])[] = [
  [0x02, 'communication error'],
  [0x10, 'character overrun'],
  [0x20, 'in listen only mode'],
  [0x40, 'broadcast received'],
];
const SEND: readonly (readonly [number, string])[] = [
  [0x01, 'read exception sent (codes 1–3)'],
  [0x02, 'abort exception sent (code 4)'],
  [0x04, 'busy exception sent (codes 5–6)'],
  [0x08, 'program NAK exception sent (code 7)'],
  [0x10, 'write time-out'],
  [0x20, 'in listen only mode'],
];

/** An event byte of the log (AP 6.10). */
function event(value: number): string {
  if (value === 0x00) return '00, communications restarted';
  if (value === 0x04) return '04, entered listen only mode';
  const list = value & 0x80 ? RECEIVE : value & 0x40 ? SEND : [];
  const what = value & 0x80 ? 'received' : value & 0x40 ? 'sent' : 'not defined';
  const names = list.filter(([bit]) => value & bit).map(([, name]) => name);
  return `${byteHex(value)}, ${what}${names.length > 0 ? `: ${names.join(', ')}` : ''}`;
}
