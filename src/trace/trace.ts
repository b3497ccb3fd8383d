import { diagnose, type Finding } from '../diagnosis/index.ts';
import { heldBehind } from './behind.ts';
import type { Subject } from './exchanges.ts';
import type { Exchange, Fault, FaultKind } from './fault.ts';
import { Hearing, type LineSpeed } from './hearing.ts';
import { Held } from './held.ts';
import type { Known } from './known.ts';
import type { CaptureRecord, TraceInput } from './record.ts';
import type { Spread } from './spread.ts';

export interface TraceOptions {
  /** How long a reply may stay away, in milliseconds; 1000 if it is left out. */
  readonly timeout?: number | undefined;
  /** With it silences are judged. */
  readonly line?: LineSpeed | undefined;
}

/** What is said of the whole. Times are microseconds. Bytes in no frame are faults, but neither frames nor exchanges. */
export interface TraceSummary {
  readonly frames: number;
  readonly exchanges: number;
  readonly faults: Readonly<Record<FaultKind, number>>;
  /** In ascending order. */
  readonly units: readonly number[];
  readonly replyTime?: Spread;
}

/** Who spoke to whom, when and how. */
export type Spoken = Pick<CaptureRecord, 'time' | 'transport' | 'side'> & { readonly connection: string | undefined };

const NO_SUBJECT: Subject = Object.freeze({ unit: NaN, functionCode: NaN, address: undefined, quantity: 0 });
const TIMEOUT = 1000;
const MILLISECOND = 1000;

/** Requests and replies in their order, and what went wrong between them. */
export class Trace {
  /** How long a reply may stay away, in microseconds. */
  readonly timeout: number;
  readonly #held: Held;
  readonly #hearing: Hearing;

  constructor({ timeout = TIMEOUT, line }: TraceOptions = {}, held = new Held()) {
    this.timeout = timeout * MILLISECOND;
    this.#held = held;
    this.#hearing = new Hearing(held, this.timeout, line);
  }

  /** How many records there are. */
  get size(): number {
    return this.#held.records.size;
  }

  get exchangeCount(): number {
    return this.#held.exchanges.count;
  }

  /** How many of the records are bytes in no frame; each has an exchange of its own. */
  get pieces(): number {
    return this.#held.pieces;
  }

  /** Takes the next record. Never throws. */
  add(input: TraceInput): void {
    this.#hearing.add(input);
  }

  /** Judges the silences between all records by the speed of another line, or by none. */
  judgeSilences(line: TraceOptions['line']): void {
    this.#hearing.judgeSilences(line);
  }

  /** A record, with what its bytes are found to be. Throws a `RangeError` for an index that is not one of a record. */
  record(index: number): CaptureRecord & { readonly findings: readonly Finding[] } {
    const record = this.plain(index);
    const request = this.requestOf(this.exchangeOf(index));
    const asked = request === undefined || request === index ? undefined : this.bytes(request);
    return { ...record, findings: diagnose(record.bytes, { transport: record.transport, request: asked }) };
  }

  /** A record as it is kept. Throws a `RangeError` for an index that is not one of a record. */
  plain(index: number): CaptureRecord {
    this.#demand(index);
    return this.#held.records.record(index);
  }

  /** What its source knows of a record better than its bytes. */
  known(index: number): Known | undefined {
    return this.#held.records.known(index);
  }

  /** The bytes of a record. Throws a `RangeError` for an index that is not one of a record. */
  bytes(index: number): Uint8Array {
    this.#demand(index);
    return this.#held.records.bytes(index);
  }

  /** When a record was made; `undefined` if its source has no times. */
  time(index: number): number | undefined {
    return this.#held.records.time(index);
  }

  /** The earliest and the latest time of the records; `undefined` if none of them has a time. */
  get span(): { readonly first: number; readonly last: number } | undefined {
    const { oldest, newest } = this.#held;
    return Number.isNaN(newest) ? undefined : { first: oldest, last: newest };
  }

  /** Who spoke to whom, when and how; the ends of a connection with the one that asks first. */
  spoken(index: number): Spoken {
    const [from, to] = this.#held.records.ends(index);
    const side = this.side(index);
    const ends = side === 'response' ? [to, from] : [from, to];
    const connection = from === undefined && to === undefined ? undefined : `${ends[0] ?? ''} → ${ends[1] ?? ''}`;
    return { connection, time: this.time(index), transport: this.transport(index), side };
  }

  side(index: number): CaptureRecord['side'] {
    return this.#held.records.side(index);
  }

  transport(index: number): CaptureRecord['transport'] {
    return this.#held.records.transport(index);
  }

  /** Whether a record is a frame; others are bytes, or words, in no frame. */
  isFrame(index: number): boolean {
    return this.#held.isFrame(index);
  }

  /** The exchange that a record belongs to. Throws a `RangeError` for an index that is not one of a record. */
  exchangeOf(index: number): number {
    this.#demand(index);
    return this.#held.exchangeOf.at(index);
  }

  /** The exchanges `[from, to)`, as far as there are such. */
  exchanges(from: number, to: number): readonly Exchange[] {
    const found: Exchange[] = [];
    for (let index = Math.max(0, from); index < Math.min(to, this.exchangeCount); index++)
      found.push(this.#exchange(index));
    return found;
  }

  #exchange(index: number): Exchange {
    const request = this.requestOf(index);
    const after = this.after(index);
    return {
      ...(request !== undefined && { request }),
      replies: this.#held.exchanges.replies(index),
      ...(after !== undefined && { after }),
      faults: this.faults(index),
    };
  }

  /** Whom an exchange is with, and what it is about. */
  subject(exchange: number): Subject {
    return this.isPiece(exchange) ? NO_SUBJECT : this.#held.exchanges.subject(exchange);
  }

  /** Whether an exchange stands for bytes in no frame. */
  isPiece(exchange: number): boolean {
    if (this.pieces === 0 || this.requestOf(exchange) !== undefined) return false;
    const reply = this.replyOf(exchange);
    return reply !== undefined && !this.isFrame(reply);
  }

  /** The faults of an exchange. */
  faults(exchange: number): readonly Fault[] {
    const { exchanges } = this.#held;
    const faults = exchanges.faults(exchange);
    const request = exchanges.request(exchange);
    if (request === undefined || !exchanges.isUnanswered(exchange) || this.#isPending(exchange)) return faults;
    return [...faults, { kind: 'no-reply', code: 'no-reply', records: [request] }];
  }

  /** The record of the request of an exchange. */
  requestOf(exchange: number): number | undefined {
    return this.#held.exchanges.request(exchange);
  }

  /** The record of the first reply of an exchange. */
  replyOf(exchange: number): number | undefined {
    return this.#held.exchanges.reply(exchange);
  }

  /** When an exchange began: the time of its request, or of the reply that nobody asked for. */
  began(exchange: number): number | undefined {
    const record = this.requestOf(exchange) ?? this.replyOf(exchange);
    return record === undefined ? undefined : this.time(record);
  }

  /** Microseconds from the request of an exchange to its first reply, if both have a time. */
  after(exchange: number): number | undefined {
    const [request, reply] = [this.requestOf(exchange), this.replyOf(exchange)];
    if (request === undefined || reply === undefined) return undefined;
    const [asked, answered] = [this.time(request), this.time(reply)];
    return asked === undefined || answered === undefined ? undefined : answered - asked;
  }

  /** Whether a reply may still come: to what is heard just now, the last on its line, and not longer ago than the time-out. */
  #isPending(exchange: number): boolean {
    const { exchanges, newest, waitingLines } = this.#held;
    const request = exchanges.request(exchange);
    if (request === undefined || !exchanges.isUnanswered(exchange)) return false;
    if (waitingLines.get(exchange)?.waiting.at(-1)?.exchange !== exchange) return false;
    const time = this.time(request);
    return time === undefined || Number.isNaN(newest) || newest - time <= this.timeout;
  }

  /** The first exchange whose replies or faults have become others since this was asked before; `exchangeCount` if none has. */
  takeChanged(): number {
    this.#giveUp();
    return this.#held.exchanges.takeChanged();
  }

  /** Waits no longer for what does not come any more: one that is not waited for never is again. */
  #giveUp(): void {
    const { exchanges, waitingLines } = this.#held;
    for (const exchange of waitingLines.keys()) {
      if (this.#isPending(exchange)) continue;
      waitingLines.delete(exchange);
      exchanges.note(exchange);
    }
  }

  summary(): TraceSummary {
    this.#giveUp();
    const { exchanges, replyTimes, units, waitingLines } = this.#held;
    const replyTime = replyTimes.spread;
    return {
      frames: this.size - this.pieces,
      exchanges: this.exchangeCount - this.pieces,
      faults: { ...exchanges.counts, 'no-reply': exchanges.unanswered - waitingLines.size },
      units: [...units.keys()].filter((unit) => units[unit] === 1),
      ...(replyTime && { replyTime }),
    };
  }

  /** A trace of the records from one on, as they were found here, with the requests that wait: it goes on as this one would. */
  behind(first: number): Trace {
    const { line } = this.#hearing;
    return new Trace({ timeout: this.timeout / MILLISECOND, line }, heldBehind(this.#held, first));
  }

  #demand(index: number): void {
    if (!Number.isInteger(index) || index < 0 || index >= this.size)
      throw new RangeError(`index: ${index} is not below ${this.size}`);
  }
}

/** The trace of records in their order. Never throws. */
export function traceOf(records: Iterable<TraceInput>, options?: TraceOptions): Trace {
  const trace = new Trace(options);
  for (const record of records) trace.add(record);
  return trace;
}
