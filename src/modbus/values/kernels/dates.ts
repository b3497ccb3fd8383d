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
/** Days of 400 years, and those from 1 March of year 0 to 1 January 1970. */
const ERA = 146_097;
const TO_1970 = 719_468;

/** Days since 1970 of a date. Years begin in March here, so that the day that leap years have is their last. */
function daysOf(year: number, month: number, day: number): number {
  const march = year - (month <= 2 ? 1 : 0);
  const era = Math.floor(march / 400);
  const inEra = march - 400 * era;
  const inYear = Math.floor((153 * ((month + 9) % 12) + 2) / 5) + day - 1;
  return ERA * era + 365 * inEra + Math.floor(inEra / 4) - Math.floor(inEra / 100) + inYear - TO_1970;
}

function dateOf(days: number): readonly [number, number, number] {
  const all = days + TO_1970;
  const era = Math.floor(all / ERA);
  const inEra = all - ERA * era;
  const years = Math.floor(
    (inEra - Math.floor(inEra / 1460) + Math.floor(inEra / 36_524) - Math.floor(inEra / 146_096)) / 365,
  );
  const inYear = inEra - (365 * years + Math.floor(years / 4) - Math.floor(years / 100));
  const march = Math.floor((5 * inYear + 2) / 153);
  const month = march < 10 ? march + 3 : march - 9;
  return [years + 400 * era + (month <= 2 ? 1 : 0), month, inYear - Math.floor((153 * march + 2) / 5) + 1];
}

/** The day of the week of a date, 1 is Monday. */
export const weekdayOf = ([year, month, day]: Moment): number => ((((daysOf(year, month, day) + 3) % 7) + 7) % 7) + 1;

/** Milliseconds since 1970; `undefined` if there is no such date or time of day. */
export function millisecondsOf([year, month, day, hour, minute, second, ms]: Moment): number | undefined {
  const days = daysOf(year, month, day);
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
