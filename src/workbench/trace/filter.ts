import type { EntityTable } from '../../devices/index.ts';
import {
  type Comparison,
  type FilterMistake,
  type FilterTerm,
  isMistake,
  type NumberTerm,
  type Range,
  readTerm,
  termText,
} from './filter-term.ts';
import { momentIn, type TraceSpan } from './moment.ts';
import type { SeenFault } from './seen-fault.ts';

/** Elements that a request asks for or writes; the table is that of its function. */
export interface Touched {
  readonly table: EntityTable | undefined;
  readonly first: number;
  readonly last: number;
}

/** What a filter asks of a record, or of an exchange. What is not asked need not be worked out. Times are microseconds. */
export interface Described {
  /** NaN, like the function, of a piece in no frame. */
  readonly unit: number;
  /** Without the exception bit. */
  readonly functionCode: number;
  readonly exception: number | undefined;
  readonly faults: readonly SeenFault[];
  /** The causes that explain its faults. */
  readonly causes: readonly string[];
  readonly after: number | undefined;
  readonly time: number | undefined;
  /** Of the whole trace; `undefined` if it has no times. */
  readonly span: TraceSpan | undefined;
  readonly touched: readonly Touched[];
  /** The two ends of its connection, the one that asks first; empty where the records name none. */
  readonly connection: string;
  /** Its registers and bits; in units where a device names them. */
  readonly values: readonly number[];
  /** What its row says, in lower case. */
  readonly sentence: string;
  /** Its first bytes as `0b 6b`, behind that. */
  readonly hex: string;
}

export type Filter = ReadFilter | { readonly kind: 'mistakes'; readonly mistakes: readonly FilterMistake[] };

/** A filter that can be asked. */
export interface ReadFilter {
  readonly kind: 'filter';
  /** It keeps everything. */
  readonly isAll: boolean;
  /** It asks for what a frame has to be decoded for. */
  readonly decodes: boolean;
  /** All of them hold for what is kept. */
  readonly terms: readonly FilterTerm[];
  readonly test: (described: Described) => boolean;
}

type Test = (described: Described) => boolean;

/** A word of a filter with its quotes, and where it stands. */
export interface FilterWord {
  readonly word: string;
  readonly from: number;
  readonly to: number;
}

const SPACE = /\s/;

/** The words of a filter: what spaces part, but not those in quotes. */
export function* wordsOfFilter(text: string): Generator<FilterWord, void, undefined> {
  let from = -1;
  let quoted = false;
  for (let at = 0; at <= text.length; at++) {
    const character = text.charAt(at);
    if (from < 0) {
      if (at === text.length || SPACE.test(character)) continue;
      from = at;
    }
    if (quoted && character === '\\') at++;
    else if (character === '"') quoted = !quoted;
    else if (at >= text.length || (!quoted && SPACE.test(character))) {
      yield { word: text.slice(from, at), from, to: Math.min(at, text.length) };
      from = -1;
    }
  }
  if (from >= 0) yield { word: text.slice(from), from, to: text.length };
}

/** Reads a filter: terms that all have to hold. Takes any text, in time linear in its length. */
export function parseFilter(text: string): Filter {
  const terms: FilterTerm[] = [];
  const mistakes: FilterMistake[] = [];
  let excluding: FilterWord | undefined;
  for (const found of wordsOfFilter(text)) {
    const { word, from, to } = found;
    if (excluding === undefined && (word.toLowerCase() === 'not' || word === '-')) {
      excluding = found;
      continue;
    }
    const minus = excluding === undefined && word.startsWith('-');
    const read = readTerm(minus ? word.slice(1) : word);
    if (isMistake(read)) mistakes.push({ ...read, from: minus ? from + 1 : from, to });
    else terms.push({ not: minus || excluding !== undefined, ...read });
    excluding = undefined;
  }
  if (excluding) mistakes.push({ code: 'nothing-excluded', from: excluding.from, to: excluding.to });
  return mistakes.length > 0 ? { kind: 'mistakes', mistakes } : filterOf(terms);
}

/** The filter of terms. */
export function filterOf(terms: readonly FilterTerm[]): ReadFilter {
  const times = terms.flatMap((term) => (term.is === 'time' && !term.not ? [term] : []));
  const from = times.filter(({ bound }) => bound === 'from').at(-1);
  const tests = [...terms]
    .sort((one, other) => cost(one) - cost(other))
    .map((term) => {
      const test = testOf(term, term.is === 'time' && term.bound === 'to' && !term.not ? from : undefined);
      return term.not ? (described: Described) => !test(described) : test;
    });
  return {
    kind: 'filter',
    isAll: tests.length === 0,
    decodes: terms.some((term) => cost(term) > 0),
    terms,
    test: (described) => tests.every((test) => test(described)),
  };
}

/** The text of a filter, which is read as the same one. */
export const filterText = (terms: readonly FilterTerm[]): string => terms.map(termText).join(' ');

/** What has to be decoded comes last. */
const cost = (term: FilterTerm): number => {
  if (term.is === 'text') return 2;
  return term.is === 'among' || term.is === 'compared' ? Number(term.of === 'value') : 0;
};

const MILLISECOND = 1000;
const EXCEPTION = 0x80;
const NOTHING: readonly number[] = Object.freeze([]);

/** The numbers that a term compares. */
const numbers: Readonly<Record<NumberTerm, (described: Described) => readonly number[]>> = {
  unit: ({ unit }) => [unit],
  fc: ({ functionCode, exception }) =>
    exception === undefined ? [functionCode] : [functionCode, functionCode | EXCEPTION],
  exception: ({ exception }) => (exception === undefined ? NOTHING : [exception]),
  value: ({ values }) => values,
  slow: ({ after }) => (after === undefined ? NOTHING : [after / MILLISECOND]),
};

const comparisons: Readonly<Record<Comparison, (value: number, than: number) => boolean>> = {
  '<': (value, than) => value < than,
  '<=': (value, than) => value <= than,
  '>': (value, than) => value > than,
  '>=': (value, than) => value >= than,
};

const within = (value: number, ranges: readonly Range[]) =>
  ranges.some(([least, most]) => value >= least && value <= most);

const BYTES_END = /[\da-f ]$/;

function testOf(term: FilterTerm, begin: Extract<FilterTerm, { is: 'time' }> | undefined): Test {
  switch (term.is) {
    case 'fault': {
      const { kind } = term;
      return kind === 'any' ? ({ faults }) => faults.length > 0 : ({ faults }) => faults.includes(kind);
    }
    case 'among': {
      const of = numbers[term.of];
      const { ranges } = term;
      return (described) => of(described).some((value) => within(value, ranges));
    }
    case 'compared': {
      const [of, compare] = [numbers[term.of], comparisons[term.by]];
      const { than } = term;
      return (described) => of(described).some((value) => compare(value, than));
    }
    case 'address': {
      const { ranges } = term;
      return ({ touched }) =>
        touched.some(({ table, first, last }) =>
          ranges.some((one) => (one.table ?? table) === table && first <= one.last && last >= one.first),
        );
    }
    case 'text': {
      const wanted = term.text.toLowerCase();
      // What ends otherwise cannot reach into the bytes.
      if (!BYTES_END.test(wanted)) return ({ sentence }) => sentence.includes(wanted);
      return ({ sentence, hex }) => `${sentence} ${hex}`.includes(wanted);
    }
    case 'connection': {
      const wanted = term.text.toLowerCase();
      return ({ connection }) => connection.toLowerCase().includes(wanted);
    }
    case 'time': {
      const { bound, moment } = term;
      let [of, at]: [TraceSpan | undefined, number] = [undefined, 0];
      return ({ time, span }) => {
        if (time === undefined || span === undefined) return false;
        if (span !== of) [of, at] = [span, momentIn(span, moment, begin && momentIn(span, begin.moment))];
        return bound === 'from' ? time >= at : time <= at;
      };
    }
    case 'cause': {
      const { codes } = term;
      return ({ causes }) => causes.some((code) => codes.includes(code));
    }
  }
}
