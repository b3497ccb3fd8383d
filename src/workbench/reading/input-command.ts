import { unitOf } from '../../notation/index.ts';
import type { Draft } from '../frame/draft.ts';
import { readDraft, valueDraft, writeDraft } from './input-drafts.ts';
import { type InputContext, type InputPlace, placesOf, rangePlace } from './input-place.ts';

/** A place that a text names, and the request for it. */
interface Asked {
  readonly place: InputPlace;
  readonly draft: Draft;
}

/** What a text asks for: to read or write at one of these places, or to write a value where the frame writes. */
export type InputCommand =
  | { readonly kind: 'read' | 'write'; readonly of: readonly [Asked, ...Asked[]] }
  | { readonly kind: 'value'; readonly draft: Draft };

/** A longer text, in characters, asks for nothing. */
const LONGEST = 120;
/** Devices that may be meant by a name. */
const MOST = 4;

const UNIT =
  /^(?:(?:unit|slave|station|server|device)\s+)?(\d{1,3}|0x[\da-f]{1,2})\s*[:,]?\s+(?=(?:read|get|write|set)\b)/i;
const VERB = /^(read|get|write|set)\s+/i;
const COUNTED =
  /^(\d+)\s+(?:(?:holding |input )?(?:registers?|words?|values?|coils?|inputs?|bits?)\s+)?(?:(?:from|at|of|in|on)\s+)?/i;
const TO_PLACE = /^(.+?)\s+(?:to|into|at|in)\s+(.+)$/i;

/**
 * Reads what asks for a register: `P0683`, `40108..40110`, `P0683 30 Hz`, `06 read 5 from VW800`, `write 2 to VW800`, where a number
 * in front of the verb is the unit. `undefined` for any other text.
 */
export function readCommand(text: string, context: InputContext): InputCommand | undefined {
  const asked = text.trim();
  if (asked === '' || asked.length > LONGEST || asked.includes('\n')) return undefined;
  const unit = UNIT.exec(asked);
  const rest = unit ? asked.slice(unit[0].length) : asked;
  const verb = VERB.exec(rest);
  const what = verb ? rest.slice(verb[0].length) : rest;
  const to = unit?.[1];
  if (verb === null) return reading(what, context, to, undefined) ?? writing(what, context, to) ?? alone(what, context);
  return /^(?:read|get)/i.test(verb[0]) ? asksToRead(what, context, to) : writing(what, context, to);
}

function asksToRead(what: string, context: InputContext, unit: string | undefined): InputCommand | undefined {
  const counted = COUNTED.exec(what);
  const plain = what.replace(/^(?:from|at|of)\s+/i, '');
  return (
    (counted && reading(what.slice(counted[0].length), context, unit, counted[1])) ??
    reading(plain, context, unit, undefined)
  );
}

function reading(
  text: string,
  context: InputContext,
  unit: string | undefined,
  quantity: string | undefined,
): InputCommand | undefined {
  const range = rangePlace(text, context);
  const places = range ? [range] : placesOf(text, context).slice(0, MOST);
  return asked(
    'read',
    places.map((place) => ({ place, draft: readDraft(place, context, { unit, quantity }) })),
  );
}

function writing(text: string, context: InputContext, unit: string | undefined): InputCommand | undefined {
  for (const [place, value] of placeAndValue(text)) {
    if (!isValue(value)) continue;
    const of = placesOf(place, context)
      .slice(0, MOST)
      .flatMap((one): Asked[] => {
        const draft = writeDraft(one, value, context, unit);
        return draft ? [{ place: one, draft }] : [];
      });
    if (of.length > 0) return asked('write', of);
  }
  return undefined;
}

/** Where a text may be cut into a place and a value: `2 to VW800`, `P0683 = 30 Hz`, `VW 800 5`. */
function* placeAndValue(text: string): Generator<readonly [place: string, value: string]> {
  const [, first = '', second = ''] = TO_PLACE.exec(text) ?? [];
  if (first !== '') {
    yield [second, first];
    yield [first, second];
  }
  const [, before = '', behind = ''] = /^(.+?)\s*:?=\s*(.+)$/.exec(text) ?? [];
  if (before !== '') yield [before, behind];
  const words = text.split(/\s+/);
  for (let cut = words.length - 1; cut > 0; cut--) yield [words.slice(0, cut).join(' '), words.slice(cut).join(' ')];
}

const isValue = (text: string): boolean => /^[-+−]?[\d.,]|^(?:on|off|true|false)$|^(?:[fiu](?:16|32|64))\b/i.test(text);

/** A value with a unit, for the register that the frame writes. */
function alone(text: string, context: InputContext): InputCommand | undefined {
  if (unitOf(text) === undefined) return undefined;
  const draft = valueDraft(text, context);
  return draft && { kind: 'value', draft };
}

function asked(kind: 'read' | 'write', [first, ...others]: readonly Asked[]): InputCommand | undefined {
  return first && { kind, of: [first, ...others] };
}
