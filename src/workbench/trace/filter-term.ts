import type { EntityTable } from '../../devices/index.ts';
import { dictionary } from '../../modbus/index.ts';
import { type AddressNotation, entityNumber, formatHex, readAddress, readNumber } from '../../notation/index.ts';
import { isCauseCode } from '../../trace/index.ts';
import { momentText, readMoment, type WrittenMoment } from './moment.ts';
import { type SeenFault, seenFaults } from './seen-fault.ts';

/** What numbers a term compares: the reply time `slow` in milliseconds, `value` any register or bit of a frame. */
export const numberTerms = ['unit', 'fc', 'exception', 'value', 'slow'] as const;
export type NumberTerm = (typeof numberTerms)[number];

/** All terms that have a value behind them. */
export const filterTerms = [...numberTerms, 'addr', 'conn', 'text', 'from', 'to', 'cause'] as const;
export type FilterTermName = (typeof filterTerms)[number];

/** The words that stand alone, and the faults that they find; `fault` finds all. */
export const faultWords: ReadonlyMap<string, SeenFault | 'any'> = new Map<string, SeenFault | 'any'>([
  ['fault', 'any'],
  ['crc', 'checksum'],
  ...seenFaults.map((kind) => [kind, kind] as const),
]);

export type Comparison = '<' | '<=' | '>' | '>=';

/** From the first to the last, both of them included. */
export type Range = readonly [least: number, most: number];

/** Addresses as sent, of one table or of any. */
export interface FilterAddresses {
  readonly table: EntityTable | undefined;
  readonly first: number;
  readonly last: number;
}

/** One term of a filter. */
export type FilterTerm = { readonly not: boolean } & Asked;
type Asked =
  | { readonly is: 'fault'; readonly kind: SeenFault | 'any' }
  | { readonly is: 'among'; readonly of: NumberTerm; readonly ranges: readonly Range[] }
  | { readonly is: 'compared'; readonly of: NumberTerm; readonly by: Comparison; readonly than: number }
  | { readonly is: 'address'; readonly ranges: readonly FilterAddresses[] }
  | { readonly is: 'text' | 'connection'; readonly text: string }
  | { readonly is: 'time'; readonly bound: 'from' | 'to'; readonly moment: WrittenMoment }
  | { readonly is: 'cause'; readonly codes: readonly string[] };

/** What is wrong with a term, and where it stands in the text. `got` is what was written. */
export type FilterMistake = TermMistake & { readonly from: number; readonly to: number };
export type TermMistake =
  /** A term of a name that there is not; `meant` is the one it resembles. */
  | { readonly code: 'not-known'; readonly got: string; readonly meant: FilterTermName | undefined }
  | { readonly code: 'value-missing'; readonly term: FilterTermName }
  | { readonly code: 'not-a-number'; readonly got: string }
  | { readonly code: 'out-of-range'; readonly got: number; readonly least: number; readonly most: number }
  | { readonly code: 'range-reversed'; readonly got: string }
  | { readonly code: 'not-an-address'; readonly got: string }
  /** The two ends of a range are of two tables. */
  | { readonly code: 'tables-differ'; readonly got: string }
  | { readonly code: 'not-a-time'; readonly got: string }
  | { readonly code: 'not-a-cause'; readonly got: string }
  /** `addr>5`: the term knows no comparison. */
  | { readonly code: 'not-compared'; readonly term: FilterTermName }
  | { readonly code: 'quote-open' }
  /** A `not` or `-` with nothing behind it. */
  | { readonly code: 'nothing-excluded' };

/** Legal numbers of each term; a number of a value is one that is printed without an exponent. */
const LARGEST = 1e20;
const limits: Readonly<Record<NumberTerm, Range>> = {
  unit: [0, 255],
  fc: [0, 255],
  exception: [0, 255],
  value: [-LARGEST, LARGEST],
  slow: [0, LARGEST],
};
const isWhole = (term: NumberTerm) => term === 'unit' || term === 'fc' || term === 'exception';

const TERM = /^([a-z][a-z-]*)(:|<=|>=|<|>|=)(.*)$/is;
const RANGE = /^([-−+]?[^-–−]+)[-–]([-−+]?[^-–−]+)$/;

/** Reads a term without its `-`; its quotes are still there. */
export function readTerm(written: string): Asked | TermMistake {
  const [, name = '', mark = '', value = ''] = TERM.exec(written) ?? [];
  const lower = (name || written).toLowerCase();
  const term = filterTerms.find((one) => one === lower);
  if (name === '') {
    const kind = faultWords.get(lower);
    if (kind !== undefined) return { is: 'fault', kind };
    if (term !== undefined) return { code: 'value-missing', term };
    return textTerm(written);
  }
  if (term === undefined) return { code: 'not-known', got: name, meant: nearest(lower) };
  if (value === '') return { code: 'value-missing', term };
  const number = numberTerms.find((one) => one === term);
  if (mark !== ':' && mark !== '=') {
    return number === undefined ? { code: 'not-compared', term } : compared(number, mark as Comparison, value);
  }
  if (number !== undefined) return among(number, value);
  if (term === 'addr') return address(value);
  if (term === 'text') return textTerm(value);
  if (term === 'conn') return textTerm(value, 'connection');
  if (term === 'cause') return causes(value);
  const moment = readMoment(value);
  return moment === undefined
    ? { code: 'not-a-time', got: value }
    : { is: 'time', bound: term === 'to' ? 'to' : 'from', moment };
}

export const isMistake = (read: Asked | TermMistake): read is TermMistake => 'code' in read;

function textTerm(written: string, is: 'text' | 'connection' = 'text'): Asked | TermMistake {
  const text = unquoted(written);
  return text === undefined ? { code: 'quote-open' } : { is, text };
}

/** A text without its quotes; within them `\` takes the next character as it is. `undefined` if a quote is not closed. */
function unquoted(written: string): string | undefined {
  let inside = false;
  let text = '';
  for (let at = 0; at < written.length; at++) {
    const character = written.charAt(at);
    if (character === '"') inside = !inside;
    else if (inside && character === '\\' && at + 1 < written.length) text += written.charAt(++at);
    else text += character;
  }
  return inside ? undefined : text;
}

function causes(list: string): Asked | TermMistake {
  const codes = list.toLowerCase().split(',');
  const got = codes.find((code) => !isCauseCode(code));
  return got === undefined ? { is: 'cause', codes } : { code: 'not-a-cause', got };
}

function numberIn(term: NumberTerm, got: string): number | TermMistake {
  const value = readNumber(got);
  if (value === undefined || (isWhole(term) && !Number.isInteger(value))) return { code: 'not-a-number', got };
  const [least, most] = limits[term];
  if (value < least || value > most) return { code: 'out-of-range', got: value, least, most };
  // Such a number has no decimal notation that is read again.
  return String(value).includes('e') ? { code: 'not-a-number', got } : value + 0;
}

function compared(of: NumberTerm, by: Comparison, got: string): Asked | TermMistake {
  const than = numberIn(of, got);
  return typeof than === 'number' ? { is: 'compared', of, by, than } : than;
}

function among(of: NumberTerm, list: string): Asked | TermMistake {
  const ranges: Range[] = [];
  for (const got of list.split(',')) {
    const [, first = got, last = first] = RANGE.exec(got) ?? [];
    const [least, most] = [numberIn(of, first), numberIn(of, last)];
    if (typeof least !== 'number') return least;
    if (typeof most !== 'number') return most;
    if (least > most) return { code: 'range-reversed', got };
    ranges.push([least, most]);
  }
  return { is: 'among', of, ranges };
}

function address(list: string): Asked | TermMistake {
  const ranges: FilterAddresses[] = [];
  for (const got of list.split(',')) {
    const [, one = got, other = one] = RANGE.exec(got) ?? [];
    const [from, to] = [addressIn(one), addressIn(other)];
    if (from === undefined || to === undefined)
      return { code: 'not-an-address', got: from === undefined ? one : other };
    if (from.table !== to.table) return { code: 'tables-differ', got };
    if (from.first > to.first) return { code: 'range-reversed', got };
    ranges.push({ ...from, last: to.first });
  }
  return { is: 'address', ranges };
}

/** What a number means, the likeliest first: with the digit of its table it is that of a manual, without it is as sent. */
const MEANS: readonly AddressNotation[] = ['five-digit', 'six-digit', 'hex', 'decimal', 'letters', 'prefix', 'iec'];

function addressIn(text: string): Omit<FilterAddresses, 'last'> | undefined {
  const meanings = readAddress(text);
  for (const notation of MEANS) {
    for (const { table, address, notation: other } of meanings) {
      if (other === notation && table !== 'file-record') return { table, first: address };
    }
  }
  return undefined;
}

/** What others call a term. */
const ALIASES: Readonly<Record<string, FilterTermName | undefined>> = dictionary({
  function: 'fc',
  address: 'addr',
  connection: 'conn',
  code: 'exception',
  id: 'unit',
  slave: 'unit',
});

/** The term whose name differs in the fewest letters; `undefined` if all differ in many. */
function nearest(name: string): FilterTermName | undefined {
  const alias = ALIASES[name];
  if (alias !== undefined) return alias;
  return filterTerms.find(
    (term) => term.startsWith(name) || name.startsWith(term) || sameLetters(name, term) || isOneOff(name, term),
  );
}

/** Whether a letter is missing in one of them, or is another one. */
function isOneOff(one: string, other: string): boolean {
  const [short, long] = one.length < other.length ? [one, other] : [other, one];
  let at = 0;
  while (at < short.length && short[at] === long[at]) at++;
  if (short.length < LONG_NAME || long.length - short.length > 1) return false;
  return short.slice(long.length === short.length ? at + 1 : at) === long.slice(at + 1);
}

/** Shorter names differ from too many others in one letter only. */
const LONG_NAME = 3;

const sameLetters = (one: string, other: string) =>
  one.length === other.length && [...one].sort().join('') === [...other].sort().join('');

/** A term as it is written, so that it is read as the same. */
export function termText(term: FilterTerm): string {
  return (term.not ? '-' : '') + askedText(term);
}

function askedText(term: FilterTerm): string {
  const range = (first: string, last: string) => (first === last ? first : `${first}-${last}`);
  switch (term.is) {
    case 'fault':
      return term.kind === 'any' ? 'fault' : term.kind === 'checksum' ? 'crc' : term.kind;
    case 'among':
      return `${term.of}:${term.ranges.map(([least, most]) => range(String(least), String(most))).join(',')}`;
    case 'compared':
      return `${term.of}${term.by}${term.than}`;
    case 'address':
      return `addr:${term.ranges.map((one) => range(addressText(one, one.first), addressText(one, one.last))).join(',')}`;
    case 'text':
    case 'connection':
      return `${term.is === 'text' ? 'text' : 'conn'}:"${term.text.replace(/["\\]/g, '\\$&')}"`;
    case 'time':
      return `${term.bound}:${momentText(term.moment)}`;
    case 'cause':
      return `cause:${term.codes.join(',')}`;
  }
}

/** The number of a manual, or the address as sent, which is written so that it is not taken for one. */
export function addressText({ table }: Pick<FilterAddresses, 'table'>, address: number): string {
  if (table !== undefined) return entityNumber(table, address);
  const decimal = String(address);
  return addressIn(decimal)?.table === undefined ? decimal : formatHex(address, 4);
}
