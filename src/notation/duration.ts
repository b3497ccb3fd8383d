import { readNumber } from './number.ts';

/** A length of time as typed. */
export interface Duration {
  readonly amount: number;
  readonly unit: 'us' | 'ms' | 's' | 'bits' | 'characters';
}

/** Seconds come last: others end in `s` too. */
const UNITS: readonly { readonly pattern: RegExp; readonly unit: Duration['unit'] }[] = [
  { pattern: /[uµμ]s$/i, unit: 'us' },
  { pattern: /ms$/i, unit: 'ms' },
  { pattern: /char(acter)?s?$/i, unit: 'characters' },
  { pattern: /bits?$/i, unit: 'bits' },
  { pattern: /s$/i, unit: 's' },
];
/** With three digits behind it, a comma may as well stand between thousands. */
const COMMA = /^(\d+),(\d{1,2}|\d{4,})$/;

/**
 * A length of time as people write it: `5 ms`, `750us`, `1.5 s`, `20 bits`, `1.5 characters`; milliseconds without a unit. A
 * decimal comma is taken, and so are the hexadecimal forms of `readNumber`. `undefined` if the text is not a
 * duration, or is negative.
 */
export function readDuration(text: string): Duration | undefined {
  const trimmed = text.trim();
  const found = UNITS.find(({ pattern }) => pattern.test(trimmed));
  const number = found ? trimmed.replace(found.pattern, '').trim() : trimmed;
  const amount = readNumber(number.replace(COMMA, '$1.$2'));
  return amount === undefined || amount < 0 ? undefined : { amount, unit: found?.unit ?? 'ms' };
}
