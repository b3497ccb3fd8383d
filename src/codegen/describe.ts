import { nameAt, type Profile, printedNumber } from '../devices/index.ts';
import {
  accessOf,
  type Field,
  fieldByName,
  fieldsOf,
  firstAddress,
  hexDigits,
  partsOf,
  type Reading,
  type Span,
} from '../modbus/index.ts';
import { entityNumber, plainWords } from '../notation/index.ts';
import type { Name, TableRow } from './code.ts';
import { wordsOf } from './plain-words.ts';

/** The address as it is sent, as manuals print it, and as the device calls it: `683 = register 40684 = P0683`. */
function addressText(reading: Reading, address: number, profile: Profile | undefined): string {
  const table = reading.description?.table;
  if (table === undefined || table === 'file-record') return String(address);
  const printed =
    profile === undefined || profile.convention === 'zero-based'
      ? entityNumber(table, address)
      : printedNumber(profile.convention, table, address);
  const called = profile && nameAt(profile, table, address);
  const what = table === 'coil' ? 'coil' : table === 'discrete-input' ? 'input' : 'register';
  return [String(address), `${what} ${printed}`, ...(called === undefined ? [] : [called])].join(' = ');
}

const truth = (value: boolean): string => (value ? 'on' : 'off');

/** What a field holds, after its name. */
function fieldText(reading: Reading, field: Field, value: unknown, profile: Profile | undefined): string {
  if (field.kind === 'address' && typeof value === 'number') return addressText(reading, value, profile);
  if (typeof value === 'boolean') return truth(value);
  if (typeof value === 'number' || typeof value === 'string') return String(value);
  if (!Array.isArray(value)) return '';
  const item = field.kind === 'registers' ? 'register' : field.kind === 'bits' ? 'bit' : field.group ? 'group' : 'byte';
  return `${value.length} ${item}${value.length === 1 ? '' : 's'}`;
}

/** The function in words: `06 Write Single Register`. */
export const functionText = ({ functionCode = 0, description }: Reading): string =>
  `${hexDigits(functionCode, 2)}${description === undefined || description.code !== functionCode ? '' : ` ${description.name}`}`;

/** What a request does, in one line: `Write Single Register, unit 6: address 683 = register 40684, value 4096`. */
export function aboutRequest(reading: Reading, profile: Profile | undefined): string {
  const { description, direction, fields, unitId, functionCode = 0 } = reading;
  const known = description !== undefined && description.code === functionCode;
  const said = [...fieldsOf(description, direction, fields)]
    .filter(({ field }) => field.derive === undefined && fields[field.name] !== undefined)
    .map(({ field }) => `${wordsOf(field.name)} ${fieldText(reading, field, fields[field.name], profile)}`.trim());
  const what = known ? description.name : `Function ${hexDigits(functionCode, 2)}`;
  const head = unitId === undefined ? what : `${what}, unit ${unitId}`;
  return said.length === 0 ? head : `${head}: ${said.join(', ')}`;
}

const ENVELOPE: Readonly<Record<string, string>> = Object.assign(Object.create(null), {
  protocolId: 'protocol: 0 is Modbus',
  start: 'colon',
  end: 'CR LF',
  rest: 'bytes that no field takes',
  after: 'bytes after the frame',
});

function spanText(reading: Reading, { name }: Span, profile: Profile | undefined): string {
  const said = ENVELOPE[name];
  if (said !== undefined) return said;
  switch (name) {
    case 'unitId':
      return `unit ${reading.unitId}`;
    case 'functionCode':
      return `function ${functionText(reading)}`;
    case 'transactionId':
      return `transaction ${reading.transactionId}`;
    case 'length':
      return `length: ${reading.length} bytes follow`;
    case 'checksum':
      return reading.transport === 'ascii' ? 'LRC' : 'CRC, low byte first';
  }
  const field = fieldByName(reading, name);
  const value = Object.hasOwn(reading.fields, name) ? reading.fields[name] : reading.derived[name];
  const text = field === undefined ? '' : fieldText(reading, field, value, profile);
  return text === '' ? wordsOf(name) : `${wordsOf(name)}: ${text}`;
}

/** A line for each span of a frame; of a list of registers, one for each register. */
export function rowsOf(reading: Reading, bytes: Uint8Array, profile: Profile | undefined): readonly TableRow[] {
  return reading.spans.flatMap((span) => {
    const row = { from: span.from, to: span.to, span: span.name, comment: spanText(reading, span, profile) };
    if (span.kind !== 'registers') return [row];
    const first = firstAddress(reading, span.name);
    const items = partsOf(reading, bytes, span).map(({ index, span: place, values }) => ({
      from: place.from,
      to: place.to,
      span: span.name,
      comment: `${first === undefined ? `register ${index + 1}` : addressText(reading, first + index, profile)}: ${String(values['value'])}`,
    }));
    return items.at(-1)?.to === span.to ? items : [row];
  });
}

/** What is said of the parameter for a field of the request. */
export function parameterText(reading: Reading, field: string): string {
  if (field === 'unitId') return 'the address of the device';
  if (field === 'transactionId') return 'the reply has the same';
  if (field === 'functionCode') return functionText(reading);
  const found = [...fieldsOf(reading.description, 'request', reading.fields)]
    .flatMap(({ field: one }) => [one, ...(one.group ?? [])])
    .find(({ name }) => name === field);
  if (found === undefined) return '';
  if (found.range !== undefined) return `from ${found.range.least} to ${found.range.most}`;
  if (found.kind === 'address') return 'counted from 0';
  if (found.kind === 'flag') return 'on or off';
  if (found.kind === 'registers') return 'words, from the first register on';
  if (found.kind === 'bits') return 'from the first address on';
  if (found.width === 0) return 'bytes as they are sent';
  return found.width === 1 ? 'a byte' : 'a word';
}

const MOST_WORDS = 3;

/** What a request is called if nobody gave it a name: `write 683 4096`, `read p0681`, `function 2b 14`. */
export function requestName(reading: Reading, profile: Profile | undefined): Name {
  const { description, functionCode = 0, fields } = reading;
  const table = description?.table;
  const verb =
    table === undefined ? ['function', hexDigits(functionCode, 2)] : [accessOf(reading) === 'reads' ? 'read' : 'write'];
  const detail = [...fieldsOf(description, reading.direction, fields)].flatMap(({ field }) => {
    const value = fields[field.name];
    if (typeof value === 'boolean') return [truth(value)];
    if (typeof value !== 'number' || field.kind === 'list') return [];
    const called =
      field.kind === 'address' && table !== undefined && table !== 'file-record' && profile
        ? nameAt(profile, table, value)
        : undefined;
    return called === undefined ? [String(value)] : [shortName(called)];
  });
  return plainWords([...verb, ...detail].join(' '));
}

/** A code such as P0683, or the first words of a name. */
function shortName(called: string): string {
  const words = plainWords(called).split(' ');
  const [first = ''] = words;
  return /^[a-z]+\d+$/.test(first) ? first : words.slice(0, MOST_WORDS).join(' ');
}
