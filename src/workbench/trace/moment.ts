import { dateText, daysFrom } from '../../modbus/index.ts';

/** A time that somebody wrote, in microseconds. */
export type WrittenMoment =
  /** Since the first record. */
  | { readonly kind: 'since'; readonly time: number }
  /** Since midnight, of whatever day. */
  | { readonly kind: 'clock'; readonly time: number }
  /** Since 1970, by the clock that the reader sees. */
  | { readonly kind: 'date'; readonly time: number };

/** What makes a time of a record the clock that the reader sees then, in microseconds: 0 for times since 1970 shown as UTC. */
export type ReaderClock = (time: number) => number;

/** When records were made. */
export interface TraceSpan {
  /** The times of the first and the last of them, in microseconds. */
  readonly first: number;
  readonly last: number;
  readonly clock: ReaderClock;
}

const SECOND = 1_000_000;
const MINUTE = 60 * SECOND;
const HOUR = 60 * MINUTE;
const DAY = 24 * HOUR;
const HOURS = 24;
const SIXTY = 60;
const DIGITS = 6;

const SINCE = /^(\d{1,9})(?:\.(\d{1,6}))?s?$/i;
const CLOCK = /^(?:(\d{4})-(\d\d)-(\d\d)(?:T|$))?(?:(\d{1,2}):(\d\d)(?::(\d\d)(?:[.,](\d{1,6}))?)?)?$/i;

const fraction = (digits = '') => Number(digits.padEnd(DIGITS, '0'));

/** Reads `12.5` (seconds since the start), `10:31`, `10:31:05.250`, `2026-11-30` and `2026-11-30T10:31`; `undefined` for other texts. */
export function readMoment(text: string): WrittenMoment | undefined {
  const since = SINCE.exec(text);
  if (since) return { kind: 'since', time: Number(since[1]) * SECOND + fraction(since[2]) };
  const found = CLOCK.exec(text);
  if (!found || text === '') return undefined;
  const [, year, month = '', day = '', hours = '0', minutes = '0', seconds = '0', digits] = found;
  if (Number(hours) >= HOURS || Number(minutes) >= SIXTY || Number(seconds) >= SIXTY) return undefined;
  const time = Number(hours) * HOUR + Number(minutes) * MINUTE + Number(seconds) * SECOND + fraction(digits);
  if (year === undefined) return { kind: 'clock', time };
  const days = daysFrom(Number(year), Number(month), Number(day));
  // A day that the month does not have would be one of another month.
  return dateText(days) === `${year}-${month}-${day}` ? { kind: 'date', time: days * DAY + time } : undefined;
}

/** A time as it is written, so that it is read as the same. */
export function momentText({ kind, time }: WrittenMoment): string {
  const micro = String(time % SECOND).padStart(DIGITS, '0');
  if (kind === 'since') return time % SECOND === 0 ? String(time / SECOND) : `${Math.floor(time / SECOND)}.${micro}`;
  const two = (value: number) => String(value).padStart(2, '0');
  const ofDay = time % DAY;
  const rest =
    ofDay % MINUTE === 0
      ? ''
      : `:${two(Math.floor((ofDay % MINUTE) / SECOND))}${time % SECOND === 0 ? '' : `.${micro}`}`;
  const clock = `${two(Math.floor(ofDay / HOUR))}:${two(Math.floor((ofDay % HOUR) / MINUTE))}${rest}`;
  return kind === 'clock' ? clock : `${dateText(Math.floor(time / DAY))}T${clock}`;
}

/** The time of a record at which the reader's clock shows a time. */
export function recordTime(shown: number, clock: ReaderClock): number {
  // Where a clock is put back it shows a time twice, and the first is meant; where it is put forward, one that it never shows.
  const first = shown - clock(shown - DAY);
  return first + clock(first) === shown ? first : shown - clock(shown + DAY);
}

/**
 * When a written time was, as the time of a record. Of the days on which a clock shows it, the first within the span and not before `least`
 * is meant; if it lies outside of it, the day on which it is nearest.
 */
export function momentIn({ first, last, clock }: TraceSpan, { kind, time }: WrittenMoment, least = first): number {
  if (kind === 'since') return first + time;
  if (kind === 'date') return recordTime(time, clock);
  const from = Math.max(first, least);
  const midnight = Math.floor((from + clock(from)) / DAY) * DAY;
  const on = (day: number) => recordTime(midnight + day * DAY + time, clock);
  const day = on(0) >= from ? 0 : 1;
  const next = on(day);
  const before = on(day - 1);
  return next <= last || next - last <= from - before ? next : before;
}

/** A time of a record as somebody would write it: of the clock within a day, else with its date. */
export function writtenMoment({ first, last, clock }: TraceSpan, time: number): string {
  const dayOf = (one: number) => Math.floor((one + clock(one)) / DAY);
  const shown = Math.max(0, time + clock(time));
  const isOneDay = dayOf(first) === dayOf(last);
  return momentText({ kind: isOneDay ? 'clock' : 'date', time: isOneDay ? shown % DAY : shown });
}
