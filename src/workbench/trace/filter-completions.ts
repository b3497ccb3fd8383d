import type { EntityTable } from '../../devices/index.ts';
import { entityNumber } from '../../notation/index.ts';
import { wordsOfFilter } from './filter.ts';
import { type FilterTermName, faultWords, filterTerms } from './filter-term.ts';

/** What occurs in a trace, each with how often, the most frequent first or in ascending order. */
export interface FilterKnown {
  readonly units: readonly Occurring[];
  readonly functionCodes: readonly Occurring[];
  readonly exceptions: readonly Occurring[];
  readonly addresses: readonly (Occurring & { readonly table: EntityTable | undefined })[];
  /** Faults by the word that finds them, and causes by their code. */
  readonly faults: readonly { readonly word: string; readonly count: number }[];
  readonly causes: readonly { readonly code: string; readonly count: number }[];
  /** The ends of connections. */
  readonly ends: readonly { readonly text: string; readonly count: number }[];
  /** When the first and the last record were made, as somebody would write it. */
  readonly times: readonly string[];
}

/** What is known before a trace has been looked through. */
export const NOTHING_KNOWN: FilterKnown = Object.freeze({
  units: [],
  functionCodes: [],
  exceptions: [],
  addresses: [],
  faults: [],
  causes: [],
  ends: [],
  times: [],
});

/** What numbers are called: their values are found by the words of their names, too. */
export type FilterNames = Readonly<Partial<Record<FilterTermName, (value: number) => string>>>;

interface Occurring {
  readonly value: number;
  readonly count: number;
}

/** What may stand at the caret: `text` in the place of the characters `[from, to)`. */
export interface Completion {
  readonly text: string;
  readonly from: number;
  readonly to: number;
  /** The term itself, or a value of which term; a fault stands alone. */
  readonly of:
    | { readonly kind: 'term' | 'value'; readonly term: FilterTermName }
    | { readonly kind: 'fault'; readonly word: string };
  /** How often it occurs. */
  readonly count: number | undefined;
}

/** Terms that begin with a comparison rather than with a colon. */
const COMPARED: ReadonlySet<FilterTermName> = new Set(['value', 'slow']);
const MOST = 50;
const VALUE = /^([a-z]+)(?::|=)(.*)$/is;
/** Behind a comma or a dash the next value begins. */
const LAST_VALUE = /[^,–-]*$/;

/** What the word at the caret may become; at a space, and in an empty text, all terms. Nothing within a text in quotes. */
export function completions(
  text: string,
  caret: number,
  known: FilterKnown,
  names: FilterNames = {},
): readonly Completion[] {
  let [from, to] = [caret, caret];
  for (const word of wordsOfFilter(text)) {
    if (word.from > caret) break;
    if (caret <= word.to) [from, to] = [word.from, word.to];
  }
  if (text.charAt(from) === '-' && from < caret) from++;
  const typed = text.slice(from, caret);
  if (typed.includes('"')) return [];
  const [, name = '', values = ''] = VALUE.exec(typed) ?? [];
  const term = filterTerms.find((one) => one === name.toLowerCase());
  if (term === undefined)
    return name === '' ? [...words(typed.toLowerCase(), from, to, known), ...named(typed, from, to, known, names)] : [];
  const last = LAST_VALUE.exec(values)?.[0] ?? '';
  const at = caret - last.length;
  return valuesOf(term, known)
    .filter(
      ({ text, value }) =>
        text !== last && (text.toLowerCase().startsWith(last.toLowerCase()) || isCalled(value, names[term], last)),
    )
    .slice(0, MOST)
    .map(({ text, count }) => ({ text, from: at, to, of: { kind: 'value', term }, count }));
}

/** Letters from which on a name is looked for. */
const LETTERS = 2;

/** Whether a word of a number's name begins with what was typed. */
function isCalled(value: number | undefined, name: FilterNames[FilterTermName], typed: string): boolean {
  if (value === undefined || name === undefined || typed.length < LETTERS || !/^[a-z]/i.test(typed)) return false;
  const words = name(value)
    .toLowerCase()
    .split(/[^a-z0-9]+/);
  return words.some((word) => word.startsWith(typed.toLowerCase()));
}

/** The values that a plain word names: `illegal` is `exception:02`. */
function named(typed: string, from: number, to: number, known: FilterKnown, names: FilterNames): readonly Completion[] {
  // What is a whole word of the filter already is meant as that.
  if (faultWords.has(typed.toLowerCase())) return [];
  return filterTerms.flatMap((term) =>
    valuesOf(term, known)
      .filter(({ value }) => isCalled(value, names[term], typed))
      .map(
        ({ text, count }): Completion => ({ text: `${term}:${text}`, from, to, of: { kind: 'value', term }, count }),
      ),
  );
}

function words(typed: string, from: number, to: number, known: FilterKnown): readonly Completion[] {
  const counts = new Map(known.faults.map(({ word, count }) => [word, count]));
  const faults = [...new Set([...counts.keys(), ...faultWords.keys()])].filter(
    (word) => word.startsWith(typed) && word !== typed,
  );
  const terms = filterTerms.filter((term) => term.startsWith(typed));
  return [
    ...faults.map(
      (word): Completion => ({ text: word, from, to, of: { kind: 'fault', word }, count: counts.get(word) }),
    ),
    ...terms.map((term): Completion => {
      const text = `${term}${COMPARED.has(term) ? '>' : ':'}`;
      return { text, from, to, of: { kind: 'term', term }, count: undefined };
    }),
  ];
}

function valuesOf(
  term: FilterTermName,
  known: FilterKnown,
): readonly { readonly text: string; readonly value?: number; readonly count: number | undefined }[] {
  const numbers = (list: readonly Occurring[]) =>
    list.map(({ value, count }) => ({ text: String(value), value, count }));
  switch (term) {
    case 'unit':
      return numbers(known.units);
    case 'fc':
      return numbers(known.functionCodes);
    case 'exception':
      return known.exceptions.map(({ value, count }) => ({ text: String(value).padStart(2, '0'), value, count }));
    case 'addr':
      return known.addresses.map(({ table, value, count }) => ({
        text: table === undefined ? String(value) : entityNumber(table, value),
        count,
      }));
    case 'cause':
      return known.causes.map(({ code, count }) => ({ text: code, count }));
    case 'conn':
      return known.ends;
    case 'from':
    case 'to':
      return known.times.map((text) => ({ text, count: undefined }));
    default:
      return [];
  }
}
