import { hexDigits, isTextType } from '../modbus/index.ts';
import { entityNumber, sixDigitNumber } from '../notation/index.ts';
import { wordsOf } from './codec.ts';
import { type Convention, type EntityTable, isBitTable, type Profile, type Register } from './profile.ts';
import { countsValues } from './traits.ts';

const LISTED = /^(.*)\[(\d+)\]$/;
const SERIES = /\{([\dA-F]+)(h?)\+(\d+)n\}/;

/** How the manual prints the address of an element. */
export function printedNumber(convention: Convention, table: EntityTable, address: number): string {
  switch (convention) {
    case 'zero-based':
      return String(address);
    case 'one-based':
      return String(address + 1);
    case 'five-digit':
      return entityNumber(table, address);
    case 'six-digit':
      return sixDigitNumber(table, address);
  }
}

/** Addresses that one value of a line takes. Where each value counts as one, that is one. */
export const stepOf = ({ type, table }: Register, profile: Profile): number =>
  isBitTable(table) || countsValues(profile) ? 1 : wordsOf(type);

/** Addresses that a line takes in all. */
export const addressesOf = (register: Register, profile: Profile): number => register.count * stepOf(register, profile);

/** How many values a line has: text is one, however long. */
export const valuesOf = ({ type, count }: Register): number => (isTextType(type) ? 1 : count);

/** The name of one value of a line, by its index from 0. */
export function valueName(register: Register, index: number): string {
  const { name } = register;
  const found = SERIES.exec(name);
  if (found === null) return valuesOf(register) === 1 ? name : `${name} [${index + 1}]`;
  const [series, first = '', hex, step] = found;
  const base = hex ? 16 : 10;
  const number = Number.parseInt(first, base) + index * Number(step);
  return name.replace(series, hex ? hexDigits(number, first.length) : String(number).padStart(first.length, '0'));
}

/** The name of a line as a whole. */
export function lineName(register: Register): string {
  const last = valuesOf(register) - 1;
  return SERIES.test(register.name) && last > 0
    ? `${valueName(register, 0)} … ${valueName(register, last)}`
    : register.name;
}

/** A name however it is typed: `VW 804` and `vw804` are one. */
export const plainName = (text: string): string => text.replace(/\s+/g, '').toLowerCase();

/** The names of a line as a whole: all of its name, and the code with which that begins, such as P0683. */
export function plainNames({ name }: Register): readonly string[] {
  const code = /^\s*([^\s\d]+\d+)(?!\S)/.exec(name)?.[1];
  return code === undefined ? [plainName(name)] : [plainName(name), plainName(code)];
}

/** What stands in front of the number of a series; `undefined` for a line that is not one. */
export function seriesStart({ name }: Register): string | undefined {
  const found = SERIES.exec(name);
  return found === null ? undefined : plainName(name.slice(0, found.index));
}

/** The name of the line in `name[2]`. */
export const listName = (text: string): string | undefined => LISTED.exec(text)?.[1];

/** Which value of a line has a name, by its index from 0. */
export function indexOfName(register: Register, wanted: string): number | undefined {
  const found = SERIES.exec(register.name);
  const text = plainName(wanted);
  if (found === null) return indexInList(register, text);
  const [series, first = '', hex, step] = found;
  const before = plainName(register.name.slice(0, found.index));
  const after = plainName(register.name.slice(found.index + series.length));
  if (!text.startsWith(before) || !text.endsWith(after) || text.length <= before.length + after.length)
    return undefined;
  const digits = text.slice(before.length, text.length - after.length);
  if (!(hex ? /^[\da-f]+$/ : /^\d+$/).test(digits)) return undefined;
  const base = hex ? 16 : 10;
  const index = (Number.parseInt(digits, base) - Number.parseInt(first, base)) / Number(step);
  return Number.isInteger(index) && index >= 0 && index < valuesOf(register) ? index : undefined;
}

/** For a line that is not a series: `name [2]`. */
function indexInList(register: Register, text: string): number | undefined {
  const [, called = '', number] = LISTED.exec(text) ?? [];
  const index = Number(number) - 1;
  return isCalled(register, called) && index >= 0 && index < valuesOf(register) ? index : undefined;
}

/** Whether a line has this name, or begins with it if it is a code such as P0683. */
export function isCalled(register: Register, wanted: string): boolean {
  const text = plainName(wanted);
  return text !== '' && plainNames(register).includes(text);
}
