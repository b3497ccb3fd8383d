import type { PrintedClock } from '../../captures/index.ts';
import { describeFunction } from '../../modbus/index.ts';
import type { KnownValue, Tally } from '../../trace/index.ts';
import { filterText, parseFilter } from './filter.ts';
import type { FilterTerm } from './filter-term.ts';
import type { WrittenMoment } from './moment.ts';

/** What terms of a filter are about: those of one place are replaced together. */
const places = { subject: ['unit', 'fc', 'addr', 'conn'], time: ['from', 'to'] } as const;

/** The word before the colon of a term. */
function wordOf(term: FilterTerm): string {
  switch (term.is) {
    case 'among':
    case 'compared':
      return term.of;
    case 'address':
      return 'addr';
    case 'connection':
      return 'conn';
    case 'time':
      return term.bound;
    default:
      return term.is;
  }
}

/** A filter with these terms in place of its own of the same place; of a filter that cannot be read, nothing stays. */
function withTerms(filter: string, place: keyof typeof places, terms: readonly FilterTerm[]): string {
  const read = parseFilter(filter);
  const words: readonly string[] = places[place];
  const kept = read.kind === 'filter' ? read.terms.filter((term) => !words.includes(wordOf(term))) : [];
  return filterText([...kept, ...terms]);
}

const among = (of: 'unit' | 'fc', value: number | undefined): readonly FilterTerm[] =>
  value === undefined ? [] : [{ not: false, is: 'among', of, ranges: [[value, value]] }];

/** A filter that shows the exchanges of a tally. */
export function filterOfTally(filter: string, tally: Tally): string {
  const { unit, functionCode, address, quantity = 1, connection } = tally;
  const { table } = functionCode === undefined ? { table: undefined } : describeFunction(functionCode, 'request');
  const last = address === undefined ? 0 : address + Math.max(1, quantity) - 1;
  const terms: readonly FilterTerm[] = [
    ...(connection === undefined ? [] : [{ not: false, is: 'connection' as const, text: connection }]),
    ...among('unit', unit),
    ...among('fc', functionCode),
    ...(address === undefined
      ? []
      : [
          {
            not: false,
            is: 'address' as const,
            ranges: [{ table: table === 'file-record' ? undefined : table, first: address, last }],
          },
        ]),
  ];
  return withTerms(filter, 'subject', terms);
}

/** A filter that shows the exchanges which are about a register or a bit. */
export function filterOfKnown(filter: string, { unit, table, address }: KnownValue): string {
  return withTerms(filter, 'subject', [
    ...among('unit', unit),
    { not: false, is: 'address', ranges: [{ table, first: address, last: address }] },
  ]);
}

/**
 * A filter that shows what happened between two times, in microseconds as the records have them; `origin` is that of the first record. It has the
 * times that the source prints, and else those since the first.
 */
export function filterOfTimes(filter: string, origin: number, from: number, to: number, clock?: PrintedClock): string {
  const term = (bound: 'from' | 'to', time: number): FilterTerm => ({
    not: false,
    is: 'time',
    bound,
    moment: momentOf(time, origin, bound === 'from' ? Math.floor : Math.ceil, clock),
  });
  return withTerms(filter, 'time', [term('from', from), term('to', to)]);
}

const DAY = 86_400_000_000;

function momentOf(
  time: number,
  origin: number,
  whole: (time: number) => number,
  clock: PrintedClock | undefined,
): WrittenMoment {
  const since: WrittenMoment = { kind: 'since', time: Math.max(0, whole(time - origin)) };
  if (clock === undefined || clock.shows === 'count') return since;
  const shown = whole(time + clock.shift);
  if (clock.shows !== 'day') return { kind: 'date', time: shown };
  // On another day the same time would be that of the first.
  const isFirstDay = time >= origin && Math.floor(shown / DAY) === Math.floor((origin + clock.shift) / DAY);
  return isFirstDay ? { kind: 'clock', time: shown % DAY } : since;
}

/** A filter without times. */
export const filterOfAllTimes = (filter: string): string => withTerms(filter, 'time', []);

/** Whether a filter shows a part of the time only. */
export function filtersTimes(filter: string): boolean {
  const read = parseFilter(filter);
  return read.kind === 'filter' && read.terms.some((term) => term.is === 'time');
}
