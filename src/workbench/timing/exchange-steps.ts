import { type ExchangeTimes, exchangeTimes, type SerialMode } from '../../modbus/index.ts';
import type { SetLine } from './timing-entries.ts';

/** All that the times of an exchange follow from. */
export interface ExchangeInputs {
  readonly line: SetLine;
  readonly mode: SerialMode;
  /** Characters; a reply of 0 if no device answers. */
  readonly request: number;
  readonly reply: number;
  /** Microseconds: until the device answers, or the turnaround if no device does. */
  readonly delay: number;
}

export type ExchangeStepKind = 'request' | 'turnaround' | 'silence-and-answer' | 'answer' | 'reply' | 'silence';

/** A part of an exchange, and how long it takes in microseconds. */
export interface ExchangeStep {
  readonly kind: ExchangeStepKind;
  readonly time: number;
  /** Whether the line is silent. */
  readonly silent: boolean;
}

/** How long an exchange takes, step by step until the next request may begin. */
export interface TimedExchange {
  readonly times: ExchangeTimes;
  readonly steps: readonly ExchangeStep[];
  /** The share of the time in which the line is silent, 0 to 1. */
  readonly silent: number;
}

/** Times an exchange. In RTU a device that is ready before t3.5 waits for it. */
export function timedExchange(inputs: ExchangeInputs): TimedExchange {
  const { mode, reply, delay, line } = inputs;
  const times = exchangeTimes({ ...inputs, silences: line.silences });
  const waits = mode === 'rtu' && delay <= line.silences.t35;
  const pause = reply === 0 ? 'turnaround' : waits ? 'silence-and-answer' : 'answer';
  const steps: ExchangeStep[] = [
    { kind: 'request', time: times.request, silent: false },
    { kind: pause, time: times.pause, silent: true },
  ];
  if (reply > 0) steps.push({ kind: 'reply', time: times.reply, silent: false });
  if (times.after > 0) steps.push({ kind: 'silence', time: times.after, silent: true });
  return { times, steps, silent: (times.total - times.request - times.reply) / times.total };
}
