import { diagnose } from '../../diagnosis/index.ts';
import { BROADCAST, decodeFrame, sameBytes } from '../../modbus/index.ts';
import type { Clock } from '../clock.ts';
import { type LineError, type LineErrorCounts, type Link, noErrors } from '../link/link.ts';
import { EchoFilter } from './echo-filter.ts';
import { type Awaited, findFrame, fits, mayBeReply } from './find-frame.ts';
import type { LineMemory } from './line-memory.ts';
import { type Attempt, type Outcome, type Stage, type Stray, type TransactionResult, verdictOf } from './result.ts';
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

/** So long a second copy of the request is waited for that tells its echo from its reply, in milliseconds. */
const SECOND_COPY = 200;
const EXCEPTION = 0x80;
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
  /** A reply that came sooner than the request could be out, and so was taken for a late one. */
  #early: { readonly bytes: Uint8Array; readonly at: number } | undefined;
  readonly #waits: Waits<'pause' | 'deadline' | 'silence' | 'second-copy'>;

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
    const due = Math.max(line.freeAt, line.heardAt + silence);
    // On a line that is never silent, nothing would ever be sent.
    if (due > now && now < this.#readyAt + rules.timeout + times.longest) {
      this.#waits.set('pause', due - now, () => this.start());
      return;
    }
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
    this.#early = undefined;
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

  /** Bytes have been added to what has come. */
  receive(): void {
    if (this.#state.kind !== 'waiting') return;
    const { times, line, rules } = this.#parts;
    this.#look(rules.transport === 'ascii' && line.arrivals.bytes.at(-1) === LF);
    if (!this.waits) return;
    this.#waits.setPatiently('silence', times.silence, () => this.#look(true));
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
    if (waiting !== undefined) this.#giveUp();
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
    const early = this.#early;
    if (!state.written) this.#end({ kind: 'not-sent', why: 'stuck' });
    else if (early !== undefined && line.arrivals.length === 0) {
      // Nothing else came: the line takes no time, and this was the reply.
      line.unpaced = true;
      this.#strays = this.#strays.filter(({ bytes }) => bytes !== early.bytes);
      this.#accept(early.bytes, early.at);
    } else if (line.arrivals.length > 0) this.#broken();
    else this.#end({ kind: 'silent' });
  }

  /** Takes from what has come as much as can be told; `ended` says that a silence has followed it. */
  #look(ended: boolean): void {
    const { line } = this.#parts;
    if (!this.#takeEcho(ended)) return;
    while (this.#state.kind === 'waiting') {
      const found = findFrame(line.arrivals.bytes, this.#awaited, ended);
      if (found === undefined) break;
      this.#takeNoise(found.from);
      const at = line.arrivals.at(0);
      const bytes = line.arrivals.take(found.to - found.from);
      if (found.kind === 'other' || this.#isLate(bytes, at)) this.#strays.push(line.strayFrame(bytes, at));
      else this.#accept(bytes, at);
    }
    const { bytes } = line.arrivals;
    if (ended && this.waits && bytes.length > 0 && (this.#hurt || mayBeReply(bytes, this.#awaited))) this.#broken();
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

  #takeNoise(length: number): void {
    const { arrivals } = this.#parts.line;
    if (length === 0) return;
    const at = arrivals.at(0);
    this.#strays.push({ what: 'noise', bytes: arrivals.take(length), at });
  }

  /** Whether this is the reply to a request given up before, rather than to this one. */
  #isLate(bytes: Uint8Array, at: number): boolean {
    const { line } = this.#parts;
    const state = this.#state;
    const early = state.kind === 'waiting' && at < state.lineEnd;
    const before = line.wasAsked(bytes, at);
    if (before === undefined) {
      if (early) line.unpaced = true;
      return false;
    }
    if (!fits(bytes, this.#awaited)) return true;
    if (!early || line.unpaced) return false;
    this.#early ??= { bytes, at };
    return true;
  }

  #accept(bytes: Uint8Array, at: number): void {
    const { transport, request } = this.#awaited;
    this.#echo.replied(sameBytes(bytes, request));
    // The request is out, whatever time the line should have taken for it.
    this.#parts.line.freeAt = Number.NEGATIVE_INFINITY;
    const reading = decodeFrame(bytes, { transport, direction: 'response', request });
    const exceptionCode = reading.fields['exceptionCode'];
    const refused = ((reading.functionCode ?? 0) & EXCEPTION) !== 0 && typeof exceptionCode === 'number';
    this.#end(
      refused ? { kind: 'exception', bytes, reading, exceptionCode, at } : { kind: 'reply', bytes, reading, at },
    );
  }

  #broken(): void {
    const { arrivals } = this.#parts.line;
    const at = arrivals.at(0);
    this.#end({ kind: 'broken', bytes: arrivals.take(arrivals.length), at });
  }

  #giveUp(): void {
    const { line, request, rules, clock } = this.#parts;
    line.giveUp(rules.transport, request, clock.now());
  }

  /** Ends the attempt: with the next one, or with the transaction. */
  #end(outcome: Outcome): void {
    const { clock, line, rules } = this.#parts;
    const failed = outcome.kind === 'silent' || outcome.kind === 'broken';
    if (failed) this.#giveUp();
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
    const verdict = verdictOf(outcome, echo);
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
      errors: this.#errors,
      findings: wrong ? diagnose(outcome.bytes, { transport, request }) : [],
    });
  }
}
