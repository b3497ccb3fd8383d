import { signal } from '@preact/signals';
import type { TraceState } from '../../../store/index.ts';
import type { TraceRow } from '../../../workbench/index.ts';

/** How times are shown: as a clock, or since the first record. */
export type TimeKind = 'clock' | 'since';
export const timeKind = signal<TimeKind>('clock');

const MILLISECOND = 1000;
const SECOND = 1_000_000;

const format = (timeZone: string | undefined) =>
  new Intl.DateTimeFormat(undefined, {
    hour: '2-digit',
    minute: '2-digit',
    second: '2-digit',
    fractionalSecondDigits: 3,
    hourCycle: 'h23',
    timeZone,
  });
/** Texts print the clock of whoever wrote them; files have the time since 1970. */
const printed = format('UTC');
const local = format(undefined);
const seconds = new Intl.NumberFormat(undefined, { minimumFractionDigits: 6, maximumFractionDigits: 6 });

/** The time of a row as text; empty if it is not known. */
export function timeText(
  { time, since }: Pick<TraceRow, 'time' | 'since'>,
  kind: TimeKind,
  source: TraceState,
): string {
  if (kind === 'since') return since === undefined ? '' : seconds.format(since / SECOND);
  if (time === undefined) return '';
  const clock = source.kind === 'open' ? source.clock : undefined;
  return clock === undefined ? local.format(time / MILLISECOND) : printed.format((time + clock.shift) / MILLISECOND);
}
