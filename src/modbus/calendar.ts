/** Days of 400 years, and those from 1 March of year 0 to 1 January 1970. */
const ERA = 146_097;
const TO_1970 = 719_468;

/** Days from 1970-01-01 to a date of the Gregorian calendar. Years begin in March here, so that the day that leap years have is their last. */
export function daysFrom(year: number, month: number, day: number): number {
  const march = month <= 2 ? year - 1 : year;
  const era = Math.floor(march / 400);
  const inEra = march - 400 * era;
  const inYear = Math.floor((153 * (month + (month > 2 ? -3 : 9)) + 2) / 5) + day - 1;
  return ERA * era + 365 * inEra + Math.floor(inEra / 4) - Math.floor(inEra / 100) + inYear - TO_1970;
}

/** The date of a day, counted from 1970-01-01. */
export function dateOf(days: number): readonly [year: number, month: number, day: number] {
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

/** The date of a day, counted from 1970-01-01: `2026-11-30`. The years are 0 to 9999. */
export function dateText(days: number): string {
  const [year, month, day] = dateOf(days);
  const digits = (value: number, width: number) => String(value).padStart(width, '0');
  return `${digits(year, 4)}-${digits(month, 2)}-${digits(day, 2)}`;
}
