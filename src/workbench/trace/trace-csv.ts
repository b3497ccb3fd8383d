import type { Profile } from '../../devices/index.ts';
import { dateText, spacedHex, toHex } from '../../modbus/index.ts';
import { writeCsvFile } from '../../notation/index.ts';
import type { Trace } from '../../trace/index.ts';
import { rowOf, type TraceRow } from './row.ts';

const COLUMNS = [
  'number',
  'time',
  'side',
  'transport',
  'from',
  'to',
  'unit',
  'function',
  'exception',
  'address',
  'quantity',
  'reply_ms',
  'faults',
  'known',
  'says',
  'bytes',
] as const;

const DAY = 86_400_000_000;
const SECOND = 1_000_000;
const MINUTE = 60;
const HOUR = 3600;
const YEAR = 365 * DAY;
const MICRO_DIGITS = 6;

/** Whether a time has a date: those before 1971 are since a first record. */
export const isDated = (time: number): boolean => time >= YEAR;

/** A time of a record in a table: a date (ISO 8601, UTC), or seconds where the source knows no date. */
export function timeCell(time: number | undefined): string {
  if (time === undefined) return '';
  const micro = Math.round(time);
  const two = (value: number) => String(Math.floor(value)).padStart(2, '0');
  if (!isDated(micro)) return (micro / SECOND).toFixed(MICRO_DIGITS);
  const seconds = Math.floor((micro % DAY) / SECOND);
  const clock = `${two(seconds / HOUR)}:${two((seconds / MINUTE) % MINUTE)}:${two(seconds % MINUTE)}`;
  return `${dateText(Math.floor(micro / DAY))}T${clock}.${String(micro % SECOND).padStart(MICRO_DIGITS, '0')}Z`;
}

/** The frames of a trace as a table for spreadsheets (RFC 4180): its lines, each with its end. `says` is the sentence of a row. */
export function* traceCsvLines(
  trace: Trace,
  indexes: Iterable<number>,
  says: (row: TraceRow) => string,
  profile?: Profile,
): Generator<string, void, undefined> {
  yield writeCsvFile([[...COLUMNS]]);
  for (const index of indexes) {
    const row = rowOf(trace, index, profile);
    const { from, to, bytes, known } = trace.plain(index);
    const { address, quantity } = trace.subject(row.exchange);
    const { time, side, transport, unit, functionCode, exception, after, faults } = row;
    const cells: readonly unknown[] = [
      index + 1,
      timeCell(time),
      side,
      transport,
      from,
      to,
      unit,
      functionCode,
      exception,
      address,
      address === undefined ? '' : quantity,
      after === undefined ? '' : after / 1000,
      faults.map(({ kind, code }) => (code === kind ? kind : `${kind}: ${code}`)).join('; '),
      known?.beside ?? known?.outcome,
      // A line of the table is a line of the file.
      says(row).replace(/\s+/g, ' '),
      spacedHex(toHex(bytes)),
    ];
    yield writeCsvFile([cells.map((cell) => String(cell ?? ''))]);
  }
}
