import { dateText, daysFrom } from '../../captures/index.ts';

/** A time that somebody wrote, in microseconds. */
export type WrittenMoment =
  /** Since the first record. */
  | { readonly kind: 'since'; readonly time: number }
  /** Since midnight, of whatever day. */
  | { readonly kind: 'clock'; readonly time: number }
  /** Since 1970, by the clock that the reader sees. */
  | { readonly kind: 'date'; readonly time: number };

/** When records were made. */
export interface TraceSpan {
  /** The times of the first and the last of them, in microseconds. */
  readonly first: number;
  readonly last: number;
  /** What makes the time of a record the clock that the reader sees, in microseconds; 0 for times since 1970 shown as UTC. */
  readonly clock: number;
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

/**
 * When a written time was, as the time of a record. Of the days on which a clock shows it, the first within the span and not before `least`
 * is meant; if it lies outside of it, the day on which it is nearest.
 */
export function momentIn({ first, last, clock }: TraceSpan, { kind, time }: WrittenMoment, least = first): number {
  if (kind === 'since') return first + time;
  if (kind === 'date') return time - clock;
  const from = Math.max(first, least);
  const midnight = Math.floor((from + clock) / DAY) * DAY - clock;
  const today = midnight + time;
  const next = today >= from ? today : today + DAY;
  return next <= last || next - last <= from - (next - DAY) ? next : next - DAY;
}
