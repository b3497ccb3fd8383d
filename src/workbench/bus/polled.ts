import { itemsOf, type PollSample, Samples } from '../../bus/index.ts';
import { heldBy, isNumber, numberOf, type PollSource } from './poll-source.ts';

/** Values that are drawn until others are chosen, and at most. */
const DRAWN_AT_FIRST = 3;
export const MOST_DRAWN = 8;

/** Everything that a poll has read. Its samples and items grow while it runs. */
export interface Polled {
  readonly source: PollSource;
  readonly interval: number;
  readonly samples: Samples;
  /** The registers or bits of each value, from its last reading; `undefined` if that failed. */
  readonly items: (readonly number[] | undefined)[];
  /** The values that are drawn, by their place among all. */
  readonly drawn: readonly number[];
  readonly requests: number;
  readonly failed: number;
  /** Requests whose reply may have been that to another one. */
  readonly doubtful: number;
  /** How long the last answers took, in milliseconds, if they came after the time-out. */
  readonly slow: number | undefined;
}

/** A poll in which nothing has been read yet. */
export function newPolled(source: PollSource, interval: number): Polled {
  const numbers = source.values.flatMap((value, index) => (isNumber(value) ? [index] : []));
  return {
    source,
    interval,
    samples: new Samples(source.values.length),
    items: new Array<undefined>(source.values.length).fill(undefined),
    drawn: numbers.slice(0, DRAWN_AT_FIRST),
    requests: 0,
    failed: 0,
    doubtful: 0,
    slow: undefined,
  };
}

/** With a value that is drawn, or is drawn no longer; the same if there are as many as can be drawn. */
export function withDrawn(polled: Polled, value: number, drawn: boolean): Polled {
  const others = polled.drawn.filter((other) => other !== value);
  if (drawn && others.length >= MOST_DRAWN) return polled;
  return { ...polled, drawn: drawn ? [...others, value].toSorted((a, b) => a - b) : others };
}

/**
 * Adds the outcome of one request of a round. `isOpen` is whether there is still a line: a request that was not sent because
 * there was none says nothing about a device.
 */
export function withSample(polled: Polled, sample: PollSample, isOpen: boolean): Polled {
  const { index, time, outcome, reply, unsure, slow } = sample;
  const { source, samples, items } = polled;
  // A round without readings is a gap in the chart.
  if (index === 0) samples.begin(time);
  if (outcome === 'lost' || outcome === 'cancelled' || (outcome === 'not-sent' && !isOpen)) return polled;
  const request = source.requests[index];
  const read = source.reads[index];
  if (request === undefined || read === undefined) return polled;
  const list = reply && unsure === undefined ? itemsOf(read, request, reply, source.transport) : undefined;
  for (const [number, value] of source.values.entries()) {
    const { where } = value;
    if (where.read !== index) continue;
    const held = list?.slice(where.at, where.at + where.size);
    const raw = held && heldBy(value, held);
    items[number] = held;
    if (unsure !== undefined) samples.doubted(number);
    else if (raw === undefined) samples.failed(number);
    else samples.read(number, time, raw, numberOf(raw, value));
  }
  const isFailed = list === undefined && unsure === undefined;
  return {
    ...polled,
    requests: polled.requests + 1,
    failed: polled.failed + (isFailed ? 1 : 0),
    doubtful: polled.doubtful + (unsure === undefined ? 0 : 1),
    slow,
  };
}
