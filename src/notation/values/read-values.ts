import { isNumberType, isTextType } from '../../modbus/index.ts';
import type { TextRange } from '../read-bytes/index.ts';
import { type ValuesNotice, withPoints } from './commas.ts';
import { readExact } from './number-value.ts';
import { type Head, isNumeric, readOne, readWithUnit, type TypedValue, type ValueFault } from './typed-value.ts';
import { scaleOfUnit, type UnitScale, type UnitsAt } from './units.ts';
import { orderNames, paddingNames, plainName, typeNames } from './value-names.ts';

/** A value and where it stands. */
export interface PlacedValue extends TypedValue {
  readonly place: TextRange;
}

export interface ValuesReading {
  readonly values: readonly PlacedValue[];
  readonly faults: readonly PlacedFault[];
  /** Numbers that may be read in another way. */
  readonly notices: readonly ValuesNotice[];
}

export interface PlacedFault {
  readonly place: TextRange;
  readonly fault: ValueFault;
}

/** Most values of a text that are read: more registers than any frame has. */
const MOST = 1000;

interface Word extends TextRange {
  readonly text: string;
}

interface ItemHead {
  readonly head: Head;
  /** What follows the names. */
  readonly rest: readonly Word[];
  /** Whether it begins with a name that is not known. */
  readonly unknown: boolean;
}

const noUnits: UnitsAt = () => [];

/**
 * Reads values with their types and orders: `f32 CDAB 21.5`, `u16 4096`, `text[4] "PUMP"`, one a line or with commas or
 * semicolons between. Several numbers may follow a type: `i16 1 -2 3`. The order is ABCD where none is named, the type u16
 * where no value of the text has one. Orders and types go by many names (`REAL word swap 21.5`); `text[4]` fills up 4
 * registers and `STRING(8)` room for 8 characters, with `blank` by blanks. Where units are known, a number may have one
 * behind it (`30.0 Hz`), which says its type, order and scale. One comma between digits is a decimal comma (`21,5`).
 */
export function readValues(typed: string, unitsAt: UnitsAt = noUnits): ValuesReading {
  const { text, notices } = withPoints(typed);
  const values: PlacedValue[] = [];
  const faults: PlacedFault[] = [];
  const items = itemsOf(text);
  const heads = items.map(readHead);
  const isTyped = heads.some(({ head }) => head.type !== undefined);
  let registers = 0;
  for (const [index, words] of items.entries()) {
    const { head, rest } = heads[index] as ItemHead;
    const whole = { start: (words[0] as Word).start, end: (words.at(-1) as Word).end };
    const wrong = headFault(heads[index] as ItemHead, isTyped, whole);
    if (wrong) faults.push(wrong);
    for (let at = 0; !wrong && at < rest.length && values.length + faults.length < MOST; ) {
      const { read, taken } = readNext(rest, at, head, () => unitsAt(registers));
      const place = { start: (rest[at] as Word).start, end: (rest[at + taken - 1] as Word).end };
      at += taken;
      if ('code' in read) faults.push({ place, fault: read });
      else {
        values.push({ place: taken === rest.length ? whole : place, ...read });
        registers += read.registers.length;
      }
    }
  }
  return { values, faults, notices };
}

/** What is wrong with an item before its values are looked at; `typed` where another item has a type. */
function headFault({ head, rest, unknown }: ItemHead, typed: boolean, whole: TextRange): PlacedFault | undefined {
  const [first] = rest;
  const place = first ? { start: first.start, end: first.end } : whole;
  if (first === undefined) return { place, fault: { code: 'value-missing' } };
  if (unknown) return { place, fault: { code: 'name-unknown', name: first.text } };
  const untyped = typed && head.type === undefined && rest.every(({ text }) => isNumeric(text));
  return untyped ? { place, fault: { code: 'type-missing', typed: first.text } } : undefined;
}

/** Longest unit in words: `kg / h`. */
const UNIT_WORDS = 3;

interface Next {
  readonly read: TypedValue | ValueFault;
  /** How many words it took. */
  readonly taken: number;
}

/** Reads the value at a word of an item, with the unit behind it if there is one. */
function readNext(words: readonly Word[], at: number, head: Head, units: () => readonly UnitScale[]): Next {
  const { text } = words[at] as Word;
  const behind = words.slice(at + 1, at + 1 + UNIT_WORDS).map((word) => word.text);
  const glued = isNumeric(text) ? null : GLUED.exec(text);
  const plain = !glued && (behind.length === 0 || !isNumeric(text));
  const known = plain ? [] : units();
  if (glued) {
    const [, number = '', unit = ''] = glued;
    const scale = scaleOfUnit(unit, known);
    return { read: scale ? readWithUnit(number, scale, head) : readOne(text, head), taken: 1 };
  }
  for (let many = known.length > 0 ? behind.length : 0; many > 0; many--) {
    const scale = scaleOfUnit(behind.slice(0, many).join(' '), known);
    if (scale) return { read: readWithUnit(text, scale, head), taken: 1 + many };
  }
  const [next] = behind;
  if (plain || next === undefined || !isUnit(next)) return { read: readOne(text, head), taken: 1 };
  const names = [...new Set(known.map(({ unit }) => unit))];
  return { read: { code: 'unit-unknown', unit: next, known: names }, taken: 2 };
}

/** A number with its unit right behind it. */
const GLUED = /^([-−+]?[\d._]+)([^\d._].*)$/;

/** Whether what stands behind a number may be its unit: no other value, and no name of a type. */
const isUnit = (text: string): boolean =>
  !isNumeric(text) && !/^["\d]/.test(text) && !typeNames.has(plainName(text)) && !orderNames.has(plainName(text));

const WORD = /"(?:[^"\n]|"")*"?|[^\s,;"\n]+|[,;\n]/g;

/** The words of each item; commas, semicolons and line ends stand between items. */
function itemsOf(text: string): Word[][] {
  const items: Word[][] = [[]];
  for (const { 0: word, index } of text.matchAll(WORD)) {
    if (word === ',' || word === ';' || word === '\n') items.push([]);
    else items.at(-1)?.push({ text: ungrouped(word), start: index, end: index + word.length });
  }
  return items.filter((words) => words.length > 0);
}

/** Digits that more than one point groups are one number: `1.234.567`. */
const ungrouped = (word: string): string =>
  /^[-+−]?\d{1,3}(?:\.\d{3}){2,}$/.test(word) ? word.replaceAll('.', '') : word;

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
  const unknown =
    next !== undefined &&
    (head.type === undefined || isNumberType(head.type)) &&
    /^[a-z_]{2}/i.test(next.text) &&
    !isNumeric(next.text);
  return { head, rest, unknown };
}

function takeName(words: readonly Word[], at: number, head: Head): number {
  for (let many = Math.min(NAME_WORDS, words.length - at); many > 0; many--) {
    const name = words.slice(at, at + many).map(({ text }) => text);
    // What is written as a number or in quotes is the value: `int 16` is not int16.
    if (name.some((part) => part.startsWith('"') || readExact(part) !== undefined)) continue;
    if (takes(name.join(' '), head)) return many;
  }
  return 0;
}

/** Longer words are not names. */
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
    if (room !== undefined && !isTextType(named.type)) return false;
    head.type = named.type;
    if (room !== undefined) head.room = room;
    if (named.order) head.order = named.order;
    return true;
  }
  if (room !== undefined) return false;
  const order = orderNames.get(plain);
  const padding = head.type !== undefined && isTextType(head.type) ? paddingNames.get(plain) : undefined;
  if (order) head.order = order;
  if (padding) head.padding = padding;
  return order !== undefined || padding !== undefined;
}
