import type { EntityTable } from '../../devices/index.ts';
import { functionFor, mostOf, readerOf } from '../../modbus/index.ts';
import { readNumber, unitOf } from '../../notation/index.ts';
import type { Draft } from '../frame/draft.ts';
import { accessOfCode, type Clauses, clausesOf, functionOf, NOUN, tableNamed } from './input-clauses.ts';
import { bitDraft, readDraft, valueDraft, writeDraft } from './input-drafts.ts';
import {
  bitOf,
  type Counted,
  controllerPlaces,
  type InputContext,
  type InputPlace,
  inOneBase,
  numberPlaces,
  placesOf,
  rangePlace,
} from './input-place.ts';
import { widerValues } from './input-values.ts';

/** A request that a text asks for. */
export interface Asked {
  readonly place: InputPlace;
  readonly draft: Draft;
  /** As typed, where the text says them. */
  readonly quantity: string | undefined;
  readonly value: string | undefined;
  readonly unit: string | undefined;
  /** The value has a type that the text does not say, and takes several registers. */
  readonly isWide?: boolean;
}

/** What is written where the text says that something is, and not what. */
const NO_VALUE = '';

/** What a text asks for: to read or write at one of these places, or to write a value where the frame writes. */
export type InputCommand =
  /** `open` if the text does not say which of several it is. */
  | { readonly kind: 'asked'; readonly of: readonly [Asked, ...Asked[]]; readonly open: boolean }
  | { readonly kind: 'value'; readonly draft: Draft }
  /** To write where nothing can be written. */
  | { readonly kind: 'read-only'; readonly table: EntityTable }
  /** Nothing but a function or a unit. */
  | { readonly kind: 'clauses'; readonly clauses: Clauses };

/** A longer text, in characters, asks for nothing. */
const LONGEST = 120;
/** Devices that may be meant by a name. */
const MOST = 4;
/** Requests that a text may be. */
const MOST_ASKED = 6;
/** Four bytes in a row are rather a frame than what is asked of one. */
const FOUR_BYTES = /(?:\b[\da-f]{2}[\s,;]+){3}[\da-f]{2}\b/i;

/**
 * Reads what asks for a register: `P0683`, `40108..40110`, `P0683 30 Hz`, `06 read 5 from VW800`, `unit 17 fc 3 40108, 3`, with
 * the words for unit and function at any place. `undefined` for any other text.
 */
export function readCommand(text: string, context: InputContext): InputCommand | undefined {
  const typed = text.trim();
  if (typed === '' || typed.length > LONGEST || typed.includes('\n') || FOUR_BYTES.test(typed)) return undefined;
  const clauses = clausesOf(typed);
  if (clauses.rest === '' && (clauses.unit !== undefined || clauses.code !== undefined))
    return { kind: 'clauses', clauses };
  const { unit, code, does } = clauses;
  // A number in front is the function behind a unit; where neither is said, it may be either.
  const before = does === undefined && code === undefined ? numberBefore(clauses) : [];
  const inFront = before.filter((each) => unit === undefined || each.code).flatMap((each) => requests(each, context));
  const asked = requests(clauses, context);
  if (asked.length > 0 && (unit === undefined || inFront.length === 0)) return command(asked, clauses);
  const [first, ...more] = inFront;
  if (first) return { kind: 'asked', of: [first, ...more.slice(0, MOST_ASKED - 1)], open: more.length > 0 };
  if (code) return { kind: 'clauses', clauses };
  const table = does === 'write' ? readOnlyIn(clauses, context) : undefined;
  if (table) return { kind: 'read-only', table };
  if (does !== undefined) return undefined;
  return command(numberToNumber(clauses, context), clauses) ?? (unit === undefined ? alone(typed, context) : undefined);
}

/** The table to which a text wants to write, and nothing does. */
function readOnlyIn(clauses: Clauses, context: InputContext): EntityTable | undefined {
  for (const [text] of placeAndValue(clauses.rest)) {
    const [place] = placesIn(text, clauses, context);
    if (place && functionFor(place.table, 'writes', 'many') === undefined) return place.table;
  }
  return undefined;
}

function command([first, ...more]: readonly Asked[], clauses: Clauses): InputCommand | undefined {
  if (first === undefined) return undefined;
  const others = more.slice(0, MOST_ASKED - 1);
  // A name means the same place in several devices: the first is taken. Two countings, controllers or orders of words, or reading
  // and writing, are open.
  const isOther = ({ place }: Asked) =>
    place === first.place ? first.isWide === true : place.named === undefined && place.plc === undefined;
  const open = others.some(
    (other) =>
      (first.place.named === undefined && isOther(other)) ||
      (clauses.does === undefined && first.value === undefined && other.value !== undefined),
  );
  return { kind: 'asked', of: [first, ...others], open: open || first.place.plc !== undefined };
}

/** A text without words whose first number is its function, its unit, or its unit before its function: `03 40108 3`. */
function numberBefore(clauses: Clauses): readonly Clauses[] {
  const [, number = '', rest = ''] = /^(0x[\da-f]{1,2}|\d{1,3})[\s,:/]\s*(.+)$/i.exec(clauses.rest) ?? [];
  // Numbers of two digits are rather bytes.
  if (!/[\s,;/]/.test(rest) && !PRINTED.test(rest)) return [];
  if (!/^[a-z%]{0,3}\d/i.test(rest) || !/\d{3}/.test(rest)) return [];
  const code = functionOf(number);
  const isUnit = clauses.unit === undefined && (readNumber(number) ?? MOST_UNIT + 1) <= MOST_UNIT;
  const to: Clauses = { ...clauses, unit: isUnit ? number : clauses.unit, rest };
  return [
    ...(code && accessOfCode(code) ? [{ ...clauses, code, rest }] : []),
    ...(isUnit ? [...numberBefore(to), to] : []),
  ];
}

/** A manual's number at the beginning. */
const PRINTED = /^[0134]\d{4,5}(?!\d)/;
const MOST_UNIT = 255;

/** Every request that clauses and the text beside them may be, the likeliest first. */
function requests(clauses: Clauses, context: InputContext): readonly Asked[] {
  const access = clauses.code && accessOfCode(clauses.code);
  if (clauses.code && access === undefined) return [];
  const does = access?.does ?? clauses.does;
  const words: Clauses = { ...clauses, does, table: access?.table ?? clauses.table };
  const asked = [
    ...(does === 'write' ? [] : reading(words, context)),
    ...(does === 'read' ? [] : writing(words, context)),
  ];
  return asked.length > 0 || does !== 'write' || readOnlyIn(clauses, context)
    ? asked
    : placesIn(clauses.rest, words, context).flatMap((place) => written(place, NO_VALUE, words, context));
}

/** Two plain numbers, of which one is written to the other or both are the ends of a range: `4096 to 683`. */
function numberToNumber(clauses: Clauses, context: InputContext): readonly Asked[] {
  if (!/^\w+\s+(?:to|into)\s+\w+$/i.test(clauses.rest)) return [];
  return [...writing({ ...clauses, does: 'write' }, context), ...reading({ ...clauses, does: 'read' }, context)];
}

const TRAILING = new RegExp(
  String.raw`^(.+?)(?:\s*[,;:/]\s*|\s*[x×*]\s*|\s+(?:for|count|quantity|qty|len|length)\s*[:=]?\s*|\s+)(\d{1,4})(?:\s*${NOUN})?$`,
  'i',
);
const LEADING = new RegExp(
  String.raw`^(\d{1,4})\s+(${NOUN}\s*)?((?:starting\s+)?(?:from|at|of|on|in|@)\s+)?(.+)$`,
  'i',
);

function reading(clauses: Clauses, context: InputContext): readonly Asked[] {
  const { rest, does, code } = clauses;
  const whole = placesIn(rest, clauses, context);
  if (whole.length > 0) return whole.map((place) => asked(place, clauses, context, undefined));
  const [, count = '', words, kind, noun, from, place = ''] = LEADING.exec(rest) ?? [];
  const bare = words === undefined && from === undefined;
  const table = clauses.table ?? tableNamed(kind, noun);
  const counted =
    count === '' || (bare && does !== 'read')
      ? []
      : placesIn(place, { ...clauses, table, does: 'read' }, context, bare ? 'named' : 'any');
  if (counted.length > 0) return counted.map((one) => asked(one, { ...clauses, table }, context, count));
  const [, first = '', last = ''] = TRAILING.exec(rest) ?? [];
  const places = first === '' || Number(last) === 0 ? [] : placesIn(first, clauses, context);
  const likely = places.filter(
    ({ table, named }) =>
      // The value of a register that has a name is rather written.
      does === 'read' || code !== undefined || (named === undefined && Number(last) <= mostOf(readerOf(table))),
  );
  return likely.map((one) => asked(one, clauses, context, last));
}

function asked(place: InputPlace, { unit }: Clauses, context: InputContext, quantity: string | undefined): Asked {
  return { place, draft: readDraft(place, context, { unit, quantity }), quantity, value: undefined, unit };
}

function writing(clauses: Clauses, context: InputContext): readonly Asked[] {
  for (const [place, value] of placeAndValue(clauses.rest)) {
    if (!isValue(value)) continue;
    // One register takes one number.
    if (itemsOf(clauses) === 'one' && /\d[\s,;]+\d/.test(value)) continue;
    const of = placesIn(place, clauses, context).flatMap((one) => written(one, value, clauses, context));
    // What a place does not take is not the place itself.
    if (of.length > 0 || placesIn(place, clauses, context, 'named').length > 0) return of;
  }
  return [];
}

const itemsOf = ({ code }: Clauses) => code && accessOfCode(code)?.items;

function written(place: InputPlace, value: string, clauses: Clauses, context: InputContext): readonly Asked[] {
  const { unit } = clauses;
  const to = { place, quantity: undefined, unit };
  if (place.bit !== undefined) {
    const draft = bitDraft(place, value, context, unit);
    return draft ? [{ ...to, draft, value }] : [];
  }
  const items = itemsOf(clauses);
  const isPlain = place.named === undefined && place.table === 'holding-register';
  const wider = isPlain ? widerValues(value, place, context, { unit }) : [];
  const draft = wider.length > 0 && items !== 'one' ? undefined : writeDraft(place, value, context, { unit, items });
  return [
    ...(draft ? [{ ...to, draft, value }] : []),
    ...wider.map(({ number, type, order, registers, draft }) => {
      const isWord = type.endsWith('16');
      const typed = isWord ? `${type} ${number}` : type === 'text' ? number : `${type} ${order} ${number}`;
      return { ...to, draft, value: typed, isWide: !isWord && registers.length > 1 };
    }),
  ];
}

/** A place as it is called: `from 40108`, `register 108`, `address 4`. */
const CALLED = new RegExp(
  String.raw`^(?:starting\s+)?(?:(?:from|at|of|on|in|to|into|@)\s+)?(?:(?:${NOUN}|(addr(?:ess)?))\s*(?:no\.?|number|address|#)?\s*[:=]?\s*)?(.+)$`,
  'i',
);

/** The places that a text may be: named or printed, else plain numbers, where words say that something is read or written. */
function placesIn(
  text: string,
  clauses: Clauses,
  context: InputContext,
  which: 'any' | 'named' = 'any',
): readonly InputPlace[] {
  const [, bit, of = ''] = BIT_OF.exec(text.trim()) ?? [];
  if (bit !== undefined) return bitOf(placesIn(of, clauses, context, which), Number(bit));
  const [, kind, noun, address, called = ''] = CALLED.exec(text.trim()) ?? [];
  const table = clauses.table ?? tableNamed(kind, noun);
  const range = rangePlace(called, context) ?? rangePlace(text, context);
  const named = range
    ? [range]
    : [...placesOf(called, context), ...(called === text.trim() ? [] : placesOf(text, context))];
  const fitting = named.filter((place) => table === undefined || place.table === table).slice(0, MOST);
  if (fitting.length > 0) return fitting;
  const { unit, code, does } = clauses;
  const said =
    unit !== undefined || code !== undefined || does !== undefined || noun !== undefined || address !== undefined;
  if (!said || which === 'named') return [];
  const counted: Counted = noun !== undefined && address === undefined ? 'number' : 'address';
  const places = numberPlaces(inOneBase(called), table ?? DEFAULT, context, counted);
  if (places.length === 0) return controllerPlaces(called);
  return address === undefined ? places : places.slice(0, 1);
}

/** A bit of a register: `bit 5 of 40001`. */
const BIT_OF = /^(?:the\s+)?bit\s*#?\s*(\d|1[0-5])\s+(?:of|in)\s+(.+)$/i;

const DEFAULT: EntityTable = 'holding-register';

const TO_PLACE = /^(.+?)\s+(?:to|into|at|in)\s+(.+)$/i;

/** Where a text may be cut into a place and a value: `2 to VW800`, `P0683 = 30 Hz`, `VW 800 5`, `40108, 5`. */
function* placeAndValue(text: string): Generator<readonly [place: string, value: string]> {
  const [, first = '', second = ''] = TO_PLACE.exec(text) ?? [];
  if (first !== '') {
    yield [second, first];
    yield [first, second];
  }
  const [, before = '', behind = ''] = /^(.+?)\s*:?=\s*(.+)$/.exec(text) ?? [];
  if (before !== '') yield [before, behind];
  const words = text.split(/\s*[,;]\s*|\s+/);
  for (let cut = words.length - 1; cut > 0; cut--) yield [words.slice(0, cut).join(' '), words.slice(cut).join(' ')];
}

const isValue = (text: string): boolean =>
  /^[-+−]?[\d.,]|^["'“„«‘].+["'“”»’]$|^(?:on|off|true|false)$|^(?:[fiu](?:16|32|64))\b/i.test(text);

/** A value with a unit, for the register that the frame writes. */
function alone(text: string, context: InputContext): InputCommand | undefined {
  if (unitOf(text) === undefined) return undefined;
  const draft = valueDraft(text, context);
  return draft && { kind: 'value', draft };
}
