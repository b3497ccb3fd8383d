import { daysFrom } from '../modbus/index.ts';

const SECOND = 1_000_000;
const MINUTE = 60 * SECOND;
const HOUR = 60 * MINUTE;
const DAY = 24 * HOUR;
const HALF_DAY = 12;

/** A time as microseconds: since 1970 if it has a date, else since midnight, or since whatever the text counts from. */
export interface ClockTime {
  readonly time: number;
  readonly dated: boolean;
}

const DATE = /(?:(\d{4})[-/.](\d{1,2})[-/.](\d{1,2})|(\d{1,2})([-/.])(\d{1,2})[-/.](\d{4}))/;
const CLOCK = /(?:^|[^\d])(\d{1,2}):(\d{2}):(\d{2})(?:[.,:](\d{1,9}))? ?([AP]M)?(Z|[-+]\d\d:?\d\d)?/i;
const MINUTES = /^(\d{1,2}):(\d{2})\.(\d{3,6})$/;
const SECONDS = /^(\d{1,12})\.(\d{1,9})$/;
/** Seconds since 1970 have this many digits, and those since a start fewer. */
const EPOCH_DIGITS = 9;
const FRACTION_DIGITS = 6;

const fraction = (digits: string | undefined): number =>
  digits === undefined ? 0 : Number(digits.slice(0, FRACTION_DIGITS).padEnd(FRACTION_DIGITS, '0'));

/** The time that a log prints; `undefined` if the text is not one. A date of two numbers and a year has its day first, but with slashes. */
export function clockTime(text: string): ClockTime | undefined {
  const plain = text.trim();
  const seconds = SECONDS.exec(plain);
  if (seconds) {
    const [, whole = '', digits] = seconds;
    return { time: Number(whole) * SECOND + fraction(digits), dated: whole.length > EPOCH_DIGITS };
  }
  const minutes = MINUTES.exec(plain);
  if (minutes)
    return { time: Number(minutes[1]) * MINUTE + Number(minutes[2]) * SECOND + fraction(minutes[3]), dated: false };
  const clock = CLOCK.exec(plain);
  if (!clock) return undefined;
  const [, hours, mins, secs, digits, half, zone] = clock;
  const hour =
    half === undefined ? Number(hours) : (Number(hours) % HALF_DAY) + (half.toUpperCase() === 'PM' ? HALF_DAY : 0);
  const time = hour * HOUR + Number(mins) * MINUTE + Number(secs) * SECOND + fraction(digits) - offset(zone);
  const date = DATE.exec(plain);
  return date ? { time: dayOf(date) * DAY + time, dated: true } : { time, dated: false };
}

function offset(zone: string | undefined): number {
  if (zone === undefined || zone.toUpperCase() === 'Z') return 0;
  const sign = zone.startsWith('-') ? -1 : 1;
  return sign * (Number(zone.slice(1, 3)) * HOUR + Number(zone.slice(-2)) * MINUTE);
}

function dayOf([, year, month, day, first, mark, second, last]: RegExpExecArray): number {
  if (year !== undefined) return daysFrom(Number(year), Number(month), Number(day));
  const [a, b] = [Number(first), Number(second)];
  const american = (mark === '/' && a <= 12) || b > 12;
  return american ? daysFrom(Number(last), a, b) : daysFrom(Number(last), b, a);
}

/**
 * Times of a log one after another, as they are kept: since 1970 where the log has dates, else since its first one. A clock
 * without a date that goes back by more than half a day has passed midnight.
 */
export class LogClock {
  /** The clock that the first time without a date shows, in microseconds since midnight; 0 if there is none. */
  get first(): number {
    return this.#first ?? 0;
  }

  #first: number | undefined;
  #before = 0;
  #days = 0;

  read(text: string | undefined): number | undefined {
    const found = text === undefined ? undefined : clockTime(text);
    if (found === undefined) return undefined;
    if (found.dated) return found.time;
    if (this.#before - found.time > DAY / 2) this.#days++;
    this.#before = found.time;
    const time = found.time + this.#days * DAY;
    this.#first ??= time;
    return time - this.#first;
  }
}
