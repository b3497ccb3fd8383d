import { dateText, daysFrom } from '../modbus/index.ts';
import type { CaptureRecord } from '../trace/index.ts';

const MILLISECOND = 1000;
const SECOND = 1_000_000;
const MINUTE = 60 * SECOND;
const HOUR = 60 * MINUTE;
const DAY = 24 * HOUR;
const HALF_DAY = 12;

/** A time as microseconds: since 1970 if it has a date, else since midnight, or since whatever the text counts from. */
export interface ClockTime {
  readonly time: number;
  readonly dated: boolean;
  /** What its zone is ahead of UTC, if it names one: then `time` is UTC. */
  readonly zone?: number | undefined;
  /** It is a count from some start, not a time of day. */
  readonly counts?: boolean;
}

const DATE = /(?:(\d{4})[-/.](\d{1,2})[-/.](\d{1,2})|(\d{1,2})([-/.])(\d{1,2})[-/.](\d{4}))/;
/** The same without marks, and with the name of the month. */
const JOINED_DATE = /^(\d{4})(\d\d)(\d\d)(?=[-T_ ])/;
const NAMED_DATE = /^(\d{1,2})[ /-]([a-z]{3})[a-z]*[ /-](\d{4})/i;
const AMERICAN_DATE = /^([a-z]{3})[a-z]* {1,2}(\d{1,2}),? (\d{4})/i;
const MONTHS = 'jan feb mar apr may jun jul aug sep oct nov dec';
const CLOCK = /(?:^|[^\d])(\d{1,2}):(\d{2}):(\d{2})(?:[.,:](\d{1,9}(?:,\d{3})?))? ?([AP]M)? ?(Z|[-+]\d\d:?\d\d)?/i;
/** The same behind a date, with other marks or none. */
const JOINED_CLOCK = /[-T_ ](\d\d)[-.]?(\d\d)[-.]?(\d\d)(?:[.,](\d{1,9}))?()(Z)?$/i;
const MINUTES = /^(\d{1,2}):(\d{2})\.(\d{3,6})$/;
const SECONDS = /^(\d{1,12})\.(\d{1,18})(?: ?s)?$/;
/** Milliseconds, and since 1970 microseconds and nanoseconds as well. */
const COUNT = /^(\d{1,19})(?: ?(?:ms|(s)))?$/;
/** Seconds since 1970 have this many digits, and those since a start fewer. */
const EPOCH_DIGITS = 9;
const FRACTION_DIGITS = 6;

const fraction = (digits: string | undefined): number =>
  digits === undefined ? 0 : Number(digits.replace(',', '').slice(0, FRACTION_DIGITS).padEnd(FRACTION_DIGITS, '0'));

/** Microseconds of a count, which its digits tell to be since 1970. */
function countTime(digits: string, isSeconds: boolean): ClockTime {
  const [time, width] = [Number(digits), digits.length];
  if (isSeconds) return { time: time * SECOND, dated: false, counts: true };
  if (width < EPOCH_DIGITS + 4) return { time: time * MILLISECOND, dated: false, counts: true };
  return { time: Math.floor(time / 10 ** (width - EPOCH_DIGITS - 1 - FRACTION_DIGITS)), dated: true, zone: 0 };
}

/** The time that a log prints; `undefined` if the text is not one. A date of two numbers and a year has its day first, but with slashes. */
export function clockTime(text: string): ClockTime | undefined {
  const plain = text.trim();
  const seconds = SECONDS.exec(plain);
  if (seconds) {
    const [, whole = '', digits] = seconds;
    const time = Number(whole) * SECOND + fraction(digits);
    return whole.length > EPOCH_DIGITS ? { time, dated: true, zone: 0 } : { time, dated: false, counts: true };
  }
  const count = COUNT.exec(plain);
  if (count) return countTime(count[1] ?? '', count[2] !== undefined);
  const minutes = MINUTES.exec(plain);
  if (minutes) {
    const time = Number(minutes[1]) * MINUTE + Number(minutes[2]) * SECOND + fraction(minutes[3]);
    return { time, dated: false, counts: true };
  }
  const clock = CLOCK.exec(plain) ?? JOINED_CLOCK.exec(plain);
  if (!clock) return undefined;
  const [, hours, mins, secs, digits, half, zone] = clock;
  const hour =
    half === undefined ? Number(hours) : (Number(hours) % HALF_DAY) + (half.toUpperCase() === 'PM' ? HALF_DAY : 0);
  const printed = hour * HOUR + Number(mins) * MINUTE + Number(secs) * SECOND + fraction(digits);
  const day = dayIn(plain);
  if (day === undefined) return { time: printed, dated: false };
  const ahead = offset(zone);
  const time = day * DAY + printed - (ahead ?? 0);
  return ahead === undefined ? { time, dated: true } : { time, dated: true, zone: ahead };
}

function offset(zone: string | undefined): number | undefined {
  if (zone === undefined) return undefined;
  if (zone.toUpperCase() === 'Z') return 0;
  const sign = zone.startsWith('-') ? -1 : 1;
  return sign * (Number(zone.slice(1, 3)) * HOUR + Number(zone.slice(-2)) * MINUTE);
}

/** The day of a time, since 1970; `undefined` if it has no date with a year. */
function dayIn(plain: string): number | undefined {
  const date = DATE.exec(plain) ?? JOINED_DATE.exec(plain);
  if (date) return dayOf(date);
  const american = AMERICAN_DATE.exec(plain);
  const [day, name = '', year] = american
    ? [american[2], american[1], american[3]]
    : (NAMED_DATE.exec(plain)?.slice(1) ?? []);
  const month = MONTHS.split(' ').indexOf(name.toLowerCase());
  return month < 0 ? undefined : daysFrom(Number(year), month + 1, Number(day));
}

function dayOf([, year, month, day, first, mark, second, last]: RegExpExecArray): number {
  if (year !== undefined) return daysFrom(Number(year), Number(month), Number(day));
  const [a, b] = [Number(first), Number(second)];
  const american = (mark === '/' && a <= 12) || b > 12;
  return american ? daysFrom(Number(last), a, b) : daysFrom(Number(last), b, a);
}

/** What makes times of records the clock that their source prints. */
export interface PrintedClock {
  /** `time + shift` is what it prints, in microseconds: since 1970, since midnight, or since some start. */
  readonly shift: number;
  /** A date with its zone, so that `time` is UTC; a date of a zone that is not named; the time of day; or a count from some start. */
  readonly shows: 'zone' | 'date' | 'day' | 'count';
}

/**
 * Times of a log one after another, as they are kept: since 1970 where the log has dates, else since its first one. A clock
 * without a date that goes back by more than half a day has passed midnight; behind a date it is of that day.
 */
export class LogClock {
  #shows: PrintedClock['shows'] | undefined;
  #zone = 0;
  #first: number | undefined;
  #before = 0;
  /** The day without a date: since 1970 where another time has one. */
  #day = 0;

  /** A time with its day; `since` makes it that of a record. */
  read(text: string | undefined): number | undefined {
    const found = text === undefined ? undefined : clockTime(text);
    if (found === undefined) return undefined;
    const { dated, zone, counts } = found;
    this.#shows ??= dated ? (zone === undefined ? 'date' : 'zone') : counts ? 'count' : 'day';
    if (dated) {
      this.#zone = zone ?? this.#zone;
      this.#day = Math.floor(found.time / DAY);
      this.#before = found.time % DAY;
      return found.time;
    }
    if (this.#before - found.time > DAY / 2) this.#day++;
    this.#before = found.time;
    return found.time + this.#day * DAY;
  }

  /** A time that was read, since 1970 or since the first that was asked for. */
  since(time: number): number {
    if (this.#shows === 'date' || this.#shows === 'zone') return time;
    this.#first ??= time;
    return time - this.#first;
  }

  /** What the times mean; `undefined` if there are none. */
  get printed(): PrintedClock | undefined {
    const shows = this.#shows;
    if (shows === undefined) return undefined;
    return { shows, shift: shows === 'zone' ? this.#zone : (this.#first ?? 0) };
  }
}

/** A time as a clock prints it, so that it is read as the same; without a clock as UTC, since 1970. */
export function printedTime(time: number, clock?: PrintedClock): string {
  const { shift, shows } = clock ?? { shift: 0, shows: undefined };
  const micro = Math.round(time + shift);
  if (shows === 'count') return (micro / SECOND).toFixed(FRACTION_DIGITS);
  const ofDay = ((micro % DAY) + DAY) % DAY;
  const two = (value: number) => String(Math.floor(value)).padStart(2, '0');
  const minutes = (value: number) => `${two(value / HOUR)}:${two((value % HOUR) / MINUTE)}`;
  const fraction = String(ofDay % SECOND).padStart(FRACTION_DIGITS, '0');
  const text = `${minutes(ofDay)}:${two((ofDay % MINUTE) / SECOND)}.${fraction}`;
  if (shows === 'day') return text;
  const zone = shows === 'zone' ? `${shift < 0 ? '-' : '+'}${minutes(Math.abs(shift))}` : shows === 'date' ? '' : 'Z';
  return `${dateText(Math.floor(micro / DAY))}T${text}${zone}`;
}

/** What has been read of a file that this page has saved. */
export interface TraceFile {
  readonly records: readonly CaptureRecord[];
  readonly clock: PrintedClock | undefined;
}

/** The clock that prints a text for a time of a record; `undefined` for UTC. */
export function clockOf(text: string, time: number): PrintedClock | undefined {
  const found = clockTime(text);
  if (found === undefined || text.endsWith('Z')) return undefined;
  const { dated, zone, counts } = found;
  if (!dated) return { shows: counts ? 'count' : 'day', shift: found.time - time };
  return zone === undefined ? { shows: 'date', shift: 0 } : { shows: 'zone', shift: zone };
}
