import papa from 'papaparse';
import type { Samples } from '../../bus/index.ts';
import type { Value } from '../../modbus/index.ts';
import { pollWords as words } from './language.ts';
import type { PolledValue } from './source.ts';

/** Digits that say all of a float of 32 bits, and of one of 64 bits that was scaled. */
const DIGITS: Readonly<Record<string, number>> = { f16: 4, f32: 7 };

/** The rounds that are kept, each with its time and a column a value, as spreadsheets know UTF-8. */
export function samplesAsCsv(samples: Samples, values: readonly PolledValue[]): string {
  const header = [
    words.timeColumn,
    ...values.map(({ name, register: { unit } }) => (unit ? `${name} (${unit})` : name)),
  ];
  const rows = Array.from({ length: samples.length }, (_, round) => [
    new Date(samples.timeOf(round)).toISOString(),
    ...values.map(({ register: { type } }, value) => cellOf(samples.valueOf(value, round), type)),
  ]);
  return `\uFEFF${papa.unparse([header, ...rows])}\r\n`;
}

/** A number with a point, however the reader's machine writes numbers; empty where nothing was read. */
function cellOf(value: Value | undefined, type: string): string {
  if (typeof value !== 'number') return value === undefined ? '' : String(value);
  return String(Number.isFinite(value) ? Number(value.toPrecision(DIGITS[type] ?? 15)) : value);
}
