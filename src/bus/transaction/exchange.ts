import { diagnose } from '../../diagnosis/index.ts';
import { BROADCAST, decodeFrame, type Reading, sameBytes } from '../../modbus/index.ts';
import type { Clock } from '../clock.ts';
import { type LineError, type LineErrorCounts, type Link, noErrors } from '../link/link.ts';
import { type Arrival, MOST_PIECE } from './arrivals.ts';
import { EchoFilter } from './echo-filter.ts';
import { type Awaited, findFrame, hasFunction, isSound, mayBeReply, startsAsReply } from './find-frame.ts';
import type { LineMemory } from './line-memory.ts';
import type { Owed } from './owed.ts';
import type { Pace } from './pace.ts';
import {
  type Attempt,
  answerOf,
  isException,
  type Outcome,
  type Stage,
  type Stray,
  type TransactionResult,
  type Unsure,
  verdictOf,
} from './result.ts';
import type { LineTimes, TransactionRules } from './rules.ts';
import { Waits } from './waits.ts';

/** Where a transaction stands. */
type State =
  | { readonly kind: 'pausing' }
  | {
      readonly kind: 'waiting';
      readonly sentAt: number;
      /** When the last character has left, if the line takes the time it should. */
      readonly lineEnd: number;
      written: boolean;
    }
  | { readonly kind: 'ended' };

/** How long a second copy of the request is waited for, which tells its echo from its reply, in milliseconds. */
const SECOND_COPY = 200;
/** A reply is not expected any more so many time-outs, or milliseconds, after its request. */
const LATEST = { timeouts: 10, time: 10_000 };
/** Requests that one reply may answer, at most. */
const MOST_PERHAPS = 8;
/** Ends an ASCII frame, so that nothing else of it is waited for. */
const LF = 0x0a;

export interface ExchangeParts {
  readonly link: Link;
  readonly clock: Clock;
  readonly line: LineMemory;
  readonly request: Uint8Array;
  readonly rules: TransactionRules;
  readonly times: LineTimes;
  readonly queuedAt: number;
  readonly sent: (bytes: Uint8Array, at: number) => void;
  readonly ended: (result: TransactionResult) => void;
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

/** One transaction: its request is sent, sent again where the rules say so, and its reply taken. */
export class Exchange {
  readonly #parts: ExchangeParts;
  readonly #awaited: Awaited;
  readonly #earlier: Attempt[] = [];
  #strays: Stray[] = [];
  #state: State = { kind: 'pausing' };
  #readyAt: number | undefined;
  #sentAt: number | undefined;
  #errors: LineErrorCounts = noErrors;
  #hurt = false;
  #echo: EchoFilter;
  /** A frame that answers the request, and may be the reply to another one: it is the reply if no other comes. */
  #held: Held | undefined;
  /** A frame of the unit that does not answer the request: it is the reply, a bad one, if no other comes. */
  #misfit: Stray | undefined;
  #unsure: Unsure | undefined;
  readonly #waits: Waits<'pause' | 'deadline' | 'silence' | 'second-copy' | 'other-reply'>;

  constructor(parts: ExchangeParts) {
    this.#parts = parts;
    this.#waits = new Waits(parts.clock);
    const { request, rules } = parts;
    const asked = decodeFrame(request, { transport: rules.transport, direction: 'request' });
    this.#awaited = { transport: rules.transport, request, asked };
    this.#echo = new EchoFilter(this.#awaited, rules.echo, parts.line);
  }

  get waits(): boolean {
    return this.#state.kind === 'waiting';
  }

  /** Sends as soon as the line has been silent for long enough. */
  start(): void {
    const { clock, line, link, times, rules } = this.#parts;
    if (link.state.kind !== 'open') {
      // Not at once, so that whoever asks again and again does not keep the page from going on.
      this.#waits.set('pause', 0, () => this.#finish({ kind: 'not-sent', why: 'not-open' }));
      return;
    }
    const now = clock.now();
    this.#readyAt ??= now;
    // The end of a frame whose beginning came before is not to be taken for the reply.
    const silence = line.goesOn(rules.transport) ? times.silence : times.gap;
    const pace = this.#pace;
    const quiet =
      Math.max(
        line.owed.quietUntil(this.#awaited.asked, this.#awaited.request),
        line.heardAt + Math.max(1.5 * line.copiesWithin, pace.silence),
        pace.pause > 0 ? this.#readyAt : 0,
      ) +
      pace.pause * rules.timeout;
    const due = Math.max(line.freeAt, line.heardAt + silence, quiet);
    // On a line that is never silent, nothing would ever be sent.
    const latest = Math.max(this.#readyAt + rules.timeout + times.longest, quiet);
    if (due > now && now < latest) {
      this.#waits.set('pause', due - now, () => this.start());
      return;
    }
    this.#waits.off('pause');
    this.#send(now);
  }

  #send(now: number): void {
    const { link, line, times, request, rules } = this.#parts;
    this.#strays.push(...line.drain(rules.transport));
    const lineEnd = now + times.characters(request.length);
    const state: State = { kind: 'waiting', sentAt: now, lineEnd, written: false };
    this.#state = state;
    this.#sentAt = now;
    this.#hurt = false;
    this.#held = undefined;
    this.#misfit = undefined;
    this.#unsure = undefined;
    this.#echo = new EchoFilter(this.#awaited, rules.echo, line);
    line.freeAt = lineEnd + times.gap;
    line.perhapsEcho = undefined;
    const unanswered = this.#unanswered();
    this.#parts.sent(request, now);
    link.write(request).then((taken) => {
      if (this.#state !== state) return;
      state.written = true;
      if (!taken) this.#end({ kind: 'not-sent', why: 'write-failed' });
      else if (unanswered !== undefined) this.#end({ kind: 'sent', why: unanswered });
    });
    if (unanswered === 'broadcast') line.freeAt = lineEnd + Math.max(times.gap, rules.turnaround);
    this.#setDeadline(lineEnd + rules.timeout - now);
  }

  /** Why no reply comes, where none does. */
  #unanswered(): 'broadcast' | 'no-reply' | undefined {
    const { asked, request, transport } = this.#awaited;
    if (asked.unitId === BROADCAST) return 'broadcast';
    // Only where a sub-function decides what is answered can one of them be without a reply.
    if (asked.description?.response.then === undefined) return undefined;
    const { problems } = decodeFrame(request, { transport, direction: 'response' });
    return problems.some(({ code }) => code === 'sub-function-without-reply') ? 'no-reply' : undefined;
  }

  /** Bytes have been added to what has come; `gone` had to make room for them. */
  receive(gone: readonly Stray[]): void {
    const { times, line, rules } = this.#parts;
    this.#strays.push(...gone);
    if (this.#state.kind === 'pausing') this.#hearInPause();
    if (this.#state.kind !== 'waiting') return;
    this.#look(rules.transport === 'ascii' && line.arrivals.bytes.at(-1) === LF);
    if (!this.waits) return;
    this.#waits.setPatiently('silence', times.silence, () => this.#look(true));
  }

  /** What comes before the request is sent again may be the reply to its last sending. */
  #hearInPause(): void {
    const { line, rules, request } = this.#parts;
    if (!line.goesOn(rules.transport)) {
      for (const stray of line.drain(rules.transport)) {
        const last = this.#earlier.at(-1);
        if (stray.answers !== request || last === undefined || this.#state.kind !== 'pausing') {
          this.#strays.push(stray);
          continue;
        }
        this.#earlier.pop();
        this.#sentAt = last.sentAt;
        this.#end(answerOf(stray, this.#read(stray.bytes)));
      }
    }
    if (this.#state.kind === 'pausing') this.start();
  }

  lineError(error: LineError): void {
    this.#errors = { ...this.#errors, [error]: this.#errors[error] + 1 };
    this.#hurt = true;
  }

  /** Ends it at once, because the link is lost or somebody has cancelled it. */
  stop(kind: 'lost' | 'cancelled'): void {
    if (this.#state.kind === 'ended') return;
    const waiting = this.#state.kind === 'waiting' ? this.#state : undefined;
    const stage: Stage = waiting === undefined ? 'queued' : waiting.written ? 'waiting' : 'sending';
    if (waiting !== undefined) this.#owe({ quiet: true });
    this.#finish({ kind, stage });
  }

  #setDeadline(delay: number): void {
    this.#waits.setPatiently('deadline', delay, () => this.#deadline());
  }

  #deadline(): void {
    const state = this.#state;
    if (state.kind !== 'waiting') return;
    const { clock, line, rules, times } = this.#parts;
    const now = clock.now();
    const silentAt = line.heardAt + times.silence;
    const last = state.lineEnd + rules.timeout + times.longest + times.silence;
    // A reply that has begun in time may end behind it.
    if (line.arrivals.length > 0 && silentAt > now && now < last) {
      this.#setDeadline(silentAt - now);
      return;
    }
    // What may be the reply is taken for it.
    if (this.#waits.has('second-copy')) this.#echo.settle('undecided');
    this.#look(true);
    if (this.#state !== state) return;
    if (!state.written) this.#end({ kind: 'not-sent', why: 'stuck' });
    else if (this.#held !== undefined) this.#acceptHeld();
    else if (line.arrivals.length > 0 && this.#misfit === undefined) this.#broken();
    else if (this.#misfit !== undefined) this.#acceptMisfit(this.#misfit);
    else this.#end({ kind: 'silent' });
  }

  /** Takes from what has come as much as can be told; `ended` says that a silence has followed it. */
  #look(ended: boolean): void {
    const { line } = this.#parts;
    if (!this.#takeEcho(ended)) return;
    while (this.#state.kind === 'waiting') {
      const found = findFrame(line.arrivals.bytes, this.#awaited, ended);
      if (found === undefined) break;
      this.#strays.push(...line.takeNoise(found.from));
      const arrival = line.arrivals.take(found.to - found.from);
      if (found.kind === 'other') this.#strays.push(line.stray(arrival));
      else this.#judge(arrival, this.#state.sentAt, ended && line.arrivals.length === 0);
    }
    const { bytes } = line.arrivals;
    if (!ended || !this.waits || bytes.length === 0 || this.#held !== undefined) return;
    if (this.#hurt || mayBeReply(bytes, this.#awaited)) this.#broken();
  }

  /** Takes the echo away; whether what else has come can be looked at. */
  #takeEcho(ended: boolean): boolean {
    const state = this.#echo.look(ended);
    if (state.kind === 'settled') {
      if (state.echo !== undefined) this.#strays.push(state.echo);
      return true;
    }
    if (state.kind === 'doubt' && !this.#waits.has('second-copy')) {
      this.#waits.set('second-copy', SECOND_COPY, () => {
        this.#echo.settle('undecided');
        this.#look(true);
      });
    }
    return false;
  }

  #read(bytes: Uint8Array): Reading {
    const { transport, request } = this.#awaited;
    return decodeFrame(bytes, { transport, direction: 'response', request });
  }

  get #pace(): Pace {
    return this.#parts.line.pace(this.#awaited.asked.unitId);
  }

  /** Takes a frame of the unit for the reply, or for that to an earlier request: one that is owed is expected first. */
  #judge(arrival: Arrival, sentAt: number, ended: boolean): void {
    const { line, request, times } = this.#parts;
    const pace = this.#pace;
    const reading = this.#read(arrival.bytes);
    if (!isSound(reading)) {
      const stray = line.stray(arrival);
      this.#strays.push(stray);
      if (stray.what !== 'other') return;
      this.#misfit = stray;
      // A reply to this function that is not as it should be is one all the same, where the right one does not follow.
      if (hasFunction(reading, this.#awaited.asked)) {
        if (ended) this.#acceptMisfit(stray);
        else this.#waits.set('other-reply', times.silence, () => this.#acceptMisfit(stray));
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
      const delay = Math.max(0, sentAt + pace.longest - arrival.at);
      this.#waits.set('other-reply', delay, () => this.#acceptHeld());
    }
  }

  #hold(held: Held): void {
    this.#held = held;
    this.#strays.push(held.stray);
  }

  /** Nothing else has come: what was held is the reply, or that to the earlier request. */
  #acceptHeld(): void {
    const held = this.#held;
    if (this.#state.kind !== 'waiting' || held === undefined) return;
    const { stray, reading, owed } = held;
    const { line } = this.#parts;
    const pace = this.#pace;
    this.#strays = this.#strays.filter((other) => other !== stray);
    const asOwn = stray.at - this.#state.sentAt;
    if (held.unsure === undefined) {
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
      line.owed.weaken(this.#awaited.asked.unitId);
    } else this.#owe({ quiet: true, ...(owed && { perhaps: [owed, ...(owed.perhaps ?? [])] }) });
    this.#accept(stray, reading, held.unsure);
  }

  #acceptMisfit(stray: Stray): void {
    if (this.#state.kind !== 'waiting' || this.#held !== undefined) return;
    this.#strays = this.#strays.filter((other) => other !== stray);
    this.#accept(stray, this.#read(stray.bytes), undefined);
  }

  #accept(arrival: Arrival, reading: Reading, unsure: Unsure | undefined): void {
    const { line, request, rules } = this.#parts;
    const { asked } = this.#awaited;
    this.#echo.replied(sameBytes(arrival.bytes, request));
    // The request is out, whatever time the line should have taken for it.
    line.freeAt = Number.NEGATIVE_INFINITY;
    this.#unsure = unsure;
    const after = arrival.at - (this.#sentAt ?? arrival.at);
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
      this.#owe({ quiet: true, ...(earlier.perhaps && { perhaps: earlier.perhaps }) });
    }
    const outcome = answerOf(arrival, reading);
    if (outcome.kind === 'exception' || (this.#held && isException(this.#held.reading)))
      this.#owe({ weak: true, quiet: this.#pace.refused() });
    // Another reply in what has come together with this one.
    const others = line.drain(rules.transport);
    this.#strays.push(...others);
    if (isSound(reading) && others.some((other) => other.what === 'other' && isSound(this.#read(other.bytes)))) {
      this.#unsure ??= 'two-replies';
    }
    this.#end(outcome);
  }

  #broken(): void {
    const { arrivals } = this.#parts.line;
    const { transport } = this.#awaited;
    const most = transport === 'ascii' ? arrivals.length : Math.min(arrivals.length, MOST_PIECE);
    this.#end({ kind: 'broken', ...arrivals.take(most) });
  }

  /** The reply may still come; `quiet`: for one more time-out nothing is sent that it could answer. */
  #owe({ quiet, weak = false, perhaps }: Pick<Owed, 'perhaps'> & { quiet: boolean; weak?: boolean }): void {
    const { line, request, rules, clock } = this.#parts;
    if (rules.punctual) return;
    const { asked, transport } = this.#awaited;
    const sentAt = this.#sentAt ?? clock.now();
    const now = clock.now();
    line.owed.add({
      transport,
      request,
      asked,
      sentAt,
      weak,
      ...(perhaps && { perhaps: perhaps.slice(0, MOST_PERHAPS) }),
      quietUntil: quiet && rules.quiet ? (weak ? sentAt : now - rules.timeout) + 2 * rules.timeout : 0,
      until: now + Math.max(LATEST.time, LATEST.timeouts * rules.timeout),
    });
  }

  /** Ends the attempt: with the next one, or with the transaction. */
  #end(outcome: Outcome): void {
    const { clock, line, rules } = this.#parts;
    if (outcome.kind === 'silent') this.#owe({ quiet: true });
    else if (outcome.kind === 'broken') this.#owe({ quiet: false, weak: startsAsReply(outcome.bytes, this.#awaited) });
    const failed = outcome.kind === 'silent' || outcome.kind === 'broken' || this.#unsure !== undefined;
    if (failed && this.#earlier.length < rules.retries) {
      const now = clock.now();
      this.#earlier.push({ sentAt: this.#sentAt ?? now, endedAt: now, outcome });
      this.#state = { kind: 'pausing' };
      this.#readyAt = undefined;
      this.#waits.clear();
      this.start();
      return;
    }
    // What came with the reply is not waited for any longer.
    this.#strays.push(...line.drain(rules.transport));
    this.#finish(outcome);
  }

  #finish(outcome: Outcome): void {
    const { clock, request, queuedAt } = this.#parts;
    const { asked, transport } = this.#awaited;
    this.#state = { kind: 'ended' };
    this.#waits.clear();
    const echo = this.#echo.found;
    const unsure = this.#unsure;
    const owed = this.#held?.owed;
    const { slow } = this.#pace;
    const verdict = verdictOf(outcome, { echo, unsure });
    const wrong = verdict === 'bad' && 'bytes' in outcome && outcome.bytes.length > 0;
    this.#parts.ended({
      request,
      transport,
      asked,
      outcome,
      verdict,
      queuedAt,
      sentAt: this.#sentAt,
      endedAt: clock.now(),
      earlier: this.#earlier,
      strays: this.#strays,
      echo,
      ...(unsure !== undefined && { unsure }),
      ...(owed && !owed.perhaps && unsure === 'perhaps-late' && { perhapsTo: { request: owed.request, sentAt: owed.sentAt } }),
      ...(slow !== undefined && { slow }),
      errors: this.#errors,
      findings: wrong ? diagnose(outcome.bytes, { transport, request }) : [],
    });
  }
}
