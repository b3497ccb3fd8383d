import { fieldValue, type ValueType } from '../../modbus/index.ts';
import { clearProtocolAddress, readExact, readValues, unitOf } from '../../notation/index.ts';
import type { Draft } from '../frame/draft.ts';
import { evaluate } from '../frame/evaluate.ts';
import { writeDraft } from './input-drafts.ts';
import type { InputContext, InputPlace } from './input-place.ts';

/** A number as a value of a type: its registers, and the request that writes them where the frame is. */
export interface NumberValue {
  /** The number as typed, without its unit. */
  readonly number: string;
  readonly type: ValueType;
  readonly order: 'ABCD' | 'CDAB';
  readonly registers: readonly number[];
  readonly draft: Draft;
}

const NUMBER = /^([-+−]?\d+(?:[.,]\d+)?(?:e[-+]?\d{1,3})?)(?:\s*\D.*)?$/i;
/** What bytes and addresses do not have. */
const SIGNED = /^[-+−]|\d\.\d/;
/** Longest list of numbers. */
const MOST = 16;
/** Values of types in words: `f32 CDAB 21.5`. */
const TYPED = /^(?:[fiu](?:16|32|64)|real|dint|udint|int|float)\b.*\d/i;

/** Whether a text says the type of its value. */
export const saysType = (text: string): boolean => TYPED.test(text.trim()) && !text.trim().includes('\n');

const WORD = 0x1_0000;
const TWO_WORDS = WORD * WORD;

/** The types that hold a number, the likeliest first, with the order of its words where it has several. */
function typesOf(value: number): readonly (readonly [ValueType, NumberValue['order']])[] {
  const float = [
    ['f32', 'ABCD'],
    ['f32', 'CDAB'],
  ] as const;
  if (!Number.isInteger(value)) return float;
  const half = value < 0 ? -value * 2 - 1 : value;
  if (half < WORD) return [[value < 0 ? 'i16' : 'u16', 'ABCD'], float[0]];
  const wide = value < 0 ? 'i32' : 'u32';
  if (half < TWO_WORDS) return [[wide, 'ABCD'], [wide, 'CDAB'], float[0]];
  return [[value < 0 ? 'i64' : 'u64', 'ABCD'], float[0]];
}

/**
 * What a number, or several of which one has a sign or a fraction, may be as values: `-5`, `77.5`, `70000`, `1.5 2`, `-1.5 °C`,
 * whose unit nothing here knows, or `f32 77.5`. Empty for any other text.
 */
export function numberValues(text: string, context: InputContext): readonly NumberValue[] {
  const typed = text.trim();
  return saysType(typed) ? valuesTyped(typed, context) : valuesAt(numbersOf(typed), placeOfFrame(context), context);
}

/** How a value is asked for beside its place. */
interface AskedFor {
  readonly unit?: string | undefined;
}

const QUOTED = /^["'“”„«‘]([^"\n]+)["'“”»’]$/;

/**
 * A value that is to be written at a place, in the types that hold it, where its numbers do not each fit into a register: `77.5`,
 * `70000`, `-5`, `1.5 2`, and texts in quotes. Empty for any other value.
 */
export function widerValues(
  value: string,
  place: InputPlace,
  context: InputContext,
  asked: AskedFor,
): readonly NumberValue[] {
  const typed = value.trim();
  const [, characters] = QUOTED.exec(typed) ?? [];
  if (characters !== undefined) {
    const written = `text "${characters}"`;
    const draft = writeDraft(place, written, context, asked);
    const { values, faults } = readValues(written);
    const registers = values.flatMap((one) => one.registers);
    return draft && faults.length === 0 ? [{ number: written, type: 'text', order: 'ABCD', registers, draft }] : [];
  }
  const words = wordsOf(typed);
  const numbers = words.map((word) => Number(pointed(word)));
  const fit = numbers.every((number) => Number.isInteger(number) && number >= 0 && number < WORD);
  return fit || !words.every(isNumberAlone) ? [] : valuesAt(words, place, context, asked);
}

const wordsOf = (typed: string): readonly string[] => typed.split(/[\s;]+|,\s+/);
const isNumberAlone = (word: string): boolean => NUMBER.exec(word)?.[1] === word;
const pointed = (number: string): string => number.replace(',', '.').replace('−', '-');

/** Numbers, as typed, in the types that hold all of them, each with the request that writes them at a place. */
function valuesAt(
  typed: readonly string[],
  place: InputPlace,
  context: InputContext,
  asked: AskedFor = {},
): readonly NumberValue[] {
  const numbers = typed.map(pointed);
  if (numbers.length === 0 || numbers.some((number) => readExact(number) === undefined)) return [];
  const [first = 0, ...more] = numbers.map(Number);
  const widest = [first, ...more].find((value) => !Number.isInteger(value)) ?? extreme([first, ...more]);
  return typesOf(widest).flatMap(([type, order]): NumberValue[] => {
    const written = `${type} ${order === 'ABCD' ? '' : `${order} `}${numbers.join(' ')}`;
    const { values, faults } = readValues(written);
    const draft = writeDraft(place, written, context, asked);
    if (draft === undefined || faults.length > 0) return [];
    const registers = values.flatMap((value) => value.registers);
    return [{ number: numbers.join(' '), type, order, registers, draft }];
  });
}

/** The numbers of a text as typed: one, with a unit or without, or several that are not bytes. */
function numbersOf(typed: string): readonly string[] {
  const [, single = ''] = NUMBER.exec(typed) ?? [];
  if (single !== '' && (single === typed || unitOf(typed) !== undefined)) return [single];
  const words = wordsOf(typed);
  const several = words.length <= MOST && words.every(isNumberAlone);
  return several && words.some((word) => SIGNED.test(word)) ? words : [];
}

/** The value that needs the widest type; of a list with negative numbers, as a negative one. */
function extreme(values: readonly number[]): number {
  const widest = values.reduce((one, other) => (Math.abs(other) > Math.abs(one) ? other : one));
  return values.some((value) => value < 0) ? -Math.abs(widest) : widest;
}

function valuesTyped(typed: string, context: InputContext): readonly NumberValue[] {
  const { values, faults } = readValues(typed);
  const [first] = values;
  const draft = first && faults.length === 0 ? writeDraft(placeOfFrame(context), typed, context) : undefined;
  if (draft === undefined || first === undefined) return [];
  const registers = values.flatMap((value) => value.registers);
  return [{ number: typed, type: 'u16', order: 'ABCD', registers, draft }];
}

/** The holding register that the frame is about; the first one if it is about none. */
function placeOfFrame({ draft }: InputContext): InputPlace {
  const { frame, description } = evaluate(draft);
  const found =
    frame && description.table === 'holding-register'
      ? (fieldValue(frame.reading, 'address') ?? fieldValue(frame.reading, 'startAddress'))
      : undefined;
  const address = typeof found === 'number' ? found : 0;
  return { typed: clearProtocolAddress('holding-register', address), table: 'holding-register', address };
}
