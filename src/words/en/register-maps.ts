import type {
  ColumnReason,
  DeviceFileFault,
  MapFault,
  MapFaultCode,
  MapNotice,
  MapNoticeCode,
  MapQuestion,
  Meaning,
  QuestionCode,
  TableFault,
} from '../../devices/index.ts';
import type { PlcCode } from '../../notation/index.ts';
import { plural } from './common.ts';
import { deviceFault, deviceFile } from './device-faults.ts';

/** What a column of a map is taken for. */
const meanings = {
  name: 'Name',
  'other-name': 'Other name',
  group: 'Group',
  description: 'Description',
  address: 'Address',
  number: 'Printed number',
  end: 'Last address',
  table: 'Table',
  function: 'Function code',
  access: 'Access',
  type: 'Type',
  order: 'Byte order',
  words: 'Length in registers',
  bytes: 'Length in bytes',
  'bit-size': 'Length in bits',
  count: 'Number of values',
  factor: 'Factor',
  divisor: 'Divisor',
  exponent: 'Power of ten',
  'scale-register': 'Register with the power of ten',
  offset: 'Offset of the value',
  decimals: 'Decimals',
  unit: 'Unit',
  names: 'Names of values or bits',
  range: 'Range',
  minimum: 'Minimum',
  maximum: 'Maximum',
  bit: 'Bit',
  mask: 'Mask',
  'not-implemented': 'Number that says “no value”',
  model: 'Models that have it',
  index: 'Number of the row',
  other: 'Not imported',
} satisfies Record<Meaning, string>;

/** Why a column was taken for it. */
const reasons = {
  header: 'its header says so',
  cells: 'its cells look like that',
  answer: 'you chose it',
  pair: 'it differs from the addresses by one',
  texts: 'its texts differ from row to row',
  unknown: 'nothing in it was recognized',
} satisfies Record<ColumnReason, string>;

/** What is asked once for all rows. */
const questions = {
  table: 'Which table are these registers in?',
  'function-or-digit': 'Are 3 and 4 function codes, or the first digits of 3xxxx and 4xxxx?',
  plc: 'Which controller has these devices?',
  counting: 'How do the addresses count?',
  base: 'Are the addresses hexadecimal?',
  scale: 'Does the scale multiply the number in the register, or divide it?',
  order: 'In which order are the bytes of values that take several registers?',
  type: 'What type is a value if the file names none?',
  'type-codes': 'What do the maker’s codes for types stand for?',
  decimals: 'Do the decimals scale the value, or only say how it is shown?',
  'text-length': 'How many registers does a text take?',
  start: 'At which address does the model begin?',
} satisfies Record<QuestionCode, string>;

const questionTexts: ReadonlyMap<unknown, string> = new Map(Object.entries(questions));

const controllers = {
  directlogic: 'DirectLOGIC',
  delta: 'Delta DVP',
  mitsubishi: 'Mitsubishi FX, with its default mapping',
  wago: 'WAGO',
  twincat: 'Beckhoff, TwinCAT Modbus server',
  'beckhoff-bc': 'Beckhoff BC or BX',
  'siemens-db': 'Siemens: the mapping begins with the data block',
  'siemens-m': 'Siemens: the mapping begins with MW0',
  rockwell: 'Rockwell: the mapping begins with the file',
  omron: 'Omron',
  schneider: 'Schneider, which counts words',
} satisfies Record<PlcCode, string>;

/** The answers that are words. */
const answers: ReadonlyMap<string, string> = new Map(
  Object.entries({
    coil: 'Coils',
    'discrete-input': 'Discrete inputs',
    'input-register': 'Input registers',
    'holding-register': 'Holding registers',
    function: 'Function codes: 03 reads holding registers, 04 input registers',
    digit: 'Digits: 3xxxx are input registers, 4xxxx holding registers',
    ...controllers,
    direct: 'The number is the address',
    zero: 'As they are sent, from 0',
    one: 'From 1',
    'five-digit': 'Five digits, 40001 is the first',
    'six-digit': 'Six digits, 400001 is the first',
    'five-digit-zero': 'Five digits, 40000 is the first',
    hexadecimal: 'Hexadecimal',
    decimal: 'Decimal',
    multiply: 'It multiplies',
    divide: 'It divides',
    scale: 'They scale: 490 with one decimal is 49.0',
    shown: 'They only say how the value is shown',
  }),
);

type FaultWords = (fault: MapFault) => string;
const faults = {
  'no-table': () => 'The file is empty.',
  'no-registers': () => 'No row of the file is a register.',
  'not-a-table': ({ format }) => `No table was found in the file${format ? `, which is a ${format} file` : ''}.`,
  unreadable: ({ format, detail }) => `The file could not be read as ${format}: ${detail}`,
  'too-large': () => 'The file is too large.',
  'no-address-column': () => 'No column was recognized as the addresses. Choose it in the table above.',
  'address-missing': () => 'The row has no address.',
  'address-unreadable': () => 'The address cannot be read.',
  'address-outside': () => 'The address is outside 0 to 65535.',
  'not-in-convention': () => 'The number is not written like the others: its first digit does not name a table.',
  'own-file': ({ fault }) => deviceFile(fault as DeviceFileFault),
  'own-table': ({ fault }) => deviceFault(fault as TableFault),
} satisfies Record<MapFaultCode, FaultWords>;

type NoticeWords = (notice: MapNotice) => string;
const notices = {
  assumed: ({ question }) => `The file does not say: ${questionTexts.get(question) ?? ''}`,
  'addresses-like-numbers': () =>
    'The addresses look like numbers that manuals print: 30001 and 40001 are the first ones.',
  'odd-number': () => 'The number is written differently from the others.',
  'number-grouped': () => 'A point or comma in the address was taken as a thousands separator: 1.000 is one thousand.',
  'number-of-other-table': () => 'The first digit of the number and the row name different tables.',
  heading: () => 'Titles or headings, not registers.',
  'table-left': ({ sheet }) => `This table has no addresses and was left out${sheet ? `: ${sheet}` : ''}.`,
  'columns-left': ({ headers }) => `These columns were left out: ${(headers as readonly string[]).join(', ')}.`,
  'more-cells': () => 'The row has more cells than the header. A text that contains a comma needs quotes.',
  'quote-open': () => 'A quote in the row is not closed; the text was taken as it stands.',
  'name-missing': () => 'The row has no name; the address is used instead.',
  unused: () => 'The name says that the register is not in use.',
  'table-unknown': () => 'The table or function is not known.',
  'access-unknown': () => 'The access is not known; read and write was assumed.',
  'access-not-for-table': () => 'This table can only be read.',
  'type-unknown': () => 'The type is not known.',
  'type-rest': () => 'Only the beginning of the type was understood.',
  'type-from-length': () => 'The type was worked out from the length alone.',
  'length-contradicts': () => 'The length does not fit the type.',
  'text-length-from-next': () => 'The length of the text was worked out from the address of the next register.',
  'order-unknown': () => 'The byte order is not known.',
  'factor-unreadable': () => 'The factor cannot be read; the value is not scaled.',
  'factor-from-range': () => 'The factor was worked out from the decimals of the range.',
  'offset-unreadable': () => 'The offset cannot be read and was left out.',
  'scale-register-unknown': () => 'The register with the power of ten is not in the file.',
  'names-rest': () => 'Part of the names could not be read; it was put in the description.',
  'names-twice': () => 'A value or bit has two names.',
  'names-as-bits': () => 'The names were taken to be those of single bits.',
  'range-kept': () => 'The range of values was put in the description.',
  'address-twice': () => 'Two registers have the same address.',
  outlier: () => 'The address is far from those of the rows before and after it.',
  overlap: () => 'A value begins inside another one.',
  'own-table': ({ fault }) => deviceFault(fault as TableFault),
} satisfies Record<MapNoticeCode, NoticeWords>;

const lines = new Intl.ListFormat('en', { type: 'conjunction' });
const MOST_ROWS = 6;

/** `Rows 4, 5 and 12: `; of many rows their count and the first ones. */
function rowsText(rows: readonly number[]): string {
  if (rows.length === 0) return '';
  if (rows.length === 1) return `Row ${rows[0]}: `;
  if (rows.length <= MOST_ROWS) return `Rows ${lines.format(rows.map(String))}: `;
  return `${plural(rows.length, 'row')}, starting with ${rows.slice(0, MOST_ROWS - 1).join(', ')}: `;
}

/** What the import of a register map says. */
export const registerMaps = {
  meanings,
  reasons,
  column: (header: string, meaning: Meaning, why: ColumnReason) =>
    `${header || 'The column without a header'} is taken for: ${meanings[meaning]}, because ${reasons[why]}.`,
  question: ({ code }: MapQuestion) => questions[code],
  /** An answer; codes of orders, types and numbers stand for themselves. */
  answer: (option: string) => answers.get(option) ?? option,
  fault: (fault: MapFault) => `${rowsText(fault.rows)}${(faults[fault.code] as FaultWords)(fault)}`,
  notice: (notice: MapNotice) => `${rowsText(notice.rows)}${(notices[notice.code] as NoticeWords)(notice)}`,
};
