import { diagnose } from '../../diagnosis/index.ts';
import { decodeFrame } from '../../modbus/index.ts';
import type { Clock } from '../clock.ts';
import { type LineError, type LineErrorCounts, type Link, noErrors } from '../link/link.ts';
import { MOST_PIECE } from './arrivals.ts';
import { AwaitedReply, type ExchangeWait, readReply } from './awaited-reply.ts';
import { EchoFilter } from './echo-filter.ts';
import { type Awaited, findFrame, mayBeReply, startsAsReply, unansweredBy } from './find-frame.ts';
import type { LineMemory } from './line-memory.ts';
import type { Pace } from './pace.ts';
import {
  type Attempt,
  answerOf,
  type Outcome,
  type Stage,
  type Stray,
  type TransactionResult,
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

/** One transaction: its request is sent, sent again if the rules say so, and its reply is taken. */
export class Exchange {
  readonly #parts: ExchangeParts;
  readonly #awaited: Awaited;
  readonly #earlier: Attempt[] = [];
  readonly #strays: Stray[] = [];
  #state: State = { kind: 'pausing' };
  #readyAt: number | undefined;
  #sentAt: number | undefined;
  #errors: LineErrorCounts = noErrors;
  #hurt = false;
  #echo: EchoFilter;
  /** What comes after the last sending. */
  #answer: AwaitedReply | undefined;
  readonly #waits: Waits<ExchangeWait>;

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
    const due = line.dueAt(this.#awaited, { rules, times, readyAt: this.#readyAt, now });
    if (due > now) {
      this.#waits.set('pause', due - now, () => this.start());
      return;
    }
    this.#waits.off('pause');
    this.#send(now);
  }

  #send(now: number): void {
    const { link, clock, line, times, request, rules } = this.#parts;
    this.#strays.push(...line.drain(rules.transport));
    const lineEnd = now + times.characters(request.length);
    const state: State = { kind: 'waiting', sentAt: now, lineEnd, written: false };
    this.#state = state;
    this.#sentAt = now;
    this.#hurt = false;
    this.#echo = new EchoFilter(this.#awaited, rules.echo, line);
    this.#answer = new AwaitedReply({
      clock,
      line,
      request,
      rules,
      times,
      awaited: this.#awaited,
      echo: this.#echo,
      waits: this.#waits,
      strays: this.#strays,
      sentAt: now,
      taken: (outcome) => this.#end(outcome),
    });
    line.freeAt = lineEnd + times.gap;
    line.perhapsEcho = undefined;
    const unanswered = unansweredBy(this.#awaited);
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
        this.#end(answerOf(stray, readReply(stray.bytes, this.#awaited)));
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
    if (waiting !== undefined) this.#answer?.owe({ quiet: true });
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
    else if (this.#answer?.settle()) return;
    else if (line.arrivals.length > 0) this.#broken();
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
      else this.#answer?.judge(arrival, ended && line.arrivals.length === 0);
    }
    const { bytes } = line.arrivals;
    if (!ended || !this.waits || bytes.length === 0 || this.#answer?.held !== undefined) return;
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

  get #pace(): Pace {
    return this.#parts.line.pace(this.#awaited.asked.unitId);
  }

  #broken(): void {
    const { arrivals } = this.#parts.line;
    const { transport } = this.#awaited;
    const most = transport === 'ascii' ? arrivals.length : Math.min(arrivals.length, MOST_PIECE);
    this.#end({ kind: 'broken', ...arrivals.take(most) });
  }

  /** Ends the attempt: with the next one, or with the transaction. */
  #end(outcome: Outcome): void {
    const { clock, line, rules } = this.#parts;
    if (outcome.kind === 'silent') this.#answer?.owe({ quiet: true });
    else if (outcome.kind === 'broken')
      this.#answer?.owe({ quiet: false, weak: startsAsReply(outcome.bytes, this.#awaited) });
    const failed = outcome.kind === 'silent' || outcome.kind === 'broken' || this.#answer?.unsure !== undefined;
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
    const unsure = this.#answer?.unsure;
    const owed = this.#answer?.held?.owed;
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
      ...(owed &&
        !owed.perhaps &&
        unsure === 'perhaps-late' && { perhapsTo: { request: owed.request, sentAt: owed.sentAt } }),
      ...(slow !== undefined && { slow }),
      errors: this.#errors,
      findings: wrong ? diagnose(outcome.bytes, { transport, request }) : [],
    });
  }
}
