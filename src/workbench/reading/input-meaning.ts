import type { Profile } from '../../devices/index.ts';
import { LAST_ADDRESS, type Table } from '../../modbus/index.ts';
import { type PlcCode, readNumber, type TextProblem, wholeNumber } from '../../notation/index.ts';
import { saysSixDigits } from '../frame/address-typed.ts';
import { type Draft, withText } from '../frame/draft.ts';
import { evaluate } from '../frame/evaluate.ts';
import type { FoundFunction } from '../frame/functions-by-use.ts';
import { type Clauses, withoutUnit } from './input-clauses.ts';
import { type Asked, type InputCommand, readCommand } from './input-command.ts';
import { bytesDraft, readDraft, requestWith, valuesDraft } from './input-drafts.ts';
import { functionNumbered, functionsNamed, functionsOf, isCodeAndPart } from './input-functions.ts';
import { controllerPlaces, type InputContext, type InputPlace, inOneBase } from './input-place.ts';
import { type InputTool, toolAsked } from './input-tools.ts';
import { type NumberValue, numberValues, saysType } from './input-values.ts';
import type { TextReading } from './read-text.ts';

/** One thing that a text may be, and the draft that it comes to. */
export type InputOffer =
  /** The function of this code, or a sub-function or MEI type of it (`part`); `name` is the specification's, if it has one. */
  | {
      readonly as: 'function';
      readonly code: number;
      readonly part: number | undefined;
      readonly name: string | undefined;
      readonly draft: Draft;
    }
  | { readonly as: 'bytes'; readonly bytes: Uint8Array; readonly draft: Draft }
  /** Registers of a reply. */
  | { readonly as: 'values'; readonly registers: readonly number[]; readonly draft: Draft }
  /** A number, as the registers of a value that is written. */
  | ({ readonly as: 'number' } & NumberValue)
  /** The frame, to another unit. */
  | { readonly as: 'unit'; readonly unit: string; readonly draft: Draft }
  | {
      readonly as: 'address';
      /** The function of the request. */
      readonly code: number;
      readonly table: Table;
      /** Counted from 0. */
      readonly address: number;
      /** Whether its number was typed in six digits. */
      readonly sixDigits: boolean;
      /** The bit of the register that is meant, from 0. */
      readonly bit?: number | undefined;
      /** The family of controllers in whose programs the text is the name of the place. */
      readonly plc?: PlcCode | undefined;
      /** The value takes several registers in a type that was not typed. */
      readonly isWide?: boolean | undefined;
      /** How many are read; `undefined` for one, and for as many as a value of the device has. */
      readonly quantity: string | undefined;
      /** What is written, as typed; empty if the text does not say, `undefined` where it is read. */
      readonly value: string | undefined;
      /** The unit, where the text says it. */
      readonly unit: string | undefined;
      /** What the device calls it, and the device's name. */
      readonly name: string | undefined;
      readonly device: string | undefined;
      readonly draft: Draft;
    };

/** A device that was not chosen, and is by what a text was taken for. */
export interface ChosenByText {
  readonly device: Profile;
  /** The id of the device that was chosen before; blank for none. */
  readonly before: string;
}

/**
 * What the text of the input was taken for. `others` are what it may be besides; of `several` none was taken, and the frame
 * stays as it is until one is.
 */
export type InputMeaning =
  | { readonly kind: 'empty' }
  | { readonly kind: 'frames'; readonly reading: TextReading }
  | {
      readonly kind: 'address';
      readonly taken: InputOffer;
      readonly others: readonly InputOffer[];
      readonly chooses: ChosenByText | undefined;
    }
  | { readonly kind: 'function'; readonly taken: InputOffer; readonly others: readonly InputOffer[] }
  /**
   * A value for the register in the frame; `others` are the number in types of its own. `unknown` is its unit if nothing here says
   * what that is in registers.
   */
  | {
      readonly kind: 'value-with-unit';
      readonly draft: Draft;
      readonly unknown: string | undefined;
      readonly others: readonly InputOffer[];
    }
  /** Another view answers it, and the frame stays as it is. */
  | { readonly kind: 'tool'; readonly tool: InputTool }
  | { readonly kind: 'several'; readonly offers: readonly InputOffer[] }
  | { readonly kind: 'no-bytes'; readonly reading: TextReading; readonly advice?: InputAdvice | undefined };

/** What would do in place of a text that means nothing here: a name that no device has, or a table that nothing writes. */
export type InputAdvice =
  | { readonly code: 'name-unknown'; readonly name: string }
  | { readonly code: 'read-only'; readonly table: Table };

/** Other readings that are offered. */
const MOST = 4;
/** Bare bytes up to this many are rather values than a frame that nobody can read. */
const MOST_BARE = 8;

/** Fewer bytes among words are no frame that somebody meant. */
const MOST_STRAY = 2;

/** Signs that numbers were not meant as bytes. */
const MISREAD: ReadonlySet<TextProblem['code']> = new Set(['odd-digits', 'nibble-missing', 'value-over-255']);

/**
 * What a text that was read is taken for: frames before all; else what asks for a register or a function; a single number, one or
 * two bare ones, and up to eight bytes that make no frame, only for what they may be.
 */
export function inputMeaning(reading: TextReading, context: InputContext): InputMeaning {
  const { text, bytes, items, problems } = reading;
  if (text.trim() === '') return { kind: 'empty' };
  const sound = items.some((item) => item.kind === 'frame' && item.severity !== 'error');
  const misread = problems.some(({ code }) => MISREAD.has(code));
  if (sound && !misread) return { kind: 'frames', reading };
  const tool = toolAsked(text, context.line);
  if (tool) return { kind: 'tool', tool };
  if (bytes.length > MOST_BARE) return { kind: 'frames', reading };
  const twice = sameTwice(text, context);
  if (twice) return twice;
  const command = readCommand(text, context);
  if (command !== undefined) return commandMeaning(command, reading, context);
  const said = withoutUnit(text);
  const functions = functionsNamed(said.text).map((found) => functionOffer(found, context, said.unit));
  const bare = functions.length === 0 ? (bareNumbers(reading, context) ?? numbers(text, context)) : undefined;
  if (bare !== undefined) return bare;
  const [taken, ...others] = functions;
  if (taken !== undefined && (bytes.length === 0 || functions.length === 1 || isCodeAndPart(text)))
    return { kind: 'function', taken, others: [...others.slice(0, MOST), ...asBytes(reading, context)] };
  const some = bytes.length > MOST_STRAY || items.some(({ kind }) => kind === 'frame');
  const name = text.trim();
  const advice: InputAdvice | undefined = NAME.test(name) ? { code: 'name-unknown', name } : undefined;
  return advice === undefined && some ? { kind: 'frames', reading } : { kind: 'no-bytes', reading, advice };
}

/** What looks like the name of a register, and not like bytes. */
const NAME = /^%?(?!0?x[\da-f]+$)(?![\da-f]*$)[a-z]{1,4}[_-]?\d{1,6}(?:[.:,][a-z]{0,3}\d{1,5}){0,2}$/i;

function commandMeaning(command: InputCommand, reading: TextReading, context: InputContext): InputMeaning {
  if (command.kind === 'value') {
    const { draft } = command;
    const [error] = evaluate(draft).errors.values();
    const unknown = error?.code === 'unit-without-device' ? error.unit : undefined;
    return { kind: 'value-with-unit', draft, unknown, others: asNumber(reading.text, context) };
  }
  if (command.kind === 'read-only')
    return { kind: 'no-bytes', reading, advice: { code: 'read-only', table: command.table } };
  if (command.kind === 'clauses') return clausesMeaning(command.clauses, context);
  const [first, ...others] = command.of.map(addressOffer);
  const bytes = asBytes(reading, context);
  if (first === undefined || command.open)
    return { kind: 'several', offers: [...command.of.map(addressOffer), ...bytes] };
  const device = command.of[0].place.named?.profile;
  const chooses = device && device.id !== context.device?.id ? { device, before: context.device?.id ?? '' } : undefined;
  return { kind: 'address', taken: first, others: [...others, ...bytes], chooses };
}

/** A function, a unit, or both, and nothing else. */
function clausesMeaning({ code, unit }: Clauses, context: InputContext): InputMeaning {
  const found = code && functionNumbered(code.code);
  const taken: InputOffer = found
    ? functionOffer(found, context, unit)
    : { as: 'unit', unit: unit ?? '', draft: withText(context.draft, 'unitId', unit ?? '') };
  return { kind: 'function', taken, others: [] };
}

function addressOffer({ place, draft, quantity, value, unit, isWide }: Asked): InputOffer {
  const { table, address, typed, named, bit, plc } = place;
  const many = draft.texts['quantity'];
  return {
    as: 'address',
    code: Number(draft.texts['functionCode']),
    table,
    address,
    sixDigits: saysSixDigits(typed),
    bit,
    plc,
    isWide,
    quantity: quantity ?? (named === undefined && many !== '1' ? many : undefined),
    value,
    unit: unit && String(readNumber(unit) ?? unit),
    name: named?.name,
    device: named?.profile.name,
    draft,
  };
}

const functionOffer = (
  { code, part, name, texts }: FoundFunction,
  { draft }: InputContext,
  unit?: string,
): InputOffer => ({
  as: 'function',
  code,
  part,
  name,
  draft: requestWith(draft, unit === undefined ? texts : { unitId: unit, ...texts }),
});

const BYTES = /^(?:0x|\\x|16#|[\da-f\s,;:-])+h?$/i;

/** The bytes that a text of nothing else says without losing a digit. */
const asBytes = ({ text, bytes, problems }: TextReading, context: InputContext): readonly InputOffer[] =>
  bytes.length === 0 || !BYTES.test(text) || problems.some(({ code }) => code === 'odd-digits')
    ? []
    : [{ as: 'bytes', bytes, draft: bytesDraft(bytes, context) }];

/** A number, in types that hold it. */
const asNumber = (text: string, context: InputContext): readonly InputOffer[] =>
  numberValues(text, context).map((value) => ({ as: 'number', ...value }));

/** A number that is no byte: one that says its type is taken. */
function numbers(text: string, context: InputContext): InputMeaning | undefined {
  const offers = asNumber(text, context);
  const [first] = offers;
  if (first === undefined) return undefined;
  return saysType(text)
    ? { kind: 'value-with-unit', draft: first.draft, unknown: undefined, others: [] }
    : { kind: 'several', offers };
}

/** A number that is said in two bases, as an address or a value: `0x1000 (4096)`. */
function sameTwice(text: string, context: InputContext): InputMeaning | undefined {
  const once = inOneBase(text);
  if (once === text) return undefined;
  return { kind: 'several', offers: [...asAddress([once], context), ...asNumber(String(readNumber(once)), context)] };
}

const NUMBER = /^(?:0x)?[\da-f]+h?$/i;
/** A number that is larger than a byte. */
const LARGE = /^\d{3,}$/;

function bareNumbers(reading: TextReading, context: InputContext): InputMeaning | undefined {
  const { text, bytes, items, problems } = reading;
  const words = text.trim().split(/[\s,;]+/);
  if (!words.every((word) => NUMBER.test(word))) return undefined;
  const odd = words.length === 1 && problems.some(({ code }) => code === 'odd-digits');
  const decimal = words.length === 1 && LARGE.test(words[0] ?? '') ? asNumber(text, context) : [];
  if (odd) {
    const offers = [...inControllers(words, context), ...asNumber(text, context), ...asAddress(words, context)];
    return offers.length > 0 ? { kind: 'several', offers } : undefined;
  }
  const few = words.length <= 2 && bytes.length <= 2;
  if (!few && items.some(({ kind }) => kind === 'frame')) return undefined;
  const functions = few ? functionsOf(words).map((found) => functionOffer(found, context)) : [];
  const values = few && words.length === 1 ? [] : asValues(bytes, context);
  const fraction = decimal.length === 0 && text.includes(',') ? asNumber(text, context) : [];
  const all = [
    ...inControllers(words, context),
    ...decimal,
    ...fraction,
    ...values,
    ...functions,
    ...asBytes(reading, context),
    ...(words.length === 1 ? asAddress(words, context) : []),
  ];
  return all.length > 1 ? { kind: 'several', offers: all } : undefined;
}

function asValues(bytes: Uint8Array, context: InputContext): readonly InputOffer[] {
  if (bytes.length === 0 || bytes.length % 2 !== 0) return [];
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  const registers = Array.from({ length: bytes.length / 2 }, (_, index) => view.getUint16(2 * index));
  return [{ as: 'values', registers, draft: valuesDraft(registers, context) }];
}

/** What may be a name in the program of a controller, though it could be hexadecimal; two digits are rather a byte. */
const inControllers = ([word = '', ...more]: readonly string[], context: InputContext): readonly InputOffer[] =>
  word.length < 3 || more.length > 0 ? [] : controllerPlaces(word).map((place) => placeOffer(place, context));

/** A place alone, to be read. */
const placeOffer = (place: InputPlace, context: InputContext): InputOffer =>
  addressOffer({ place, draft: readDraft(place, context), quantity: undefined, value: undefined, unit: undefined });

/** A plain number as the address of a holding register, counted from 0. */
function asAddress([word = '']: readonly string[], context: InputContext): readonly InputOffer[] {
  const address = wholeNumber(0, LAST_ADDRESS)(word);
  if (address === undefined) return [];
  const place: InputPlace = { typed: word, table: 'holding-register', address };
  return [placeOffer(place, { ...context, convention: 'protocol' })];
}
