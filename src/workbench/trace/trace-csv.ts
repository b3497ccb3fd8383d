import { type PrintedClock, printedTime } from '../../captures/index.ts';
import type { Profile } from '../../devices/index.ts';
import { spacedHex, toHex } from '../../modbus/index.ts';
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

const YEAR = 365 * 86_400_000_000;
const COUNTED: PrintedClock = Object.freeze({ shift: 0, shows: 'count' });

/** Whether a time has a date: those before 1971 are since a first record. */
export const isDated = (time: number): boolean => time >= YEAR;

/** What the times of a source mean that prints no clock: UTC since 1970 (`undefined`), or a count from a first record. */
export const clockOfTimes = (last: number | undefined): PrintedClock | undefined =>
  last === undefined || isDated(last) ? undefined : COUNTED;

/** A time of a record in a table: as its source prints it, else a date (ISO 8601, UTC), or seconds where no date is known. */
export const timeCell = (time: number | undefined, clock = clockOfTimes(time)): string =>
  time === undefined ? '' : printedTime(time, clock);

/** The frames of a trace as a table for spreadsheets (RFC 4180): its lines, each with its end. `says` is the sentence of a row. */
export function* traceCsvLines(
  trace: Trace,
  indexes: Iterable<number>,
  says: (row: TraceRow) => string,
  { profile, clock }: { readonly profile?: Profile | undefined; readonly clock?: PrintedClock | undefined } = {},
): Generator<string, void, undefined> {
  yield writeCsvFile([[...COLUMNS]]);
  for (const index of indexes) {
    const row = rowOf(trace, index, profile);
    const { from, to, bytes, known } = trace.plain(index);
    const isFrame = trace.isFrame(index);
    const { address, quantity } = trace.subject(row.exchange);
    const { time, side, transport, unit, functionCode, exception, after, faults } = row;
    const cells: readonly unknown[] = [
      index + 1,
      timeCell(time, clock),
      side,
      transport,
      from,
      to,
      isFrame ? unit : '',
      isFrame ? functionCode : '',
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
