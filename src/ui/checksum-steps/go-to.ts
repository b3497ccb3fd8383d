import { readNumber } from '../../notation/index.ts';
import { type Place, SHIFTS } from './rows.ts';

const PARTS = /^([^.]+)(?:\.([^.]+))?$/;

/** The place that a text says, a byte or `byte.shift`; `undefined` where there is none such. */
export function placeOf(text: string, bytes: number): Place | undefined {
  const parts = PARTS.exec(text.trim());
  const at = readNumber(parts?.[1] ?? '');
  const shift = parts?.[2] === undefined ? 0 : readNumber(parts[2]);
  const within = (value: number | undefined, most: number): value is number =>
    Number.isInteger(value) && (value as number) >= 0 && (value as number) <= most;
  return within(at, bytes - 1) && within(shift, SHIFTS) ? { at, shift } : undefined;
}
