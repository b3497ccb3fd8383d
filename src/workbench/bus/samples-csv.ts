import type { Samples } from '../../bus/index.ts';
import type { Register } from '../../devices/index.ts';
import { shownDigits, type Value } from '../../modbus/index.ts';
import { writeCsvFile } from '../../notation/index.ts';
import type { PolledValue } from './poll-source.ts';

export interface SamplesWords {
  readonly timeColumn: string;
  /** A time in milliseconds since 1970. */
  readonly timeCell: (time: number) => string;
}

/** The rounds that are kept, each with its time and a column a value, as spreadsheets know UTF-8. */
export function samplesAsCsv(samples: Samples, values: readonly PolledValue[], words: SamplesWords): string {
  const header = [
    words.timeColumn,
    ...values.map(({ name, register: { unit } }) => (unit ? `${name} (${unit})` : name)),
  ];
  const rows = Array.from({ length: samples.length }, (_, round) => [
    words.timeCell(samples.timeOf(round)),
    ...values.map(({ register: { type } }, value) => cellOf(samples.valueOf(value, round), type)),
  ]);
  return writeCsvFile([header, ...rows], 'marked');
}

/** A number with a point, however the reader's machine writes numbers; empty if nothing was read. */
function cellOf(value: Value | undefined, type: Register['type']): string {
  if (typeof value !== 'number') return value === undefined ? '' : String(value);
  return String(Number.isFinite(value) ? Number(value.toPrecision(shownDigits(type))) : value);
}
