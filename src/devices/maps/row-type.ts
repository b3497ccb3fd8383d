import { isTextType, type ValueType } from '../../modbus/index.ts';
import type { TypeReading } from '../../notation/index.ts';
import { wordsOf } from '../codec.ts';
import { isFilled } from './cell-kinds.ts';
import type { MapRow } from './map-row.ts';
import type { RowDoubts } from './row-doubts.ts';
import { readFormat, readGap, readTypeStart } from './type-cell.ts';

/** What has been decided for rows that do not say it. */
export interface TypeRules {
  readonly type: ValueType;
  /** A maker's own codes. */
  readonly codes: ReadonlyMap<string, { readonly type: ValueType; readonly factor: number }>;
  readonly textLength: number | undefined;
}

export interface RowType {
  readonly type: ValueType;
  readonly reading?: TypeReading;
  /** What the type says of the scale: of `DEC 1`, and of a maker's code. */
  readonly factor?: number;
}

/** The registers of a value, from a column of lengths, from the last address, or from a range of addresses. */
export function lengthOf(row: MapRow): number | undefined {
  const { number, last } = row.address;
  if (last !== undefined) return last - number + 1;
  const words = Number.parseInt(row.text('words'), 10);
  if (words > 0) return words;
  const bytes = Number.parseInt(row.text('bytes'), 10);
  if (bytes > 0) return Math.ceil(bytes / 2);
  const bits = Number.parseInt(row.text('bit-size'), 10);
  if (bits >= 8) return Math.ceil(bits / 16);
  const text = row.text('end');
  const end = Number.parseInt(text.replace(/^0x/i, ''), /^0x/i.test(text) ? 16 : 10);
  return end >= number && end - number < MOST_LENGTH ? end - number + 1 : undefined;
}

const MOST_LENGTH = 1000;
const PLAIN: ReadonlyMap<number, ValueType> = new Map([
  [1, 'u16'],
  [2, 'u32'],
  [3, 'u48'],
  [4, 'u64'],
]);

/** The type of a row, from its name, its length, and the sign of its minimum. */
export function typeOfRow(row: MapRow, rules: TypeRules, bitTable: boolean, doubts: RowDoubts): RowType {
  const text = row.text('type');
  const length = lengthOf(row);
  const code = rules.codes.get(text);
  if (code) return code;
  if (row.address.text)
    return { type: 'text', reading: { type: 'text', order: row.address.text === 'low' ? 'BADC' : 'ABCD' } };
  const format = readFormat(text);
  const whole = format ? undefined : row.read.type(text, length);
  const start = format || whole ? undefined : readTypeStart(text, length);
  if (start && start.factor === undefined) doubts.notices.push('type-rest');
  const reading = whole ?? start;
  if (reading) {
    if (bitTable) return { type: 'bits', reading };
    if (contradicts(reading, length)) doubts.notices.push('length-contradicts');
    const type = reading.loose ? signed(reading.type, row) : reading.type;
    return { type, reading, ...(start?.factor !== undefined && { factor: start.factor }) };
  }
  if (bitTable) return { type: 'bits' };
  if (isFilled(text) && readGap(text) === undefined && !format) doubts.notices.push('type-unknown');
  const factor = format ? { factor: format.factor } : {};
  const plain = length === undefined ? undefined : PLAIN.get(length);
  if (plain && length !== 1) {
    if (!format) doubts.notices.push('type-from-length');
    return { type: signed(plain, row), ...factor };
  }
  if (isNegative(row)) return { type: 'i16', ...factor };
  if (!isFilled(text) && length === undefined) doubts.assumed.push('type');
  return { type: length === 1 || format ? 'u16' : rules.type, ...factor };
}

/** The name says another width than the length: two values, or a name that is not meant so. */
const contradicts = ({ type, count, loose }: TypeReading, length: number | undefined): boolean =>
  length !== undefined && !loose && !isTextType(type) && count === undefined && wordsOf(type) !== length;

const isNegative = (row: MapRow): boolean =>
  /^\s*[-−]\s*\d/.test(row.text('minimum')) || row.texts('range').some((text) => row.read.range(text)?.signed === true);

/** A whole number without a sign in its name has one if its minimum is negative. */
const signed = (type: ValueType, row: MapRow): ValueType =>
  type.startsWith('u') && isNegative(row) ? (type.replace('u', 'i') as ValueType) : type;

/** The most registers of a text whose end is told from the next register. */
const LONGEST_TEXT = 64;
const USUAL_TEXT = 8;

/** How many values a row has, and of a text how many registers; `room` is the distance to the next register. */
export function countOfRow(
  row: MapRow,
  { type, reading }: RowType,
  room: number | undefined,
  rules: TypeRules,
  doubts: RowDoubts,
): number {
  const length = lengthOf(row);
  const count = Number.parseInt(row.text('count'), 10);
  if (isTextType(type)) {
    const said = length ?? (count > 0 ? count : undefined);
    if (said !== undefined) return said;
    const inName = reading?.count;
    // A length that stands in brackets may be of characters or of registers: the next register shows which.
    if (inName !== undefined) return room === inName * 2 ? room : inName;
    if (room !== undefined && room > 1 && room <= LONGEST_TEXT) {
      doubts.notices.push('text-length-from-next');
      return room;
    }
    doubts.assumed.push('text-length');
    return rules.textLength ?? USUAL_TEXT;
  }
  if (reading?.count !== undefined) return reading.count;
  const gap = reading ? undefined : readGap(row.text('type'));
  if (gap !== undefined) return Math.max(1, gap);
  if (count > 0) return count;
  const words = wordsOf(type);
  // A length that reaches into the next register is not meant so.
  if (length !== undefined && room !== undefined && room < length && room >= words) return 1;
  return length !== undefined && length > words && length % words === 0 ? length / words : 1;
}
