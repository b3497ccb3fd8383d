import {
  compare,
  dictionary,
  type FloatTypeName,
  type FormTypeName,
  type Fraction,
  formTypeNames,
  fraction,
  isPartial,
  multiply,
  type NumberTypeName,
  numberTypeNames,
  numberTypes,
  type Order,
  ordersOf,
  plainTypeNames,
  readValue,
  registersOf,
  shortestFloat,
  type TextTypeName,
  textTypeNames,
  toNumber,
  type ValueReading,
  type ValueType,
} from '../../modbus/index.ts';
import { formatValue } from './format-value.ts';
import { readExact } from './number-value.ts';
import { unitOf } from './unit-of.ts';

/** What a person expects to find: a number and how many digits it has behind its point, or a text. */
export type Expected =
  | { readonly kind: 'number'; readonly exactly: Fraction; readonly decimals: number }
  | { readonly kind: 'text'; readonly text: string };

/** Why a value may be what was meant; `power` of ten by which an integer is larger than expected. */
export type Likely =
  | { readonly code: 'expected' | 'expected-rounded' | 'few-digits' | 'printable' | 'small' | 'ordinary-size' }
  | { readonly code: 'expected-scaled'; readonly power: number };

/** Registers read in one type and order. */
export interface ValueView {
  readonly type: ValueType;
  readonly order: Order;
  /** How many registers it takes. */
  readonly registers: number;
  readonly reading: ValueReading;
  /** The value as text; empty if there is none. */
  readonly text: string;
  readonly likely: Likely | undefined;
}

/** Reads what is expected: a number in any notation, also with a unit or a decimal comma, else a text. `undefined` for nothing. */
export function readExpected(text: string): Expected | undefined {
  const whole = text.trim();
  if (whole === '') return undefined;
  const unit = unitOf(whole);
  const trimmed = (unit === undefined ? whole : whole.slice(0, -unit.length))
    .trim()
    .replace(/(?<=^[-+−]?\d+),(?=\d+$)/, '.');
  const number = readExact(trimmed);
  if (number === undefined) return { kind: 'text', text: whole.replace(/^"(.*)"$/, '$1') };
  const [, behind = ''] = number.based ? [] : trimmed.replace(/e.*$/i, '').split('.');
  return { kind: 'number', exactly: number.exactly, decimals: behind.length };
}

/**
 * The values that begin with the first of these registers, in every plain type and order that has registers enough. Rare ones
 * say nothing by themselves: they are there only where something is expected that no plain one has.
 */
export function valuesAt(registers: readonly number[], expected?: Expected): ValueView[] {
  if (registers.length === 0) return [];
  const wanted = expected?.kind === 'number' ? wantedOf(expected) : undefined;
  const plain = viewsOf(plainTypeNames, registers, wanted, ordersOf(2));
  const encodings = expected?.kind === 'text' ? textTypeNames : (['text'] as const);
  const texts = encodings.flatMap((type) => ordersOf(1).map((order) => textView(registers, type, order, expected)));
  const isFound = ({ likely }: ValueView) => likely?.code === 'expected' || likely?.code === 'expected-rounded';
  const views = [...plain, ...withText(texts)];
  if (expected === undefined || views.some(isFound)) return views;
  const forms = formTypeNames
    .filter((type) => registersOf(type) <= registers.length && (wanted === undefined) === (type !== 'pf4q'))
    .flatMap((type) => ordersOf(2).map((order) => formView(registers, type, order, expected)));
  const rare = [
    ...viewsOf(plainTypeNames, registers, wanted, ordersOf(4).slice(ordersOf(2).length)),
    ...viewsOf(wanted ? numberTypeNames.slice(plainTypeNames.length) : [], registers, wanted, ordersOf(4)),
  ];
  const isScaled = plain.some(({ likely }) => likely?.code === 'expected-scaled');
  return [...plain, ...rare.filter((view) => !isScaled || isFound(view)), ...forms, ...withText(texts)];
}

function viewsOf(
  types: readonly NumberTypeName[],
  registers: readonly number[],
  wanted: Wanted | undefined,
  orders: readonly Order[],
): readonly ValueView[] {
  return types
    .filter((type) => numberTypes[type].registers <= registers.length)
    .flatMap((type) =>
      ordersFor(type)
        .filter((order) => orders.includes(order))
        .map((order) => numberView(registers, type, order, wanted)),
    );
}

/** Texts of rare encodings only where they have what is expected, and UTF-8 has it not. */
const withText = (texts: readonly ValueView[]): readonly ValueView[] => {
  const isExpected = ({ likely }: ValueView) => likely?.code === 'expected';
  const plain = texts.filter(({ type }) => type === 'text');
  return plain.some(isExpected)
    ? plain
    : [...plain, ...texts.filter((view) => view.type !== 'text' && isExpected(view))];
};

/** A byte stands in the same half in either order. */
const ordersFor = (type: NumberTypeName): readonly Order[] =>
  isPartial(type) && numberTypes[type].registers === 1 ? ['ABCD'] : ordersOf(numberTypes[type].registers);

/** Where the expected value stands, in the order of the registers; `at` counts them from 0. */
export function findExpected(
  registers: readonly number[],
  expected: Expected,
): { readonly at: number; readonly view: ValueView }[] {
  return registers.flatMap((_, at) =>
    valuesAt(registers.slice(at, at + LONGEST_TEXT), expected)
      .filter(({ likely }) => likely?.code.startsWith('expected'))
      .map((view) => ({ at, view })),
  );
}

/** Registers of a text that are looked at. */
const LONGEST_TEXT = 64;

function numberView(
  registers: readonly number[],
  type: NumberTypeName,
  order: Order,
  wanted: Wanted | undefined,
): ValueView {
  const reading = readValue(registers, type, order);
  const value = reading.kind === 'value' && typeof reading.value !== 'string' ? reading.value : undefined;
  const alone = value !== undefined && plainTypeNames.includes(type) && ordersOf(2).includes(order);
  const likely =
    value === undefined
      ? undefined
      : (likelyExpected(value, type, wanted) ?? (alone ? likelyAlone(value, type) : undefined));
  // What is rare is only shown where it is what is wanted.
  const text = value === undefined || !(alone || likely) ? '' : formatValue(value, type);
  return { type, order, registers: numberTypes[type].registers, reading, text, likely };
}

/** A date or an address begins as expected; of a power factor, the number is asked. */
function formView(
  registers: readonly number[],
  type: FormTypeName,
  order: Order,
  expected: Expected | undefined,
): ValueView {
  const reading = readValue(registers, type, order);
  const value = reading.kind === 'value' ? String(reading.value) : '';
  const found = value !== '' && expected !== undefined && isMeant(value, expected);
  const text = value === '' ? '' : formatValue(value, type);
  return { type, order, registers: registersOf(type), reading, text, likely: found ? { code: 'expected' } : undefined };
}

/** Fewest characters of a date or an address that tell which is meant. */
const FORM_LEAST = 7;

function isMeant(value: string, expected: Expected): boolean {
  if (expected.kind === 'number') {
    const number = readExact(value.replace(/ (?:lead|lag)$/, ''));
    return number !== undefined && / (?:lead|lag)$/.test(value) && compare(number.exactly, expected.exactly) === 0;
  }
  const wanted = expected.text.replace(/^(\d{4}-\d\d-\d\d)T/i, '$1 ').toUpperCase();
  return value.toUpperCase().startsWith(wanted) && (wanted.length >= FORM_LEAST || value.length === wanted.length);
}

/** An integer in tenths, hundredths and so on is taken for the expected one too. */
const POWERS = [0, 1, 2, 3, 4];

/** An expected number, worked out once for all that it is compared with. */
interface Wanted {
  readonly meant: number;
  readonly decimals: number;
  /** The whole numbers that stand for it, by the power of ten; `undefined` where it is not whole. */
  readonly wholes: readonly (bigint | undefined)[];
}

const wantedOf = ({ exactly, decimals }: Extract<Expected, { kind: 'number' }>): Wanted => ({
  meant: toNumber(exactly),
  decimals,
  wholes: POWERS.map((power) => {
    const { numerator, denominator } = multiply(exactly, fraction(10n ** BigInt(power)));
    return denominator === 1n ? numerator : undefined;
  }),
});

/** More than the error of any float, relative to the number. */
const FLOAT_ERROR = 2 ** -9;

function likelyExpected(value: number | bigint, type: NumberTypeName, wanted: Wanted | undefined): Likely | undefined {
  if (wanted === undefined || numberTypes[type].kind === 'bits') return undefined;
  const { meant, decimals, wholes } = wanted;
  if (numberTypes[type].kind === 'float') {
    // A little more than half of the last digit, for what a float cannot hold.
    const off = Math.abs(Number(value) - meant);
    const near = off <= 0.5000001 * 10 ** -decimals;
    if (!near && !(off <= FLOAT_ERROR * Math.abs(meant))) return undefined;
    if (Number(shortestFloat(Number(value), type)) === meant) return { code: 'expected' };
    return near && meant !== 0 ? { code: 'expected-rounded' } : undefined;
  }
  const power = wholes.findIndex(
    (whole) => whole !== undefined && value === (typeof value === 'bigint' ? whole : Number(whole)),
  );
  if (power < 0 || (power > 0 && isPartial(type))) return undefined;
  return power === 0 || value === 0 ? { code: 'expected' } : { code: 'expected-scaled', power };
}

/** Floats of ordinary size, and how few significant digits are no accident in them. */
const ORDINARY = { least: 1e-3, most: 1e7 };
const FEW_DIGITS = dictionary({ f16: undefined, f32: 6, f64: 9, e8m24: undefined } satisfies Record<
  FloatTypeName,
  number | undefined
>);

/** What a value tells without another: a float of few digits, or an integer whose registers are half empty. */
function likelyAlone(value: number | bigint, type: NumberTypeName): Likely | undefined {
  const size = Math.abs(Number(value));
  const few = FEW_DIGITS[type];
  if (few !== undefined) {
    if (!(size >= ORDINARY.least && size < ORDINARY.most)) return undefined;
    const digits = shortestFloat(size, type)
      .replace('.', '')
      .replace(/^0+|0+$|e.*$/g, '');
    return { code: digits.length <= few ? 'few-digits' : 'ordinary-size' };
  }
  const { kind, registers, least } = numberTypes[type];
  if (kind !== 'integer' || registers === 1 || size === 0) return undefined;
  const signed = least < 0;
  // The upper half of the registers holds nothing but the sign. A positive number is the same in the unsigned type.
  const half = 2 ** (8 * registers - (signed ? 1 : 0));
  return size < half && !(signed && value >= 0) ? { code: 'small' } : undefined;
}

/** Fewest characters that make a text. */
const TEXT_LEAST = 4;

function textView(
  registers: readonly number[],
  type: TextTypeName,
  order: Order,
  expected: Expected | undefined,
): ValueView {
  const beginning = registers.slice(0, LONGEST_TEXT);
  const end = beginning.findIndex((register) => !isPrintable(register >>> 8) && !isPrintable(register & 0xff));
  const taken = end < 0 ? beginning : beginning.slice(0, Math.max(1, end));
  const whole = readValue(taken, type, order);
  // A text that is cut inside a character, or is not UTF-8, has its other characters all the same.
  const reading = whole.kind === 'value' || type !== 'text' ? whole : readValue(taken, 'latin1', order);
  const isOdd = reading !== whole;
  const value = reading.kind === 'value' ? String(reading.value) : '';
  const text = value.replace(isOdd ? /[^ -~]/g : /[\p{Cc}\p{Cn}\p{Co}]/gu, '·');
  const found = expected?.kind === 'text' && text.toLowerCase().startsWith(expected.text.toLowerCase());
  const letters = text.replace(/[^\p{L}0-9 ]/giu, '').length;
  const printable = !text.includes('·') && text.length >= TEXT_LEAST && letters > text.length / 2;
  const likely: Likely | undefined = found ? { code: 'expected' } : printable ? { code: 'printable' } : undefined;
  return {
    type,
    order,
    registers: taken.length,
    reading: whole,
    text: /^[·\s]*$/.test(text) ? '' : formatValue(text, 'text'),
    likely,
  };
}

/** Bytes of a text: all but control characters. */
const isPrintable = (byte: number) => byte >= 0x20 && byte !== 0x7f;
