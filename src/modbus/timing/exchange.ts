import { demandPositive } from '../demand.ts';
import type { SerialLine, SerialMode } from './serial-format.ts';
import { charactersTime, type Silences } from './silences.ts';

/** A request and what follows it on the line. */
export interface Exchange {
  readonly mode: SerialMode;
  readonly line: SerialLine;
  /** The silences between RTU frames; ASCII has no such silences. */
  readonly silences: Silences;
  /** Characters of the request. */
  readonly request: number;
  /** Characters of the reply; 0 if no device answers. */
  readonly reply: number;
  /** Microseconds from the request's last character to the reply's first, or to the next request if no device answers. */
  readonly delay: number;
}

/** How long the parts of an exchange take, in microseconds. */
export interface ExchangeTimes {
  readonly request: number;
  /** Until the reply, or until the next request if no device answers: the delay, in RTU at least t3.5. */
  readonly pause: number;
  readonly reply: number;
  /** Between the reply and the next request: t3.5 in RTU, nothing in ASCII. */
  readonly after: number;
  /** Until the next request may begin. */
  readonly total: number;
}

/**
 * How long an exchange takes at the least (SL 2.4.1, 2.5.1.1). Throws a `RangeError` for numbers that are not finite or below
 * 0.
 */
export function exchangeTimes({ mode, line, silences, request, reply, delay }: Exchange): ExchangeTimes {
  demandPositive('delay', delay, 'or-zero');
  const silence = mode === 'rtu' ? silences.t35 : 0;
  const times = {
    request: charactersTime(line, request),
    pause: Math.max(delay, silence),
    reply: charactersTime(line, reply),
    after: reply > 0 ? silence : 0,
  };
  return { ...times, total: times.request + times.pause + times.reply + times.after };
}

/** Devices asked one after the other. */
export interface Polling {
  readonly exchange: ExchangeTimes;
  readonly devices: number;
  /** How many of them do not answer. */
  readonly missing: number;
  /** Microseconds of waiting for an answer after the request (SL 2.4.1). */
  readonly timeout: number;
}

/**
 * How long it takes to ask every device once, in microseconds. Throws a `RangeError` for numbers that are not finite or below
 * 0.
 */
export function pollingTime({ exchange, devices, missing, timeout }: Polling): number {
  demandPositive('devices that answer', devices - missing, 'or-zero');
  demandPositive('devices that are missing', missing, 'or-zero');
  demandPositive('timeout', timeout, 'or-zero');
  return (devices - missing) * exchange.total + missing * (exchange.request + timeout);
}
