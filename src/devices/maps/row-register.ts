import { isNumberType, isTextType, type Order, type ValueType } from '../../modbus/index.ts';
import type { TypeReading } from '../../notation/index.ts';
import { wordsOf } from '../codec.ts';
import { fromOldMeaning } from '../line-scale.ts';
import { type Access, type EntityTable, isBitTable, isReadOnly, type NamedNumber, type Register } from '../profile.ts';
import { isFilled, isRange } from './cell-kinds.ts';
import { accessNamed, saysUnused } from './cell-words.ts';
import type { MapNoticeCode } from './codes.ts';
import type { MapRow } from './map-row.ts';
import { readNamesCell, readPairs } from './names-cell.ts';
import { type RowScale, rowScale, type ScaleRules } from './scale.ts';
import { readGap, readOrderCell, readTypeCell } from './type-cell.ts';

/** What has been decided for all rows. */
export interface RowRules {
  readonly scale: ScaleRules;
  readonly type: ValueType;
  readonly order: Order;
  /** The file, or a person, says the order. */
  readonly orderKnown: boolean;
  readonly codes: ReadonlyMap<string, { readonly type: ValueType; readonly factor: number }>;
  readonly textLength: number | undefined;
  /** The table was written here before scales had the meaning of the field. */
  readonly old: boolean;
}

/** A register of one row, before bits are put together. */
export interface DraftRegister {
  readonly row: MapRow;
  readonly register: Register;
  readonly bit?: number;
  readonly lastBit?: number;
  readonly bool: boolean;
  readonly scaleRegister?: string;
  /** Nothing says the type, the order, how long a text is. */
  readonly assumed: ReadonlySet<'type' | 'order' | 'text-length' | 'scale' | 'decimals'>;
  readonly notices: readonly MapNoticeCode[];
}

const asTyped = (type: ValueType): boolean => !isNumberType(type);
const PROSE = 3;

/** Makes the register of a row whose table and address are known. `next` is the address of the register behind it. */
export function registerOf(
  row: MapRow,
  place: { readonly table: EntityTable; readonly address: number },
  rules: RowRules,
  next: number | undefined,
): DraftRegister {
  const notices: MapNoticeCode[] = [];
  const assumed = new Set<'type' | 'order' | 'text-length' | 'scale' | 'decimals'>();
  const { table, address } = place;
  const bitTable = isBitTable(table);
  const length = lengthOf(row);
  const typed = typeOf(row, rules, length, bitTable, assumed, notices);
  const { reading } = typed;
  const isBool = /^(?:bool(?:ean)?|bit|binary|digital|布尔)\b/i.test(row.text('type').trim());
  let type = typed.type;
  const scale = rowScale(row, rules.scale, type.startsWith('f') || asTyped(type));
  const code = rules.codes.get(row.text('type').trim());
  if (scale.doubtful) assumed.add('scale');
  for (const unread of scale.unread) notices.push(`${unread}-unreadable`);
  const { names, bits, description } = namesOf(row, notices);
  const inner = bitIn(row);
  const bit = row.address.bit ?? reading?.bit ?? inner?.bit;
  const isBits = !bitTable && (bits || bit !== undefined);
  if (isBits && wordsOf(type) === 1 && !asTyped(type)) type = 'bits';
  const order = orderOf(row, rules, reading, wordsOf(type) > 1 && !bitTable, assumed, notices);
  const count = countOf(
    row,
    type,
    reading,
    length,
    next === undefined ? undefined : next - address,
    rules,
    assumed,
    notices,
  );
  if (saysUnused(row.text('name'))) notices.push('unused');
  if (row.open) notices.push('quote-open');
  const name = nameOf(row, notices);
  const scaled = { factor: scale.factor * (code?.factor ?? 1), offset: scale.offset };
  const register: Register = {
    name,
    table,
    address,
    type: bitTable ? 'bits' : type,
    order,
    count: bitTable ? Math.max(1, reading?.count ?? length ?? 1) : count,
    ...scaled,
    unit: scale.unit,
    ...decimalsOf(scale),
    access: accessOf(row, table, notices),
    names,
    description,
    ...(row.group === '' ? {} : { group: row.group }),
    ...(row.models.length === 0 ? {} : { models: row.models }),
  };
  return {
    row,
    register: rules.old ? fromOldMeaning(register) : register,
    bool: isBool,
    ...(bit === undefined ? {} : { bit }),
    ...(row.address.lastBit === undefined ? {} : { lastBit: row.address.lastBit }),
    ...(scale.register ? { scaleRegister: scale.register } : {}),
    assumed,
    notices,
  };
}

const decimalsOf = ({ decimals }: RowScale): { readonly decimals?: number } =>
  decimals === undefined ? {} : { decimals };

function nameOf(row: MapRow, notices: MapNoticeCode[]): string {
  const found = [row.text('name'), ...row.texts('other-name'), ...row.texts('description')].find(isFilled);
  if (found !== undefined) return found.replace(/\s+/g, ' ').trim();
  notices.push('name-missing');
  return row.printed;
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
  const end = Number.parseInt(row.text('end').replace(/^0x/i, ''), /^0x/i.test(row.text('end')) ? 16 : 10);
  return end >= number && end - number < 1000 ? end - number + 1 : undefined;
}

const PLAIN: Readonly<Record<number, ValueType>> = { 1: 'u16', 2: 'u32', 4: 'u64' };

function typeOf(
  row: MapRow,
  rules: RowRules,
  length: number | undefined,
  bitTable: boolean,
  assumed: Set<string>,
  notices: MapNoticeCode[],
): { readonly type: ValueType; readonly reading?: TypeReading } {
  const text = row.text('type');
  const code = rules.codes.get(text.trim());
  if (code) return { type: code.type };
  const reading = readTypeCell(text, length);
  if (reading) {
    if (bitTable) return { type: 'bits', reading };
    const contradicts =
      length !== undefined &&
      !isTextType(reading.type) &&
      reading.count === undefined &&
      wordsOf(reading.type) !== length &&
      length % wordsOf(reading.type) !== 0;
    if (contradicts) notices.push('length-contradicts');
    return { type: signedByRange(reading, row), reading };
  }
  if (bitTable) return { type: 'bits' };
  if (isFilled(text) && readGap(text) === undefined) notices.push('type-unknown');
  const isSigned = /^\s*[-−]\s*\d/.test(row.text('minimum')) || /^\s*[-−]\s*\d/.test(row.text('range'));
  const plain = length === undefined ? undefined : PLAIN[length];
  if (plain && length !== 1) {
    notices.push('type-from-length');
    return { type: isSigned ? (plain.replace('u', 'i') as ValueType) : plain };
  }
  if (isSigned) return { type: 'i16' };
  if (!isFilled(text) && length === undefined) assumed.add('type');
  return { type: length === 1 ? 'u16' : rules.type };
}

/** A whole number without a sign in its name has one if its minimum is negative. */
function signedByRange({ type, loose }: TypeReading, row: MapRow): ValueType {
  const negative = /^\s*[-−]\s*\d/.test(row.text('minimum')) || /^\s*[-−]\s*\d/.test(row.text('range'));
  return loose && negative && type.startsWith('u') ? (type.replace('u', 'i') as ValueType) : type;
}

function orderOf(
  row: MapRow,
  rules: RowRules,
  reading: TypeReading | undefined,
  wide: boolean,
  assumed: Set<string>,
  notices: MapNoticeCode[],
): Order {
  const text = row.text('order');
  const own = isFilled(text) ? readOrderCell(text) : undefined;
  if (isFilled(text) && !own) notices.push('order-unknown');
  const order = own ?? reading?.order;
  if (order === undefined && wide && !rules.orderKnown) assumed.add('order');
  return order ?? (wide ? rules.order : 'ABCD');
}

function countOf(
  row: MapRow,
  type: ValueType,
  reading: TypeReading | undefined,
  length: number | undefined,
  room: number | undefined,
  rules: RowRules,
  assumed: Set<string>,
  notices: MapNoticeCode[],
): number {
  const count = Number.parseInt(row.text('count'), 10);
  if (isTextType(type)) {
    if (length !== undefined) return length;
    const said = reading?.count;
    // A length that stands in brackets may be of characters or of registers: the next register shows which.
    if (said !== undefined) return room === said * 2 || room === said ? room : said;
    if (room !== undefined && room > 1 && room <= 64) {
      notices.push('text-length-from-next');
      return room;
    }
    assumed.add('text-length');
    return rules.textLength ?? 8;
  }
  const gap = readGap(row.text('type'));
  if (reading?.count !== undefined) return reading.count;
  if (gap !== undefined && !reading) return Math.max(1, gap);
  if (count > 0) return count;
  const words = wordsOf(type);
  return length !== undefined && length > words && length % words === 0 ? length / words : 1;
}

function accessOf(row: MapRow, table: EntityTable, notices: MapNoticeCode[]): Access {
  const text = row.text('access');
  const found = isFilled(text) ? accessNamed(text) : undefined;
  if (isFilled(text) && !found) notices.push('access-unknown');
  if (!isReadOnly(table)) return found ?? 'rw';
  if (found && found !== 'r') notices.push('access-not-for-table');
  return 'r';
}

/** `Pump runs [bit 4]`, a column of bits, a mask of one bit. */
function bitIn(row: MapRow): { readonly bit: number } | undefined {
  const column = /^(?:bit|b)?\s*(\d{1,2})$/i.exec(row.text('bit').trim());
  if (column) return { bit: Number(column[1]) };
  const mask = row.text('mask');
  const value = /^(?:0x[\da-f]+|\d+)$/i.test(mask) ? Math.log2(Number(mask)) : Number.NaN;
  if (Number.isInteger(value)) return { bit: value };
  const named = /[[(]\s*bit\s*[:#.]?\s*(\d{1,2})\s*[\])]/i.exec(row.text('name'));
  return named ? { bit: Number(named[1]) } : undefined;
}

/** The names of values or bits of a row and those of the rows below it, and the texts that describe it. */
function namesOf(
  row: MapRow,
  notices: MapNoticeCode[],
): { readonly names: readonly NamedNumber[]; readonly bits: boolean; readonly description: string } {
  const names: NamedNumber[] = [];
  let bits = false;
  const description = row.texts('description').filter((text) => text !== row.text('name'));
  for (const text of [...row.texts('names'), row.text('unit')]) {
    const read = readNamesCell(text);
    if (read.names.length > 0 && !isRange(text)) {
      names.push(...named(read));
      bits ||= read.bits === true || read.masks === true;
      if (read.rest !== '') {
        notices.push('names-rest');
        description.push(read.rest);
      }
    } else if (text !== '' && row.texts('names').includes(text)) {
      notices.push(isRange(text) ? 'range-kept' : 'names-rest');
      description.push(text);
    }
  }
  for (const text of row.texts('range')) {
    if (text === '') continue;
    notices.push('range-kept');
    description.push(text);
  }
  if (names.length === 0)
    for (const text of [...row.texts('description'), row.text('name'), row.text('type')]) {
      const read = readPairs(text);
      const clean =
        read.names.length > 1 &&
        read.names.every(({ name }) => name.split(/\s+/).length <= PROSE * 2) &&
        read.rest.length < 60;
      if (!clean) continue;
      names.push(...named(read));
      bits ||= read.bits === true || read.masks === true;
      break;
    }
  const numbers = row.parts.flatMap(({ number }) => number ?? []);
  const masks =
    numbers.length > 3 &&
    numbers.includes(4) &&
    !numbers.includes(3) &&
    numbers.every((number) => Number.isInteger(Math.log2(number)));
  for (const part of row.parts) {
    if (part.bit !== undefined) names.push({ number: part.bit, name: part.name });
    else if (part.number !== undefined)
      names.push({ number: masks ? Math.log2(part.number) : part.number, name: part.name });
  }
  bits ||= masks || row.parts.some(({ bit }) => bit !== undefined);
  if (new Set(names.map(({ number }) => number)).size < names.length) notices.push('names-twice');
  return {
    names: names.filter(({ number }) => Number.isSafeInteger(number)),
    bits,
    description: description.join('\n'),
  };
}

const named = ({
  names,
  masks,
}: {
  readonly names: readonly NamedNumber[];
  readonly masks?: true;
}): readonly NamedNumber[] => (masks ? names.map(({ number, name }) => ({ number: Math.log2(number), name })) : names);
