import {
  compare,
  fraction,
  type NumberTypeName,
  numberTypes,
  type Order,
  type Padding,
  shortestFloat,
  type Value,
  type ValueType,
  type ValueWriting,
  writeValue,
} from '../../modbus/index.ts';
import { readExact } from './number-value.ts';
import { orderNames, paddingNames, plainName, typeNames } from './value-names.ts';

/** A place in the text: from the character `start` up to `end`. */
export interface ValuePlace {
  readonly start: number;
  readonly end: number;
}

/** What is worth knowing before a value is written. */
export type ValueNote =
  /** The type holds only `stored` instead of what was typed. */
  | { readonly code: 'precision-lost'; readonly typed: string; readonly stored: string }
  | { readonly code: 'not-finite'; readonly typed: string };

/** Why a piece of the text is no value. */
export type ValueFault =
  | { readonly code: 'value-missing' }
  /** Other values of this text have a type, this one has none. */
  | { readonly code: 'type-missing'; readonly typed: string }
  | { readonly code: 'name-unknown'; readonly name: string }
  | { readonly code: 'not-a-value'; readonly typed: string; readonly type: ValueType }
  /** Hexadecimal could be the bits of a float or its number. */
  | { readonly code: 'hex-float'; readonly typed: string }
  | { readonly code: 'quote-open' }
  | { readonly code: 'text-unquoted'; readonly typed: string }
  | { readonly code: 'refused'; readonly typed: string; readonly type: ValueType; readonly refusal: Refusal };

/** Why the type does not hold the value. */
type Refusal = Exclude<ValueWriting, { kind: 'registers' }>;

/** A value that was read, and the registers that hold it. */
export interface TypedValue {
  readonly place: ValuePlace;
  readonly type: ValueType;
  readonly order: Order;
  readonly value: Value;
  readonly registers: readonly number[];
  readonly notes: readonly ValueNote[];
}

export interface ValuesReading {
  readonly values: readonly TypedValue[];
  readonly faults: readonly PlacedFault[];
}

export interface PlacedFault {
  readonly place: ValuePlace;
  readonly fault: ValueFault;
}

/** Most values of a text that are read: more registers than any frame has. */
const MOST = 1000;

interface Word extends ValuePlace {
  readonly text: string;
}

/** What comes before the values of an item. */
interface Head {
  type?: ValueType;
  order?: Order;
  padding?: Padding;
  room?: number;
}

interface ItemHead {
  readonly head: Head;
  /** What follows the names. */
  readonly rest: readonly Word[];
  /** Whether it begins with a name that is not known. */
  readonly unknown: boolean;
}

/**
 * Reads values with their types and orders: `f32 CDAB 21.5`, `u16 4096`, `text[4] "PUMP"`, one a line or with commas or
 * semicolons between. Several numbers may follow a type: `i16 1 -2 3`. The order is ABCD where none is named, the type u16
 * where no value of the text has one. Orders and types go by many names (`REAL word swap 21.5`); `text[4]` fills up 4
 * registers and `STRING(8)` room for 8 characters, with `blank` by blanks.
 */
export function readValues(text: string): ValuesReading {
  const values: TypedValue[] = [];
  const faults: PlacedFault[] = [];
  const items = itemsOf(text);
  const heads = items.map(readHead);
  const typed = heads.some(({ head }) => head.type !== undefined);
  for (const [index, words] of items.entries()) {
    const { head, rest } = heads[index] as ItemHead;
    const whole = { start: (words[0] as Word).start, end: (words.at(-1) as Word).end };
    const wrong = headFault(heads[index] as ItemHead, typed, whole);
    if (wrong) faults.push(wrong);
    for (const word of wrong ? [] : rest) {
      if (values.length + faults.length >= MOST) break;
      const read = readOne(word, head);
      const place = { start: word.start, end: word.end };
      if ('code' in read) faults.push({ place, fault: read });
      else values.push({ place: rest.length === 1 ? whole : place, ...read });
    }
  }
  return { values, faults };
}

/** What is wrong with an item before its values are looked at; `typed` where another item has a type. */
function headFault({ head, rest, unknown }: ItemHead, typed: boolean, whole: ValuePlace): PlacedFault | undefined {
  const [first] = rest;
  const place = first ? { start: first.start, end: first.end } : whole;
  if (first === undefined) return { place, fault: { code: 'value-missing' } };
  if (unknown) return { place, fault: { code: 'name-unknown', name: first.text } };
  const untyped = head.type === undefined && typed && !first.text.startsWith('"');
  return untyped ? { place, fault: { code: 'type-missing', typed: first.text } } : undefined;
}

const WORD = /"(?:[^"\n]|"")*"?|[^\s,;"\n]+|[,;\n]/g;

/** The words of each item; commas, semicolons and line ends stand between items. */
function itemsOf(text: string): Word[][] {
  const items: Word[][] = [[]];
  for (const { 0: word, index } of text.matchAll(WORD)) {
    if (word === ',' || word === ';' || word === '\n') items.push([]);
    else items.at(-1)?.push({ text: word, start: index, end: index + word.length });
  }
  return items.filter((words) => words.length > 0);
}

/** Longest name in words: `little endian byte swapped`. */
const NAME_WORDS = 4;

/** Takes names off the beginning of an item, the longest each time. */
function readHead(words: readonly Word[]): ItemHead {
  const head: Head = {};
  let at = 0;
  while (at < words.length) {
    const taken = takeName(words, at, head);
    if (taken === 0) break;
    at += taken;
  }
  const rest = words.slice(at);
  const [next] = rest;
  const unknown = next !== undefined && head.type !== 'text' && /^[a-z_]{2}/i.test(next.text) && !isNumeric(next.text);
  return { head, rest, unknown };
}

const isNumeric = (text: string) => readExact(text) !== undefined || readSpecial(text) !== undefined;

function takeName(words: readonly Word[], at: number, head: Head): number {
  for (let many = Math.min(NAME_WORDS, words.length - at); many > 0; many--) {
    const name = words.slice(at, at + many).map(({ text }) => text);
    // What is written as a number or in quotes is the value: `int 16` is no int16.
    if (name.some((part) => part.startsWith('"') || readExact(part) !== undefined)) continue;
    if (takes(name.join(' '), head)) return many;
  }
  return 0;
}

/** Longer words are no names. */
const LONGEST_NAME = 60;

function takes(written: string, head: Head): boolean {
  if (written.length > LONGEST_NAME) return false;
  const [, name = '', inRegisters, inCharacters] =
    /^(.*?)\s*(?:\[\s*(\d{1,3})\s*\]|\(\s*(\d{1,3})\s*\))?\s*[:=]?$/.exec(written) ?? [];
  const room =
    inCharacters === undefined
      ? inRegisters === undefined
        ? undefined
        : Number(inRegisters)
      : Math.ceil(Number(inCharacters) / 2);
  const plain = plainName(name);
  const named = head.type === undefined ? typeNames.get(plain) : undefined;
  if (named) {
    if (room !== undefined && named.type !== 'text') return false;
    head.type = named.type;
    if (room !== undefined) head.room = room;
    if (named.order) head.order = named.order;
    return true;
  }
  if (room !== undefined) return false;
  const order = orderNames.get(plain);
  const padding = head.type === 'text' ? paddingNames.get(plain) : undefined;
  if (order) head.order = order;
  if (padding) head.padding = padding;
  return order !== undefined || padding !== undefined;
}

type ReadOne = Omit<TypedValue, 'place'> | ValueFault;

function readOne({ text }: Word, { type: named, order = 'ABCD', padding, room }: Head): ReadOne {
  if (text.startsWith('"')) {
    const type = named ?? 'text';
    if (!/^"(?:[^"]|"")*"$/.test(text) || text === '"') return { code: 'quote-open' };
    if (type !== 'text') return { code: 'not-a-value', typed: text, type };
    const value = text.slice(1, -1).replaceAll('""', '"');
    return written(value, text, type, order, writeValue(value, type, order, { registers: room, padding }));
  }
  const type = named ?? 'u16';
  if (type === 'text') return { code: 'text-unquoted', typed: text };
  const value = readFor(text, type);
  if (typeof value === 'object') return value;
  return written(value, text, type, order, writeValue(value, type, order));
}

function written(value: Value, typed: string, type: ValueType, order: Order, writing: ValueWriting): ReadOne {
  if (writing.kind !== 'registers') return { code: 'refused', typed, type, refusal: writing };
  return { type, order, value, registers: writing.registers, notes: notesOn(value, typed, type, writing.stored) };
}

function notesOn(value: Value, typed: string, type: ValueType, stored: Value): ValueNote[] {
  if (type === 'text' || numberTypes[type].kind !== 'float') return [];
  if (!Number.isFinite(Number(value))) return [{ code: 'not-finite', typed }];
  const text = shortestFloat(Number(stored), type);
  // Against the text: a double may have lost digits of it before the type is asked.
  const meant = readExact(typed)?.exactly;
  const kept = readExact(text)?.exactly;
  const same = meant !== undefined && kept !== undefined && compare(meant, kept) === 0;
  return same ? [] : [{ code: 'precision-lost', typed, stored: text }];
}

const SPECIAL: Readonly<Record<string, number>> = {
  nan: Number.NaN,
  inf: Infinity,
  infinity: Infinity,
  '∞': Infinity,
};

const readSpecial = (text: string): number | undefined => {
  const name = text.toLowerCase();
  const size = SPECIAL[name.replace(/^[-−+]/, '')];
  return size !== undefined && /^[-−]/.test(name) ? -size : size;
};

/** A number for a type: exact where it is whole. */
function readFor(text: string, type: NumberTypeName): number | bigint | ValueFault {
  const { kind, registers, least, most } = numberTypes[type];
  const special = readSpecial(text);
  if (special !== undefined) return special;
  const digits = text.replaceAll('_', '');
  // Bits are typed as they are shown, from the highest.
  if (kind === 'bits' && /^[01]{1,16}$/.test(digits)) return Number.parseInt(digits, 2);
  const read = readExact(text);
  if (read === undefined) return { code: 'not-a-value', typed: text, type };
  if (kind === 'float') {
    if (read.based) return { code: 'hex-float', typed: text };
    const got = Number(plainDecimal(text));
    return Number.isFinite(got)
      ? got
      : { code: 'refused', typed: text, type, refusal: { kind: 'out-of-range', got, least, most } };
  }
  const { numerator, denominator } = read.exactly;
  if (denominator !== 1n) {
    const got = Number(plainDecimal(text));
    return { code: 'refused', typed: text, type, refusal: { kind: 'not-whole', got } };
  }
  return registers === 4 ? numerator : safe(numerator);
}

const plainDecimal = (text: string) =>
  text
    .trim()
    .replaceAll('_', '')
    .replace('−', '-')
    .replace(/^([-+])\s+/, '$1');

/** A number where it is one exactly, else a bigint: both are compared with limits alike. */
const safe = (value: bigint): number | bigint =>
  compare(fraction(value), fraction(Number.MAX_SAFE_INTEGER)) <= 0 && value >= -BigInt(Number.MAX_SAFE_INTEGER)
    ? Number(value)
    : value;
