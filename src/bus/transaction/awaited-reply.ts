import { decodeFrame, type Reading, sameBytes } from '../../modbus/index.ts';
import type { Clock } from '../clock.ts';
import type { Arrival } from './arrivals.ts';
import type { EchoFilter } from './echo-filter.ts';
import { type Awaited, hasFunction, isSound } from './find-frame.ts';
import type { LineMemory } from './line-memory.ts';
import type { Owed } from './owed.ts';
import type { Pace } from './pace.ts';
import { answerOf, isException, type Outcome, type Stray, type Unsure } from './result.ts';
import type { LineTimes, TransactionRules } from './rules.ts';
import type { Waits } from './waits.ts';

/** How long after its request a reply is still expected: in time-outs, and in milliseconds. */
const LATEST = { timeouts: 10, time: 10_000 };
/** Requests that one reply may answer, at most. */
const MOST_PERHAPS = 8;

/** What a transaction waits for. */
export type ExchangeWait = 'pause' | 'deadline' | 'silence' | 'second-copy' | 'other-reply';

export interface AwaitedReplyParts {
  readonly clock: Clock;
  readonly line: LineMemory;
  readonly request: Uint8Array;
  readonly rules: TransactionRules;
  readonly times: LineTimes;
  readonly awaited: Awaited;
  readonly echo: EchoFilter;
  readonly waits: Waits<ExchangeWait>;
  /** Where what is not the reply is noted. */
  readonly strays: Stray[];
  /** When the request was sent: the clock's milliseconds. */
  readonly sentAt: number;
  /** Called once, with the reply. */
  readonly taken: (outcome: Outcome) => void;
}

interface Held {
  readonly stray: Stray;
  readonly reading: Reading;
  /** Absent: it is the reply for sure if no other comes soon. */
  readonly unsure?: Unsure;
  /** The request that it may answer, or the frame that it may be a copy of. */
  readonly owed?: Owed;
  readonly first?: Arrival;
}

/** Finds the reply to one sending of a request among the frames of its unit. */
export class AwaitedReply {
  readonly #parts: AwaitedReplyParts;
  /** A frame that answers the request, and may be the reply to another one: it is the reply if no other comes. */
  #held: Held | undefined;
  /** A frame of the unit that does not answer the request: it is the reply, a bad one, if no other comes. */
  #misfit: Stray | undefined;
  #unsure: Unsure | undefined;

  constructor(parts: AwaitedReplyParts) {
    this.#parts = parts;
  }

  get held(): Held | undefined {
    return this.#held;
  }

  /** Why the reply that was taken may be that to another request. */
  get unsure(): Unsure | undefined {
    return this.#unsure;
  }

  /** The time is over: takes what may be the reply, and answers whether there was something. */
  settle(): boolean {
    if (this.#held !== undefined) this.#acceptHeld();
    else if (this.#misfit !== undefined) this.#acceptMisfit(this.#misfit);
    else return false;
    return true;
  }

  get #pace(): Pace {
    return this.#parts.line.pace(this.#parts.awaited.asked.unitId);
  }

  #read(bytes: Uint8Array): Reading {
    return readReply(bytes, this.#parts.awaited);
  }

  /** Takes a frame of the unit for the reply, or for that to an earlier request: one that is owed is expected first. */
  judge(arrival: Arrival, ended: boolean): void {
    const { line, request, rules, times, awaited, sentAt, strays, waits } = this.#parts;
    const pace = this.#pace;
    const reading = this.#read(arrival.bytes);
    if (!isSound(reading)) {
      const stray = line.stray(arrival);
      strays.push(stray);
      if (stray.what !== 'other') return;
      this.#misfit = stray;
      // A faulty reply to this function is taken if the right one does not follow.
      if (hasFunction(reading, awaited.asked)) {
        if (ended) this.#acceptMisfit(stray);
        else waits.set('other-reply', times.silence, () => this.#acceptMisfit(stray));
      }
      return;
    }
    const after = arrival.at - sentAt;
    const isSoon = pace.isTooSoon(after) && pace.isKnown;
    const isOdd = pace.isOdd(after);
    const odd = { weak: isOdd || pace.answersTwice, passed: isOdd || pace.isErratic };
    const owed = line.owed.answeredBy(arrival.bytes, arrival.at, odd, request);
    const isCopy = isSoon || line.owed.isEmpty;
    const first = (isSoon ? line.copied(arrival) : undefined) ?? line.perhapsCopyOf(arrival, request);
    const isTroubled = line.isTroubled(arrival.at);
    const isLate = line.owed.answeredBy(arrival.bytes, arrival.at, undefined, request) !== undefined;
    line.remember(arrival);
    const held = this.#held;
    if (owed !== undefined)
      this.#hold({ stray: line.late(arrival, owed, false), reading, unsure: 'perhaps-late', owed });
    else if (first) {
      const unsure = isSoon || line.copiesWithin > 0 ? { unsure: 'perhaps-copy' as const } : {};
      this.#hold({ stray: { what: 'copy', ...arrival }, reading, first, ...unsure });
    } else if (isSoon && isTroubled && held === undefined) {
      this.#hold({ stray: { what: 'other', ...arrival }, reading, unsure: 'perhaps-late' });
    } else if (isLate && held === undefined) this.#hold({ stray: { what: 'other', ...arrival }, reading });
    else {
      if (held?.owed?.weak && !held.owed.passed) pace.answersTwice = true;
      if (held?.first) line.repeats(held.stray.at - held.first.at);
      // Which of two frames is the reply is sure only if the first came too soon for it, or is one that came before.
      const isFirst = held !== undefined && !pace.isMuchTooSoon(held.stray.at - sentAt) && !(held.first && isCopy);
      if (held !== undefined) line.troubledAt = arrival.at;
      this.#accept(arrival, reading, isFirst ? 'perhaps-late' : undefined);
      return;
    }
    // Only because it came so soon: the reply itself does not take long.
    if (owed === undefined || (owed.weak && !(owed.passed ? pace.isErratic : pace.answersTwice))) {
      // An exception may be followed by the reply all the same, and has no value.
      const isPatient = first !== undefined && line.mayBeFirstCopy && !isException(reading);
      const patience = isPatient ? rules.patience : 0;
      const delay = Math.max(0, sentAt + pace.longest + patience - arrival.at);
      waits.set('other-reply', delay, () => this.#acceptHeld());
    }
  }

  #hold(held: Held): void {
    this.#held = held;
    this.#parts.strays.push(held.stray);
  }

  /** What was noted as a stray is the reply. */
  #takeBack(stray: Stray): void {
    const { strays } = this.#parts;
    strays.splice(strays.indexOf(stray), 1);
  }

  /** Nothing else has come: what was held is the reply, or that to the earlier request. */
  #acceptHeld(): void {
    const held = this.#held;
    if (held === undefined) return;
    const { stray, reading, owed } = held;
    const { line, sentAt, awaited } = this.#parts;
    const pace = this.#pace;
    this.#takeBack(stray);
    const asOwn = stray.at - sentAt;
    if (held.unsure === undefined) {
      if (held.first !== undefined) line.coincided();
      this.#held = undefined;
      this.#accept(stray, reading, undefined);
      return;
    }
    if (owed !== undefined) pace.note({ asOwn, asEarlier: stray.at - owed.sentAt });
    const isClear = pace.isClear();
    if (isClear) {
      pace.answered(asOwn);
      if (owed !== undefined) {
        const until = Math.min(owed.until, owed.sentAt + LATEST.timeouts * this.#parts.rules.timeout);
        line.owed.add({ ...owed, weak: true, passed: true, until });
      }
      line.owed.weaken(awaited.asked.unitId);
    } else {
      const perhaps = owed && { perhaps: [owed, ...(owed.perhaps ?? [])] };
      this.owe({ quiet: !owed?.passed, weak: owed?.passed === true, ...perhaps });
    }
    this.#accept(stray, reading, held.unsure);
  }

  #acceptMisfit(stray: Stray): void {
    if (this.#held !== undefined) return;
    this.#takeBack(stray);
    this.#accept(stray, this.#read(stray.bytes), undefined);
  }

  #accept(arrival: Arrival, reading: Reading, unsure: Unsure | undefined): void {
    const { line, request, rules, awaited, echo, sentAt, strays, taken } = this.#parts;
    const { asked } = awaited;
    echo.replied(sameBytes(arrival.bytes, request));
    // The request is out, whatever time the line should have taken for it.
    line.freeAt = Number.NEGATIVE_INFINITY;
    this.#unsure = unsure;
    const after = arrival.at - sentAt;
    const earlier = line.owed.earlier(request);
    const isSure = unsure === undefined && isSound(reading);
    if (isSure) line.answered(request, arrival.bytes);
    if (isSure && earlier === undefined) {
      line.owed.weaken(asked.unitId);
      this.#pace.answered(after);
    } else if (isSure && earlier !== undefined) {
      // The reply is to one of the sendings, and as many as the others may come.
      this.#pace.doubt();
      line.owed.settle(earlier);
      this.owe({ quiet: true, ...(earlier.perhaps && { perhaps: earlier.perhaps }) });
    }
    const outcome = answerOf(arrival, reading);
    if (outcome.kind === 'exception' || (this.#held && isException(this.#held.reading)))
      this.owe({ weak: true, quiet: this.#pace.refused() });
    // Another reply in what has come together with this one.
    const others = line.drain(rules.transport);
    strays.push(...others);
    if (isSound(reading) && others.some((other) => other.what === 'other' && isSound(this.#read(other.bytes)))) {
      this.#unsure ??= 'two-replies';
    }
    taken(outcome);
  }

  /** The reply may still come; `quiet`: for one more time-out nothing is sent that it could answer. */
  owe({ quiet, weak = false, perhaps }: Pick<Owed, 'perhaps'> & { quiet: boolean; weak?: boolean }): void {
    const { line, request, rules, clock, awaited, sentAt } = this.#parts;
    if (rules.punctual) return;
    const { asked, transport } = awaited;
    const now = clock.now();
    const passed = perhaps?.find((one) => one.passed);
    line.owed.add({
      transport,
      request,
      asked,
      sentAt,
      weak,
      ...(perhaps && { perhaps: perhaps.slice(0, MOST_PERHAPS) }),
      quietUntil: quiet && rules.quiet ? (weak ? sentAt : now - rules.timeout) + 2 * rules.timeout : 0,
      until: passed?.until ?? now + Math.max(LATEST.time, LATEST.timeouts * rules.timeout),
      ...(passed && { passed: true }),
    });
  }
}

/** A frame as the reply to what is awaited. */
export function readReply(bytes: Uint8Array, { transport, request }: Awaited): Reading {
  return decodeFrame(bytes, { transport, direction: 'response', request });
}
