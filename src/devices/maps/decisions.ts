import type { Order, ValueType } from '../../modbus/index.ts';
import { valueTypes } from '../codec.ts';
import { type EntityTable, entityTables } from '../profile.ts';
import { isFilled } from './cell-kinds.ts';
import { digitTables, tableOfFunctions } from './cell-words.ts';
import type { MapRow } from './map-row.ts';
import { readScaleCell } from './scale-cell.ts';
import { readTypeCell } from './type-cell.ts';

/** Answers by the code of their question. */
export type Answers = Readonly<Record<string, string>>;

/** What 3 and 4 mean in a column of tables. */
export type DigitMeaning = 'function' | 'digit';

/** Whether the cells that name tables are only numbers that may be digits or function codes: 3 and 4, and 1. */
export function digitDoubt(
  rows: readonly MapRow[],
  answer: string | undefined,
): { readonly meaning: DigitMeaning; readonly asked: boolean } {
  if (answer === 'function' || answer === 'digit') return { meaning: answer, asked: false };
  const texts = new Set(rows.map((row) => row.text('table').trim()).filter((text) => /^\d{1,2}$/.test(text)));
  if (texts.size === 0) return { meaning: 'digit', asked: false };
  if (texts.has('0')) return { meaning: 'digit', asked: false };
  if ([...texts].some((text) => /^(?:0\d|2|5|6|15|16)$/.test(text))) return { meaning: 'function', asked: false };
  return { meaning: 'function', asked: true };
}

/** The table that the cells of a row name; `unread` is a text that names none. */
export function tableOfRow(
  row: MapRow,
  digits: DigitMeaning,
): { readonly table?: EntityTable; readonly unread?: true } {
  const text = row.text('table');
  const called = row.text('function');
  const read = (table: EntityTable | undefined) => (table ? { table } : undefined);
  if (isFilled(text) || /^0$/.test(text)) {
    const digit = /^([0134])[xX]*$/.exec(text);
    const isBare = /^\d+$/.test(text);
    const found =
      isBare && digits === 'function' ? undefined : digit ? digitTables.get(digit[1] as string) : row.read.table(text);
    const codes = found ? undefined : row.read.functions(text);
    const own = read(found ?? (codes && (tableOfFunctions(codes) ?? tableOfReads(codes))));
    if (own) return own;
    if (!isFilled(called)) return row.table ? { table: row.table } : { unread: true };
  }
  if (isFilled(called)) {
    const codes = row.read.functions(called);
    const own = read(codes ? (tableOfFunctions(codes) ?? tableOfReads(codes)) : row.read.table(called));
    return own ?? { unread: true };
  }
  return row.table ? { table: row.table } : {};
}

/** Of functions of several tables, those that read say it; of `3, 4` none does. */
const tableOfReads = (codes: readonly number[]): EntityTable | undefined =>
  tableOfFunctions(codes.filter((code) => code < 5));

/** The table for rows that name none. */
export function usualTable(rows: readonly MapRow[], answer: string | undefined): EntityTable {
  const answered = entityTables.find((table) => table === answer);
  if (answered) return answered;
  const bools = rows.filter((row) => /^(?:bool(?:ean)?|bit|coil)$/i.test(row.text('type').trim()));
  return rows.length > 0 && bools.length === rows.length && rows.every(({ address }) => address.bit === undefined)
    ? 'coil'
    : 'holding-register';
}

/** The type of rows that name none: two registers if the addresses go in steps of two. */
export function usualType(
  rows: readonly MapRow[],
  answer: string | undefined,
): { readonly type: ValueType; readonly options: readonly ValueType[] } {
  const numbers = rows.map(({ address }) => address.number);
  const steps = numbers.slice(1).map((number, place) => number - (numbers[place] ?? 0));
  const even =
    steps.length > 1 && steps.every(isEvenStep) && steps.filter((step) => step === 2).length >= steps.length / 2;
  const isScaled = rows.some((row) => isFilled(row.text('exponent')) || isFilled(row.text('divisor')));
  const options: readonly ValueType[] =
    even && !isScaled ? ['f32', 'u32', 'i32', 'u16', 'i16'] : ['u16', 'i16', 'u32', 'i32', 'f32'];
  const answered = valueTypes.find((type) => type === answer);
  return { type: answered ?? (options[0] as ValueType), options };
}

const isEvenStep = (step: number): boolean => step > 0 && step % 2 === 0;

/** A maker's own codes for types, in the order of their first rows. */
export function typeCodes(rows: readonly MapRow[]): ReadonlyMap<string, MapRow> {
  const codes = new Map<string, MapRow>();
  let known = 0;
  for (const row of rows) {
    const text = row.text('type').trim();
    if (!isFilled(text)) continue;
    if (row.read.type(text)) known++;
    else if (/^\S{1,6}$/.test(text) && /^(?:\d{1,3}|[A-Za-z]\d{0,3}|[A-Za-z]{1,3}\d?)$/.test(text) && !codes.has(text))
      codes.set(text, row);
  }
  return known > codes.size || codes.size > 20 ? new Map() : codes;
}

/** What an answer says of the codes: `2=u16; 6=i16/10; 7=u32`. */
export function readTypeCodes(
  answer: string,
): ReadonlyMap<string, { readonly type: ValueType; readonly factor: number }> {
  const found = new Map<string, { readonly type: ValueType; readonly factor: number }>();
  for (const part of answer.split(/[;\n]/)) {
    const [, code = '', name = '', scale = ''] =
      /^\s*([^=\s]+)\s*=\s*([\w()[\] -]*?)\s*([/*x×]\s*[\d.,]+)?\s*$/.exec(part) ?? [];
    const type = valueTypes.find((each) => each === name.toLowerCase()) ?? readTypeCell(name)?.type;
    if (type) found.set(code, { type, factor: readScaleCell(scale)?.number ?? 1 });
  }
  return found;
}

export const orderOptions: readonly Order[] = ['ABCD', 'CDAB', 'BADC', 'DCBA'];
