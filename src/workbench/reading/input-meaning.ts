import { LAST_ADDRESS, type Table } from '../../modbus/index.ts';
import { wholeNumber } from '../../notation/index.ts';
import type { Draft } from '../frame/draft.ts';
import { findFunctions, functionsNamed } from '../frame/find-functions.ts';
import type { FoundFunction } from '../frame/functions-by-use.ts';
import { type InputCommand, readCommand } from './input-command.ts';
import { bytesDraft, readDraft, requestWith, valuesDraft } from './input-drafts.ts';
import type { InputContext, InputPlace } from './input-place.ts';
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
  | {
      readonly as: 'address';
      readonly table: Table;
      /** Counted from 0. */
      readonly address: number;
      /** What the device calls it, and the device's name. */
      readonly name: string | undefined;
      readonly device: string | undefined;
      readonly draft: Draft;
    };

/**
 * What the text of the input was taken for. `others` are what it may be besides; of `bare-numbers` none was taken, and the frame
 * stays as it is until one is.
 */
export type InputMeaning =
  | { readonly kind: 'empty' }
  | { readonly kind: 'frames'; readonly reading: TextReading }
  | { readonly kind: 'address'; readonly taken: InputOffer; readonly others: readonly InputOffer[] }
  | { readonly kind: 'function'; readonly taken: InputOffer; readonly others: readonly InputOffer[] }
  /** A value for the register in the frame, or for the one that the text names; `others` are for other devices. */
  | { readonly kind: 'value-with-unit'; readonly draft: Draft; readonly others: readonly InputOffer[] }
  | { readonly kind: 'bare-numbers'; readonly offers: readonly InputOffer[] }
  | { readonly kind: 'no-bytes'; readonly reading: TextReading };

/** Other readings that are offered. */
const MOST = 4;
/** Bare bytes up to this many are rather values than a frame that nobody can read. */
const MOST_BARE = 8;

/** Fewer bytes among words are no frame that somebody meant. */
const MOST_STRAY = 2;

/**
 * What a text that was read is taken for: frames before all; else what asks for a register or a function; one or two bare numbers,
 * and up to eight bytes that make no frame, only for what they may be.
 */
export function inputMeaning(reading: TextReading, context: InputContext): InputMeaning {
  const { text, bytes, items } = reading;
  if (text.trim() === '') return { kind: 'empty' };
  const sound = items.some((item) => item.kind === 'frame' && item.severity !== 'error');
  if (sound || bytes.length > MOST_BARE) return { kind: 'frames', reading };
  const command = readCommand(text, context);
  if (command !== undefined) return commandMeaning(command, reading, context);
  const functions = functionsNamed(text).map((found) => functionOffer(found, context));
  const bare = functions.length === 0 ? bareNumbers(reading, context) : undefined;
  if (bare !== undefined) return bare;
  const [taken, ...others] = functions;
  if (taken !== undefined && (bytes.length === 0 || functions.length === 1))
    return { kind: 'function', taken, others: [...others.slice(0, MOST), ...asBytes(reading, context)] };
  const some = bytes.length > MOST_STRAY || items.some(({ kind }) => kind === 'frame');
  return { kind: some ? 'frames' : 'no-bytes', reading };
}

function commandMeaning(command: InputCommand, reading: TextReading, context: InputContext): InputMeaning {
  if (command.kind === 'value') return { kind: 'value-with-unit', draft: command.draft, others: [] };
  const [first, ...more] = command.of;
  const others = more.map(({ place, draft }) => addressOffer(place, draft));
  if (command.kind === 'write') return { kind: 'value-with-unit', draft: first.draft, others };
  return {
    kind: 'address',
    taken: addressOffer(first.place, first.draft),
    others: [...others, ...asBytes(reading, context)],
  };
}

const addressOffer = ({ table, address, named }: InputPlace, draft: Draft): InputOffer => ({
  as: 'address',
  table,
  address,
  name: named?.name,
  device: named?.profile.name,
  draft,
});

const functionOffer = ({ code, part, name, texts }: FoundFunction, { draft }: InputContext): InputOffer => ({
  as: 'function',
  code,
  part,
  name,
  draft: requestWith(draft, texts),
});

/** The bytes that a text says without losing a digit. */
const asBytes = ({ bytes, problems }: TextReading, context: InputContext): readonly InputOffer[] =>
  bytes.length === 0 || problems.some(({ code }) => code === 'odd-digits')
    ? []
    : [{ as: 'bytes', bytes, draft: bytesDraft(bytes, context) }];

const NUMBER = /^(?:0x)?[\da-f]+h?$/i;

function bareNumbers(reading: TextReading, context: InputContext): InputMeaning | undefined {
  const { text, bytes, items } = reading;
  const words = text.trim().split(/[\s,;]+/);
  if (!words.every((word) => NUMBER.test(word))) return undefined;
  const few = words.length <= 2 && bytes.length <= 2;
  if (!few && items.some(({ kind }) => kind === 'frame')) return undefined;
  const functions = few ? functionsOf(words).map((found) => functionOffer(found, context)) : [];
  const values = few && words.length === 1 ? [] : asValues(bytes, context);
  const all = [
    ...values,
    ...functions,
    ...asBytes(reading, context),
    ...(words.length === 1 ? asAddress(words, context) : []),
  ];
  return all.length > 1 ? { kind: 'bare-numbers', offers: all } : undefined;
}

/** The function whose MEI types are as good as functions. */
const MEI = 0x2b;

/** The functions of one code, in decimal and in hexadecimal, or of a code and its sub-function. */
function functionsOf([first = '', second]: readonly string[]): readonly FoundFunction[] {
  const named = second === undefined ? [] : findFunctions(`${first}/${second}`);
  const codes = [Number(first), Number.parseInt(first, 16)];
  const meant = findFunctions(first).filter(
    ({ code, part }) => codes.includes(code) && (part === undefined || code === MEI),
  );
  return named.length > 0 ? named : meant.slice(0, MOST);
}

function asValues(bytes: Uint8Array, context: InputContext): readonly InputOffer[] {
  if (bytes.length === 0 || bytes.length % 2 !== 0) return [];
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  const registers = Array.from({ length: bytes.length / 2 }, (_, index) => view.getUint16(2 * index));
  return [{ as: 'values', registers, draft: valuesDraft(registers, context) }];
}

/** A plain number as the address of a holding register, counted from 0. */
function asAddress([word = '']: readonly string[], context: InputContext): readonly InputOffer[] {
  const address = wholeNumber(0, LAST_ADDRESS)(word);
  if (address === undefined) return [];
  const place: InputPlace = { typed: word, table: 'holding-register', address };
  return [addressOffer(place, readDraft(place, { ...context, convention: 'protocol' }))];
}
