import { dateOf, daysFrom } from '../../calendar.ts';

/** A date and a time of day, as a device has it; of no time zone. */
export type Moment = readonly [
  year: number,
  month: number,
  day: number,
  hour: number,
  minute: number,
  second: number,
  ms: number,
];

const pad = (value: number, digits = 2) => String(value).padStart(digits, '0');

const DAY = 86_400_000;
/** The day of the week of a date, 1 is Monday. */
export const weekdayOf = ([year, month, day]: Moment): number => ((((daysFrom(year, month, day) + 3) % 7) + 7) % 7) + 1;

/** Milliseconds since 1970; `undefined` if there is no such date or time of day. */
export function millisecondsOf([year, month, day, hour, minute, second, ms]: Moment): number | undefined {
  const days = daysFrom(year, month, day);
  const there = dateOf(days);
  const exists = month >= 1 && month <= 12 && there[0] === year && there[1] === month && there[2] === day;
  const inDay = ((hour * 60 + minute) * 60 + second) * 1000 + ms;
  return exists && hour < 24 && minute < 60 && second < 60 && ms < 1000 ? days * DAY + inDay : undefined;
}

/** The date and time of milliseconds since 1970, before the year 10000. */
export function momentOf(milliseconds: number): Moment | undefined {
  const days = Math.floor(milliseconds / DAY);
  const date = dateOf(days);
  if (!(date[0] >= 0 && date[0] <= 9999)) return undefined;
  const inDay = milliseconds - days * DAY;
  const seconds = Math.floor(inDay / 1000);
  return [...date, Math.floor(seconds / 3600), Math.floor(seconds / 60) % 60, seconds % 60, inDay % 1000];
}

/** `2026-11-30 07:25:12`, with milliseconds where they are not 0; `undefined` if there is no such date. */
export function momentText(moment: Moment): string | undefined {
  if (millisecondsOf(moment) === undefined) return undefined;
  const [year, month, day, hour, minute, second, ms] = moment;
  return `${pad(year, 4)}-${pad(month)}-${pad(day)} ${pad(hour)}:${pad(minute)}:${pad(second)}${ms ? `.${pad(ms, 3)}` : ''}`;
}

const MOMENT = /^(\d{4})-(\d\d)-(\d\d)(?:[ T]+(\d\d):(\d\d)(?::(\d\d)(?:\.(\d{1,3}))?)?)?\s*(?:Z|UTC)?$/i;

/** Reads `2026-11-30 07:25:12.345`; what is absent of the time is 0. */
export function readMoment(text: string): Moment | undefined {
  const found = MOMENT.exec(text.trim());
  if (found === null) return undefined;
  const [year = 0, month = 0, day = 0, hour = 0, minute = 0, second = 0] = found
    .slice(1, 7)
    .map((part) => Number(part ?? 0));
  const moment: Moment = [year, month, day, hour, minute, second, Number((found[7] ?? '').padEnd(3, '0'))];
  return millisecondsOf(moment) === undefined ? undefined : moment;
}
