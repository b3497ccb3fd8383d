import { isTextType, type Order, type ValueType } from '../../modbus/index.ts';
import type { TypeReading } from '../../notation/index.ts';
import { wordsOf } from '../codec.ts';
import { type Access, type EntityTable, isBitTable, isReadOnly, type NamedNumber, type Register } from '../profile.ts';
import { isFilled } from './cell-kinds.ts';
import { saysUnused } from './cell-words.ts';
import type { MapNoticeCode } from './codes.ts';
import type { MapRow } from './map-row.ts';
import type { AssumedPart, RowDoubts } from './row-doubts.ts';
import { bitOfRow, maskOfRow, namesOfRow } from './row-names.ts';
import { countOfRow, lengthOf, type TypeRules, typeOfRow } from './row-type.ts';
import { type RowScale, rowScale, type ScaleRules } from './scale.ts';
import { readOrderCell } from './type-cell.ts';

/** What has been decided for all rows. */
export interface RowRules extends TypeRules {
  readonly scale: ScaleRules;
  readonly order: Order;
  /** The file, or a person, says the order. */
  readonly orderKnown: boolean;
}

/** A register of one row, before bits are put together. */
export interface DraftRegister {
  readonly row: MapRow;
  readonly register: Register;
  readonly bit?: number;
  /** The name or the address of the register with the power of ten. */
  readonly scaleRegister?: string;
  readonly assumed: readonly AssumedPart[];
  readonly notices: readonly MapNoticeCode[];
}

/** Makes the register of a row whose table and address are known. `next` is the address of the register behind it. */
export function registerOf(
  row: MapRow,
  { table, address }: { readonly table: EntityTable; readonly address: number },
  rules: RowRules,
  next: number | undefined,
): DraftRegister {
  const doubts: RowDoubts = { notices: [], assumed: [] };
  const bitTable = isBitTable(table);
  const typed = typeOfRow(row, rules, bitTable, doubts);
  const scale = rowScale(row, rules.scale, typed.type.startsWith('f') || isTextType(typed.type));
  if (scale.doubtful) doubts.assumed.push('scale');
  doubts.notices.push(...scale.notices);
  const { names, bits, description } = namesOfRow(row, doubts);
  const isGroup = row.address.lastBit !== undefined && row.address.lastBit !== row.address.bit;
  const place = isGroup ? undefined : (row.address.bit ?? typed.reading?.bit ?? bitOfRow(row));
  const mask = place === undefined ? maskOfRow(row) : undefined;
  // A part of a register needs no type.
  if ((place !== undefined || mask !== undefined) && doubts.assumed.includes('type'))
    doubts.assumed.splice(doubts.assumed.indexOf('type'), 1);
  // `5.b8` of eight bits is the high byte of register 5.
  const byte = place === undefined ? undefined : byteAt(typed.type, place);
  const bit = byte ? undefined : place;
  const wide = !bits && !bitTable && areWideBits(typed.type, names, row.text('type'));
  if (wide) doubts.notices.push('names-as-bits');
  const isBits = !bitTable && (bits || wide || bit !== undefined);
  const type = byte ?? ((isBits && bitsType(typed.type)) || typed.type);
  if (saysUnused(row.text('name'))) doubts.notices.push('unused');
  if (row.open) doubts.notices.push('quote-open');
  const room = next === undefined ? undefined : next - address;
  const register: Register = {
    name: nameOf(row, doubts),
    table,
    address,
    type,
    order: orderOf(row, rules, typed.reading, wordsOf(type) > 1 && !bitTable, doubts),
    count: bitTable ? bitCount(row, typed.reading) : countOfRow(row, { ...typed, type }, room, rules, doubts),
    factor: scale.factor * (typed.factor ?? 1),
    offset: scale.offset,
    unit: scale.unit,
    ...decimalsOf(scale),
    access: accessOf(row, table, doubts),
    names,
    description,
    ...rareOf(row, mask),
  };
  return {
    row,
    register,
    ...(bit !== undefined && { bit }),
    ...(scale.register !== undefined && { scaleRegister: scale.register }),
    ...doubts,
  };
}

/**
 * Whether the names of a whole number of 32 or 64 bits are rather those of its bits: each has such a bit, and between them numbers
 * have no name, as in words of faults. Enumerations seldom need so many bits, and have their values in a row.
 */
function areWideBits(type: ValueType, names: readonly NamedNumber[], said: string): boolean {
  const numbers = names.map(({ number }) => number);
  const most = Math.max(-1, ...numbers);
  return (
    /^u(?:32|64)$/.test(type) &&
    !/enum/i.test(said) &&
    Math.min(0, ...numbers) === 0 &&
    most < 16 * wordsOf(type) &&
    most > names.length
  );
}

/** What few registers have; the same object for all that have nothing of it. */
function rareOf(row: MapRow, mask: number | undefined): Partial<Register> {
  const none = row.text('not-implemented');
  if (mask === undefined && none === '' && row.group === '' && row.models.length === 0) return NOTHING;
  return {
    ...(mask !== undefined && { mask }),
    ...(isFilled(none) && { notImplemented: none }),
    ...(row.group !== '' && { group: row.group }),
    ...(row.models.length > 0 && { models: row.models }),
  };
}

const NOTHING: Partial<Register> = Object.freeze({});

/** The type of bits that is as wide as a whole number; `undefined` for other types. */
export const bitsType = (type: ValueType): ValueType | undefined =>
  /^(?:[ui]|bits)/.test(type) ? ({ 1: 'bits', 2: 'bits32', 4: 'bits64' } as const)[wordsOf(type)] : undefined;

const BYTES: ReadonlyMap<string, ValueType> = new Map([
  ['u8l 0', 'u8l'],
  ['u8l 8', 'u8h'],
  ['i8l 0', 'i8l'],
  ['i8l 8', 'i8h'],
]);

const byteAt = (type: ValueType, bit: number): ValueType | undefined => BYTES.get(`${type} ${bit}`);

const bitCount = (row: MapRow, reading: TypeReading | undefined): number =>
  Math.max(1, Number.parseInt(row.text('count'), 10) || (reading?.count ?? lengthOf(row) ?? 1));

const decimalsOf = ({ decimals }: RowScale): { readonly decimals?: number } =>
  decimals === undefined ? {} : { decimals };

function nameOf(row: MapRow, { notices }: RowDoubts): string {
  const found = [row.text('name'), ...row.texts('other-name'), ...row.texts('description')].find(isFilled);
  if (found !== undefined) return found.replace(/\s+/g, ' ').trim();
  notices.push('name-missing');
  return row.printed;
}

function orderOf(
  row: MapRow,
  rules: RowRules,
  reading: TypeReading | undefined,
  wide: boolean,
  { notices, assumed }: RowDoubts,
): Order {
  const text = row.text('order');
  const own = isFilled(text) ? readOrderCell(text) : undefined;
  if (isFilled(text) && !own) notices.push('order-unknown');
  const order = own ?? reading?.order;
  if (order === undefined && wide && !rules.orderKnown) assumed.push('order');
  return order ?? (wide ? rules.order : 'ABCD');
}

function accessOf(row: MapRow, table: EntityTable, { notices }: RowDoubts): Access {
  const text = row.text('access');
  const found = isFilled(text) ? row.read.access(text) : undefined;
  if (isFilled(text) && !found) notices.push('access-unknown');
  if (!isReadOnly(table)) return found ?? 'rw';
  if (found && found !== 'r') notices.push('access-not-for-table');
  return 'r';
}
