import { itemsOf, type Place, type PollSample, Samples } from '../../bus/index.ts';
import { powerIn } from '../../devices/index.ts';
import { failureOf, type ReadFailure } from './map-values.ts';
import { heldBy, isNumber, numberOf, type PollSource } from './poll-source.ts';

/** Values that are drawn until others are chosen, and at most. */
const DRAWN_AT_FIRST = 3;
export const MOST_DRAWN = 8;

/** The reply to one request of a round. */
interface RoundReply {
  /** Its registers or bits; `undefined` if it has none that count. */
  readonly list: readonly number[] | undefined;
  /** It may be the reply to another request. */
  readonly isDoubtful: boolean;
  /** Why it has none that count. */
  readonly failure: ReadFailure | undefined;
}

/** How often requests have failed for one reason. */
export interface FailureCount {
  readonly failure: ReadFailure;
  readonly count: number;
}

/** Everything that a poll has read. Its samples, items, powers, failures and replies change while it runs. */
export interface Polled {
  readonly source: PollSource;
  readonly interval: number;
  readonly samples: Samples;
  /** The registers or bits of each value, from its last reading; `undefined` if that failed. */
  readonly items: (readonly number[] | undefined)[];
  /** The power of ten of each value with a scale register, from its last reading; `undefined` if it is not known. */
  readonly powers: (number | undefined)[];
  /** Why the last reading of each value failed; `undefined` if it did not. */
  readonly failures: (ReadFailure | undefined)[];
  /** The replies of this round, by request. */
  readonly replies: (RoundReply | undefined)[];
  /** The values that are drawn, by their place among all. */
  readonly drawn: readonly number[];
  readonly requests: number;
  readonly failed: number;
  /** Why they failed, in the order in which the reasons came up. */
  readonly reasons: readonly FailureCount[];
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
    powers: new Array<undefined>(source.values.length).fill(undefined),
    failures: new Array<undefined>(source.values.length).fill(undefined),
    replies: [],
    drawn: numbers.slice(0, DRAWN_AT_FIRST),
    requests: 0,
    failed: 0,
    reasons: [],
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
  const { source, samples, items, powers, failures, replies } = polled;
  // A round without readings is a gap in the chart.
  if (index === 0) {
    samples.begin(time);
    replies.length = 0;
  }
  if (outcome === 'lost' || outcome === 'cancelled' || (outcome === 'not-sent' && !isOpen)) return polled;
  const request = source.requests[index];
  const read = source.reads[index];
  if (request === undefined || read === undefined) return polled;
  const list = reply && unsure === undefined ? itemsOf(read, request, reply, source.transport) : undefined;
  const failure = list === undefined && unsure === undefined ? failureOf(sample) : undefined;
  replies[index] = { list, isDoubtful: unsure !== undefined, failure };
  const itemsAt = ({ read, at, size }: Place) => replies[read]?.list?.slice(at, at + size);
  for (const [number, value] of source.values.entries()) {
    const { where, power = where } = value;
    // A value counts when its power of ten has come too, which may stand in the reply to another request.
    if (index !== Math.max(where.read, power.read)) continue;
    const held = itemsAt(where);
    const raw = held && heldBy(value, held);
    items[number] = held;
    failures[number] = replies[where.read]?.failure;
    powers[number] = value.power && powerIn(itemsAt(power)?.[0]);
    if (replies[where.read]?.isDoubtful || replies[power.read]?.isDoubtful) samples.doubted(number);
    else if (raw === undefined) samples.failed(number);
    else samples.read(number, time, raw, numberOf(raw, value, powers[number]));
  }
  return {
    ...polled,
    requests: polled.requests + 1,
    failed: polled.failed + (failure ? 1 : 0),
    reasons: failure ? withFailure(polled.reasons, failure) : polled.reasons,
    doubtful: polled.doubtful + (unsure === undefined ? 0 : 1),
    slow,
  };
}

function withFailure(reasons: readonly FailureCount[], failure: ReadFailure): readonly FailureCount[] {
  const isSame = ({ failure: one }: FailureCount) =>
    one.outcome === failure.outcome && one.verdict === failure.verdict && one.exceptionCode === failure.exceptionCode;
  if (!reasons.some(isSame)) return [...reasons, { failure, count: 1 }];
  return reasons.map((one) => (isSame(one) ? { ...one, count: one.count + 1 } : one));
}
