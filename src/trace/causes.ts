import { decodeFrame, isAgainstRequest } from '../modbus/index.ts';
import type { Exchange, Fault, FaultKind } from './fault.ts';
import type { Trace } from './trace.ts';

/** Why many exchanges of a trace fail, and what shows it. Times are microseconds. */
export type TraceCause = CauseData & {
  /** The kind of fault that it explains: `explained` of the `all` there are. */
  readonly kind: FaultKind;
  readonly explained: number;
  readonly all: number;
  /** The exchanges it explains, in their order. */
  readonly exchanges: readonly number[];
};

type CauseData =
  /** These units never answer. */
  | { readonly code: 'unit-silent'; readonly units: readonly number[] }
  /** Replies come after the time-out, the slowest after `slowest`. */
  | { readonly code: 'timeout-short'; readonly slowest: number; readonly timeout: number }
  /** Each reply answers the request before, from exchange `from` on. */
  | { readonly code: 'one-too-late'; readonly from: number }
  /** A unit refuses (exception 02) all that reaches beyond `answered`, the end of the largest range it answered; 0 if it answered none. */
  | { readonly code: 'addresses-end'; readonly unit: number; readonly functionCode: number; readonly answered: number }
  /** Only frames of at least so many bytes are damaged. */
  | { readonly code: 'long-frames-damaged'; readonly least: number }
  /** Only frames of one unit are damaged. */
  | { readonly code: 'unit-damaged'; readonly unit: number }
  /** Requests are sent while another one waits for its reply; the shortest distance. */
  | { readonly code: 'requests-overlap'; readonly shortest: number }
  /** The adapter gives back what it sends. */
  | { readonly code: 'echo' }
  /** Requests follow the frame before after a silence shorter than t3.5. */
  | { readonly code: 'polled-too-fast'; readonly gap: number; readonly least: number };

export type CauseCode = CauseData['code'];

const named: Readonly<Record<CauseCode, true>> = {
  'unit-silent': true,
  'timeout-short': true,
  'one-too-late': true,
  'addresses-end': true,
  'long-frames-damaged': true,
  'unit-damaged': true,
  'requests-overlap': true,
  echo: true,
  'polled-too-fast': true,
};
/** Whether a text is the code of a cause. */
export const isCauseCode = (text: string): text is CauseCode => Object.hasOwn(named, text);

/** An exchange with its number. */
interface Numbered extends Exchange {
  readonly index: number;
}

/** A cause is worth saying if it explains so many faults of its kind, and this share of them. */
const LEAST = 3;
const SHARE = 0.8;
/** How unlikely a pattern must be by chance. */
const CHANCE = 0.000_01;
const NOT_THERE = 2;

type Found = { readonly data: CauseData; readonly explained: readonly number[] };
type Hypothesis = (failed: readonly Numbered[], trace: Trace, all: readonly Numbered[]) => Found | undefined;

const faultsOf = ({ faults }: Exchange, kind: FaultKind): readonly Fault[] =>
  faults.filter((fault) => fault.kind === kind);

/** The causes that are tried, each for the kind of fault that it explains. */
const hypotheses: readonly (readonly [FaultKind, Hypothesis])[] = [
  ['no-reply', overlapping],
  ['no-reply', silentUnits],
  ['late', slowReplies],
  ['mismatch', oneTooLate],
  ['exception', addressesEnd],
  ['checksum', oneUnit],
  ['checksum', longFrames],
  ['stray', echoes],
  ['timing', tooFast],
];

/**
 * Why exchanges of a trace fail, for the whole of it. A cause is given only if it explains at least four of five faults of its kind, and
 * three of them; faults that came by chance have none.
 */
export function causesOf(trace: Trace): readonly TraceCause[] {
  const { faults } = trace.summary();
  const tried = hypotheses.filter(([kind]) => faults[kind] >= LEAST);
  if (tried.length === 0) return [];
  const all = trace.exchanges(0, trace.exchangeCount).map((exchange, index) => ({ ...exchange, index }));
  const found: TraceCause[] = [];
  for (const [kind, hypothesis] of tried) {
    const failed = all.filter((exchange) => faultsOf(exchange, kind).length > 0);
    if (failed.length < LEAST || found.some((cause) => cause.kind === kind)) continue;
    const cause = hypothesis(failed, trace, all);
    const explained = cause?.explained.length ?? 0;
    if (cause === undefined || explained < LEAST || explained < SHARE * failed.length) continue;
    found.push({ ...cause.data, kind, explained, all: failed.length, exchanges: cause.explained });
  }
  return found;
}

const indexes = (list: readonly Numbered[]): readonly number[] => list.map(({ index }) => index);

/** Lists by a key. */
function grouped<K, T>(list: readonly T[], key: (one: T) => K): ReadonlyMap<K, readonly T[]> {
  const groups = new Map<K, T[]>();
  for (const one of list) {
    const group = groups.get(key(one));
    if (group) group.push(one);
    else groups.set(key(one), [one]);
  }
  return groups;
}

function silentUnits(failed: readonly Numbered[], trace: Trace, all: readonly Numbered[]): Found | undefined {
  const unitOf = ({ index }: Numbered) => trace.subject(index).unit;
  const answered = new Set(all.filter(({ replies }) => replies.length > 0).map(unitOf));
  // A list of requests, without a time and without any reply, is not a silent line.
  const isLine = answered.size > 0 || failed.some(({ request = 0 }) => trace.time(request) !== undefined);
  if (!isLine) return undefined;
  const silent = failed.filter((exchange) => !answered.has(unitOf(exchange)));
  const units = [...grouped(silent, unitOf)].filter(([, list]) => list.length >= LEAST).map(([unit]) => unit);
  const explained = silent.filter((exchange) => units.includes(unitOf(exchange)));
  return units.length === 0
    ? undefined
    : { data: { code: 'unit-silent', units: units.toSorted((a, b) => a - b) }, explained: indexes(explained) };
}

function slowReplies(failed: readonly Numbered[], trace: Trace): Found {
  const slowest = failed.reduce((most, { after = 0 }) => Math.max(most, after), 0);
  return { data: { code: 'timeout-short', slowest, timeout: trace.timeout }, explained: indexes(failed) };
}

/** Replies that do not answer their request, but the one before it. */
function oneTooLate(failed: readonly Numbered[], trace: Trace, all: readonly Numbered[]): Found | undefined {
  const explained = failed.filter(({ index, replies: [reply] }) => {
    const before = all[index - 1]?.request;
    if (before === undefined || reply === undefined) return false;
    const { transport } = trace.spoken(reply);
    const reading = decodeFrame(trace.bytes(reply), { transport, direction: 'response', request: trace.bytes(before) });
    return reading.outcome.kind === 'whole' && !isAgainstRequest(reading);
  });
  const [first] = explained;
  return first && { data: { code: 'one-too-late', from: first.index }, explained: indexes(explained) };
}

function addressesEnd(failed: readonly Numbered[], trace: Trace, all: readonly Numbered[]): Found | undefined {
  const place = ({ index }: Numbered) => {
    const { unit, functionCode } = trace.subject(index);
    return 256 * unit + functionCode;
  };
  const end = ({ index }: Numbered) => {
    const { address, quantity } = trace.subject(index);
    return address === undefined ? undefined : address + quantity;
  };
  const refused = failed.filter((exchange) =>
    faultsOf(exchange, 'exception').some(({ exception }) => exception === NOT_THERE),
  );
  const [group] = [...grouped(refused, place)].sort(([, one], [, other]) => other.length - one.length);
  if (group === undefined) return undefined;
  const [key, list] = group;
  const good = all.filter(
    (exchange) => place(exchange) === key && exchange.replies.length > 0 && exchange.faults.length === 0,
  );
  const answered = good.reduce((most, exchange) => Math.max(most, end(exchange) ?? 0), 0);
  const explained = list.filter((exchange) => (end(exchange) ?? 0) > answered);
  const [one] = explained;
  if (one === undefined) return undefined;
  const { unit, functionCode } = trace.subject(one.index);
  return { data: { code: 'addresses-end', unit, functionCode, answered }, explained: indexes(explained) };
}

/** A frame that was received, and whether it is damaged. */
interface Heard {
  readonly exchange: number;
  readonly unit: number;
  readonly length: number;
  readonly damaged: boolean;
}

/** All frames, each with its unit and length. */
function heard(trace: Trace, all: readonly Numbered[]): readonly Heard[] {
  return all.flatMap(({ index, request, replies, faults }) => {
    const damaged = new Set(faults.filter(({ kind }) => kind === 'checksum').flatMap(({ records }) => records));
    const { unit } = trace.subject(index);
    return [...(request === undefined ? [] : [request]), ...replies].map((record) => ({
      exchange: index,
      unit,
      length: trace.bytes(record).length,
      damaged: damaged.has(record),
    }));
  });
}

const lengthOf = (frames: readonly Heard[]): number => frames.reduce((sum, { length }) => sum + length, 0);

/** Damage of every byte alike would hit others too: how likely is it that it hits `hits` of `all` in a part of the bytes? */
function chance(hits: number, all: number, share: number): number {
  let sum = 0;
  let term = (1 - share) ** all;
  for (let n = 0; n <= all; n++) {
    if (n >= hits) sum += term;
    term = (term * (all - n) * share) / ((n + 1) * (1 - share));
  }
  return sum;
}

function oneUnit(failed: readonly Numbered[], trace: Trace, all: readonly Numbered[]): Found | undefined {
  const frames = heard(trace, all);
  const byUnit = grouped(
    frames.filter(({ damaged }) => damaged),
    ({ unit }) => unit,
  );
  const [worst] = [...byUnit].sort(([, one], [, other]) => other.length - one.length);
  if (worst === undefined) return undefined;
  const [unit, damaged] = worst;
  const share = lengthOf(frames.filter((frame) => frame.unit === unit)) / lengthOf(frames);
  const total = frames.filter((frame) => frame.damaged).length;
  if (share >= 1 || chance(damaged.length, total, share) > CHANCE) return undefined;
  const explained = new Set(damaged.map(({ exchange }) => exchange));
  return {
    data: { code: 'unit-damaged', unit },
    explained: indexes(failed.filter(({ index }) => explained.has(index))),
  };
}

function longFrames(failed: readonly Numbered[], trace: Trace, all: readonly Numbered[]): Found | undefined {
  const frames = heard(trace, all);
  const damaged = frames.filter((frame) => frame.damaged).sort((a, b) => a.length - b.length);
  // One in ten may be shorter by chance.
  const least = damaged[Math.floor(damaged.length / 10)]?.length;
  if (least === undefined) return undefined;
  const long = damaged.filter(({ length }) => length >= least);
  const share = lengthOf(frames.filter(({ length }) => length >= least)) / lengthOf(frames);
  if (share >= 1 || chance(long.length, damaged.length, share) > CHANCE) return undefined;
  const explained = new Set(long.map(({ exchange }) => exchange));
  return {
    data: { code: 'long-frames-damaged', least },
    explained: indexes(failed.filter(({ index }) => explained.has(index))),
  };
}

/** Requests of others that are sent sooner than any reply comes. */
function overlapping(failed: readonly Numbered[], trace: Trace, all: readonly Numbered[]): Found | undefined {
  const usual = trace.summary().replyTime?.median;
  if (usual === undefined) return undefined;
  let shortest = Number.POSITIVE_INFINITY;
  const explained = failed.filter(({ index, request }) => {
    const next = all[index + 1]?.request;
    if (request === undefined || next === undefined) return false;
    const [one, other] = [trace.spoken(request), trace.spoken(next)];
    if (one.transport === 'tcp' || one.time === undefined || other.time === undefined) return false;
    const distance = other.time - one.time;
    if (distance > usual) return false;
    shortest = Math.min(shortest, distance);
    return true;
  });
  return explained.length === 0
    ? undefined
    : { data: { code: 'requests-overlap', shortest }, explained: indexes(explained) };
}

function echoes(failed: readonly Numbered[]): Found {
  const echoed = failed.filter((exchange) => faultsOf(exchange, 'stray').some(({ code }) => code === 'echo'));
  return { data: { code: 'echo' }, explained: indexes(echoed) };
}

function tooFast(failed: readonly Numbered[]): Found | undefined {
  const short = failed.flatMap((exchange) =>
    faultsOf(exchange, 'timing').flatMap(({ records, gap, least }) =>
      records.at(-1) === exchange.request ? [{ exchange, gap: Number(gap), least: Number(least) }] : [],
    ),
  );
  const [first] = short;
  if (first === undefined) return undefined;
  const gap = short.reduce((shortest, one) => Math.min(shortest, one.gap), first.gap);
  return {
    data: { code: 'polled-too-fast', gap, least: first.least },
    explained: indexes(short.map(({ exchange }) => exchange)),
  };
}
