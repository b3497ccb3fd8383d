import { asciiGapEffect, pollingTime, type SerialMode } from '../../modbus/index.ts';
import type { Draft } from '../frame/draft.ts';
import { type ExchangeSizes, exchangeSizes } from './exchange-sizes.ts';
import { type ExchangeInputs, timedExchange } from './exchange-steps.ts';
import { type GapReading, gapReading } from './line-silences.ts';
import {
  baudEntry,
  charactersEntry,
  devicesEntry,
  type Entry,
  knownOf,
  missingEntry,
  type SetLine,
  type TimingName,
  type TimingTexts,
  timeEntry,
  timingLine,
  timingMode,
} from './timing-entries.ts';

/** Asking every device of a line once; times in microseconds. */
export interface Round {
  readonly devices: number;
  readonly missing: number;
  /** A broadcast goes to all devices at once: `time` is that of the exchange. */
  readonly toAll: boolean;
  readonly time: number;
  /** Of this, the time spent on devices that do not answer. */
  readonly lost: number;
  /** Whether a device answers only after the response time-out. */
  readonly tooLate: boolean;
}

/** What can be typed. */
export type TypedTiming = Exclude<TimingName, 'mode' | 'format' | 'counted'>;

/** What the texts come to; `undefined` stands for what follows from a text that has to be corrected. */
export interface TimingReading {
  readonly mode: SerialMode;
  readonly line: SetLine | undefined;
  readonly sizes: ExchangeSizes;
  /** What each text comes to. */
  readonly entries: Readonly<Record<TypedTiming, Entry<number | undefined>>>;
  /** Whether a device answers: its delay counts then, and else the turnaround. */
  readonly answered: boolean;
  readonly exchange: ExchangeInputs | undefined;
  readonly round: Round | undefined;
  readonly gap: GapReading | undefined;
}

/** Reads what was typed about a line that carries the frame of a draft. */
export function readTiming(texts: TimingTexts, draft: Draft): TimingReading {
  const mode = timingMode(texts, draft.transport);
  const line = timingLine(texts);
  const sizes = exchangeSizes(draft, mode);
  const devices = devicesEntry(texts);
  const entries = {
    baud: baudEntry(texts),
    request: charactersEntry(texts.request, mode, 1, sizes.request),
    reply: charactersEntry(texts.reply, mode, 0, sizes.reply),
    delay: timeEntry(texts.delay, line),
    turnaround: timeEntry(texts.turnaround, line),
    devices,
    missing: missingEntry(texts, knownOf(devices) ?? 0),
    timeout: timeEntry(texts.timeout, line),
    gap: timeEntry(texts.gap, line),
  };
  const answered = knownOf(entries.reply) !== 0;
  const [request, reply, gap] = [entries.request, entries.reply, entries.gap].map(knownOf);
  const delay = knownOf(answered ? entries.delay : entries.turnaround);
  const known = line !== undefined && request !== undefined && reply !== undefined && delay !== undefined;
  const exchange = known ? { line, mode, request, reply, delay } : undefined;
  return {
    mode,
    line,
    sizes,
    entries,
    answered,
    exchange,
    round: exchange && readRound(exchange, [devices, entries.missing, entries.timeout]),
    gap:
      gap === undefined || line === undefined
        ? undefined
        : mode === 'rtu'
          ? gapReading(gap, line)
          : { effect: asciiGapEffect(gap), other: undefined },
  };
}

function readRound(inputs: ExchangeInputs, entries: readonly Entry[]): Round | undefined {
  const [devices, missing, timeout] = entries.map(knownOf);
  if (devices === undefined || missing === undefined || timeout === undefined) return undefined;
  const exchange = timedExchange(inputs).times;
  const toAll = inputs.reply === 0;
  return {
    devices,
    missing,
    toAll,
    time: toAll ? exchange.total : pollingTime({ exchange, devices, missing, timeout }),
    lost: pollingTime({ exchange, devices: missing, missing, timeout }),
    tooLate: !toAll && inputs.delay > timeout,
  };
}
