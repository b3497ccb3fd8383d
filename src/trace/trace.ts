import { diagnose, type Finding } from '../diagnosis/index.ts';
import { BROADCAST, decodeFrame, fieldValue, type Reading, rtuSilences } from '../modbus/index.ts';
import { type Exchange, type Fault, type FaultKind, faultKinds } from './fault.ts';
import type { Beside, Known } from './known.ts';
import { countsColumn, indexColumn } from './numbers.ts';
import type { CaptureRecord, TraceInput } from './record.ts';
import { Records } from './records.ts';
import { Distribution, type Spread } from './spread.ts';
import { carriedAs, flawKind, type Told, tell } from './told.ts';
import { type Asked, type Line, Waiting } from './waiting.ts';

export interface TraceOptions {
  /** How long a reply may stay away, in milliseconds; 1000 if it is left out. */
  readonly timeout?: number | undefined;
  /** The speed of the line, and the bits of a character with start, parity and stop bits (10 or 11): then silences are judged. */
  readonly line?: { readonly baud: number; readonly bits: number } | undefined;
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

/** Whom an exchange is with, and what it is about; without a request, as far as the reply says it. */
export interface Subject {
  /** NaN, like the function, of bytes in no frame. */
  readonly unit: number;
  /** Without the exception bit. */
  readonly functionCode: number;
  /** The first address, as sent. */
  readonly address: number | undefined;
  /** How many registers or bits; 1 if the function has no quantity. */
  readonly quantity: number;
}

/** Who spoke to whom, when and how. */
export type Spoken = Pick<CaptureRecord, 'time' | 'transport' | 'side'> & { readonly connection: string | undefined };

const OTHER_TRANSACTION = 'transaction-not-as-requested';
const NONE = -1;
const LIVE = Object.freeze({ kind: 'live' });
const NO_SUBJECT: Subject = Object.freeze({ unit: NaN, functionCode: NaN, address: undefined, quantity: 0 });
const NO_FAULTS: readonly Fault[] = Object.freeze([]);
const TIMEOUT = 1000;
const MILLISECOND = 1000;
const SECOND = 1_000_000;
const EXCEPTION = 0x80;
const UNITS = 256;
/** A frame of such a fault is not one of a unit; and where one is, its unit may be another than that of its exchange. */
const DAMAGED: ReadonlySet<FaultKind> = new Set(['checksum', 'broken']);
const UNSURE_UNIT: ReadonlySet<FaultKind> = new Set([...DAMAGED, 'mismatch']);

/** An adapter that hears itself is not a fault. */
const BESIDE_FAULTS: Readonly<Record<Beside, FaultKind | undefined>> = {
  echo: undefined,
  late: 'late',
  copy: 'stray',
  other: 'stray',
  noise: 'broken',
};

/** Requests and replies in their order, and what went wrong between them. */
export class Trace {
  #records = new Records();
  readonly #exchangeOf = indexColumn();
  readonly #request = indexColumn();
  readonly #reply = indexColumn();
  /** Whom a request is for, and what it is about: by exchange. */
  readonly #unit = countsColumn();
  readonly #function = countsColumn();
  readonly #address = indexColumn();
  readonly #quantity = countsColumn();
  readonly #moreReplies = new Map<number, number[]>();
  readonly #faults = new Map<number, Fault[]>();
  /** By exchange, whether nobody has to answer its request: a broadcast, or a damaged one. */
  readonly #silent = countsColumn();
  readonly #waiting = new Waiting();
  /** The lines of the exchanges that may still get a reply, as far as is known. */
  readonly #waitingLines = new Map<number, Line>();
  readonly #replyTimes = new Distribution();
  readonly #counts: Record<FaultKind, number>;
  readonly #units = new Uint8Array(UNITS);
  /** How long a reply may stay away, in microseconds. */
  readonly timeout: number;
  #line: TraceOptions['line'];
  #unanswered = 0;
  #pieces = 0;
  /** The first exchange that has become another since somebody asked. */
  #changed = Number.POSITIVE_INFINITY;
  #newest = Number.NaN;
  #oldest = Number.NaN;

  constructor({ timeout = TIMEOUT, line }: TraceOptions = {}) {
    this.timeout = timeout * MILLISECOND;
    this.#line = line;
    this.#counts = Object.fromEntries(faultKinds.map((kind) => [kind, 0])) as Record<FaultKind, number>;
  }

  /** How many records there are. */
  get size(): number {
    return this.#records.size;
  }

  get exchangeCount(): number {
    return this.#request.length;
  }

  /** How many of the records are bytes in no frame; each has an exchange of its own. */
  get pieces(): number {
    return this.#pieces;
  }

  /** Takes the next record. Never throws. */
  add(input: TraceInput): void {
    const index = this.size;
    const { bytes, time, from, to, known } = input;
    const before = index > 0 ? this.#records.transport(index - 1) : undefined;
    const transport = input.transport ?? carriedAs(bytes, before);
    const line = this.#waiting.line(transport, bytes, from, to);
    const { waiting } = line;
    const last = waiting.at(-1);
    const beside = known?.beside;
    const told = beside
      ? tell(bytes, transport, beside === 'echo' ? 'request' : 'response', undefined, false)
      : this.#tell(input, transport, last);
    this.#records.add({ bytes, time, side: told.side, transport, from, to, place: input.place ?? LIVE, known });
    this.#noteTime(time);
    const exchange = beside
      ? this.#beside(index, told, beside, line, waiting, input)
      : told.side === 'request'
        ? this.#ask(index, told, line, time)
        : this.#answer(index, told, line, waiting, input, transport);
    this.#exchangeOf.push(exchange);
    this.#judgeSilence(index, exchange);
  }

  #noteTime(time: number | undefined): void {
    if (time !== undefined && !(time <= this.#newest)) this.#newest = time;
    if (time !== undefined && !(time >= this.#oldest)) this.#oldest = time;
  }

  #tell(input: TraceInput, transport: CaptureRecord['transport'], last: Asked | undefined): Told {
    const fresh = last?.time === undefined || input.time === undefined || input.time - last.time <= this.timeout;
    return tell(input.bytes, transport, input.side, last && this.#records.bytes(last.record), fresh);
  }

  /** A new exchange that begins with a request. */
  #ask(index: number, { reading, flaw }: Told, line: Line, time: number | undefined): number {
    const exchange = this.#request.length;
    this.#request.push(index);
    this.#reply.push(NONE);
    const { unitId: unit = 0, transport } = reading;
    this.#describe(reading);
    if (flaw !== undefined)
      this.#fault(exchange, flawKind(flaw, reading, this.#records.bytes(index)), flaw.code, [index]);
    else this.#units[unit] = 1;
    const isBroadcast = unit === BROADCAST && transport !== 'tcp';
    const outcome = this.#records.known(index)?.outcome;
    const isSilent = isBroadcast || flaw !== undefined || (outcome !== undefined && outcome !== 'silent');
    this.#silent.push(Number(isSilent));
    if (!isSilent) this.#unanswered++;
    if (!isBroadcast) {
      this.#waiting.add(line, { exchange, record: index, damaged: flaw !== undefined, time, tcp: transport === 'tcp' });
      if (this.#records.isLive(index) && outcome === undefined) this.#waitingLines.set(exchange, line);
    }
    return exchange;
  }

  /** The exchange that a reply belongs to, which is a new one if nobody asked. */
  #answer(
    index: number,
    told: Told,
    line: Line,
    waiting: readonly Asked[],
    { bytes, time }: TraceInput,
    transport: CaptureRecord['transport'],
  ): number {
    const last = waiting.at(-1);
    if (last === undefined) return this.#answerOther(index, line, bytes, transport, time) ?? this.#stray(index, told);
    if (told.echo) {
      this.#addReply(last.exchange, index);
      this.#fault(last.exchange, 'stray', 'echo', [index]);
      return last.exchange;
    }
    let asked = last;
    let { reading, flaw, strange } = told;
    // A reply to a request that was given up comes late, behind the next request.
    const fitting = strange
      ? waiting
          .slice(0, -1)
          .map((one) => ({ one, told: tell(bytes, transport, 'response', this.#records.bytes(one.record), false) }))
          .find(({ told }) => !told.strange && told.flaw === undefined)
      : undefined;
    if (fitting) {
      asked = fitting.one;
      ({ reading, flaw, strange } = fitting.told);
    }
    const { exchange } = asked;
    this.#addReply(exchange, index);
    this.#judgeReply(index, exchange, { reading, flaw, strange });
    const outcome = this.#records.known(asked.record)?.outcome;
    if (outcome === 'doubtful') this.#fault(exchange, 'doubtful', 'unsure', [index]);
    if (flaw === undefined && !strange && outcome === undefined) {
      const before = waiting.at(-2);
      const doubtful =
        asked === last &&
        before !== undefined &&
        !before.damaged &&
        !this.#isLater(before, time) &&
        !tell(bytes, transport, 'response', this.#records.bytes(before.record), false).strange &&
        !this.#asksTheSame(before, last);
      if (doubtful) this.#fault(exchange, 'doubtful', 'may-answer-the-request-before', [before.record, index]);
    }
    if (asked.time !== undefined && time !== undefined) this.#judgeTime(index, exchange, time - asked.time);
    this.#waiting.answered(line, asked);
    this.#waitingLines.delete(exchange);
    return exchange;
  }

  /** What came beside the replies, as its source knows: a request that waits goes on waiting. */
  #beside(
    index: number,
    told: Told,
    beside: Beside,
    line: Line,
    waiting: readonly Asked[],
    { bytes, time }: TraceInput,
  ): number {
    const [last] = waiting.slice(-1);
    if (beside === 'echo' && last) return last.exchange;
    if (beside === 'late') {
      const transport = this.#records.transport(index);
      const fits = ({ record }: Asked) => {
        const { strange, flaw } = tell(bytes, transport, 'response', this.#records.bytes(record), false);
        return !strange && flaw === undefined;
      };
      const asked = waiting.slice(0, -1).findLast(fits) ?? waiting.slice(-1).find(fits);
      if (asked) {
        this.#addReply(asked.exchange, index);
        const after = asked.time !== undefined && time !== undefined ? time - asked.time : undefined;
        if (after !== undefined) this.#replyTimes.add(after);
        this.#fault(asked.exchange, 'late', 'late', [index], { after });
        this.#waiting.answered(line, asked);
        this.#waitingLines.delete(asked.exchange);
        return asked.exchange;
      }
    }
    const exchange = this.#request.length;
    this.#request.push(beside === 'echo' ? index : NONE);
    this.#reply.push(beside === 'echo' ? NONE : index);
    this.#silent.push(1);
    this.#describe(told.reading);
    if (beside === 'noise') this.#pieces++;
    const kind = BESIDE_FAULTS[beside];
    if (kind) this.#fault(exchange, kind, beside, [index]);
    return exchange;
  }

  /** A reply of TCP that answers the last request but for its transaction (TG 3.1.3). */
  #answerOther(
    index: number,
    line: Line,
    bytes: Uint8Array,
    transport: CaptureRecord['transport'],
    time: number | undefined,
  ): number | undefined {
    const beside = transport === 'tcp' ? this.#waiting.lastBeside(line) : undefined;
    if (beside === undefined) return undefined;
    const { asked } = beside;
    const { reading, flaw } = tell(bytes, transport, 'response', this.#records.bytes(asked.record), false);
    const other = reading.problems.filter(({ code, severity }) => severity === 'error' && code !== OTHER_TRANSACTION);
    if (flaw !== undefined || other.length > 0) return undefined;
    const { exchange } = asked;
    this.#addReply(exchange, index);
    this.#fault(exchange, 'mismatch', OTHER_TRANSACTION, [index]);
    if (asked.time !== undefined && time !== undefined) this.#judgeTime(index, exchange, time - asked.time);
    this.#waiting.seemsAnswered(beside.line);
    this.#waitingLines.delete(exchange);
    return exchange;
  }

  /** Whether so long has passed since a request that its reply does not come any more. */
  #isLater(asked: Asked, time: number | undefined): boolean {
    return asked.time !== undefined && time !== undefined && time - asked.time > LATEST * this.timeout;
  }

  #asksTheSame(one: Asked, other: Asked): boolean {
    const [a, b] = [this.#records.bytes(one.record), this.#records.bytes(other.record)];
    return a.length === b.length && a.every((byte, at) => byte === b[at]);
  }

  #judgeReply(
    index: number,
    exchange: number,
    { reading, flaw, strange }: Pick<Told, 'reading' | 'flaw' | 'strange'>,
  ): void {
    const { unitId: unit = 0, functionCode = 0, fields } = reading;
    if (flaw !== undefined) {
      this.#fault(exchange, flawKind(flaw, reading, this.#records.bytes(index)), flaw.code, [index]);
      return;
    }
    this.#units[unit] = 1;
    if (strange) {
      const { code } = reading.problems.find(({ severity }) => severity === 'error') ?? { code: 'echo-differs' };
      this.#fault(exchange, 'mismatch', code, [index]);
    } else if ((functionCode & EXCEPTION) !== 0) {
      this.#fault(exchange, 'exception', 'exception', [index], { exception: fields['exceptionCode'] });
    }
  }

  #judgeTime(index: number, exchange: number, after: number): void {
    this.#replyTimes.add(after);
    const request = this.#request.at(exchange);
    // Who has waited for it longer knows that it came in time.
    if (request !== NONE && this.#records.known(request) !== undefined) return;
    if (after > this.timeout) this.#fault(exchange, 'late', 'late', [index], { after });
  }

  #stray(index: number, { reading, flaw }: Told): number {
    const exchange = this.#request.length;
    this.#request.push(NONE);
    this.#reply.push(index);
    this.#silent.push(0);
    this.#describe(reading);
    if (flaw === undefined) {
      this.#units[reading.unitId ?? 0] = 1;
      this.#fault(exchange, 'stray', 'no-request', [index]);
    } else this.#fault(exchange, flawKind(flaw, reading, this.#records.bytes(index)), flaw.code, [index]);
    return exchange;
  }

  #describe(reading: Reading): void {
    const { unitId = 0, functionCode = 0, fields, spans } = reading;
    const address = spans.find(({ kind }) => kind === 'address');
    const quantity = spans.find(({ kind }) => kind === 'quantity');
    // Where a list has the quantity, it is a derived value.
    const count = quantity && fieldValue(reading, quantity.name);
    const first = address && fields[address.name];
    this.#unit.push(unitId);
    this.#function.push(functionCode & ~EXCEPTION);
    this.#address.push(typeof first === 'number' ? first : NONE);
    this.#quantity.push(typeof count === 'number' ? count : 1);
  }

  #addReply(exchange: number, index: number): void {
    this.#changed = Math.min(this.#changed, exchange);
    if (this.#reply.at(exchange) === NONE) {
      this.#reply.set(exchange, index);
      if (!this.#isSilent(exchange)) this.#unanswered--;
      return;
    }
    const more = this.#moreReplies.get(exchange) ?? [];
    // The reply of its own transaction is the first one, whatever came before it.
    if (this.#records.transport(index) === 'tcp' && this.#answers(exchange, index)) {
      more.unshift(this.#reply.at(exchange));
      this.#reply.set(exchange, index);
    } else more.push(index);
    this.#moreReplies.set(exchange, more);
  }

  /** Whether a reply has the transaction of its request, which the first reply had not (TG 3.1.3). */
  #answers(exchange: number, index: number): boolean {
    const transaction = (record: number) => this.#records.bytes(record).subarray(0, 2).join();
    if (this.#request.at(exchange) === NONE) return false;
    const asked = transaction(this.#request.at(exchange));
    return asked === transaction(index) && asked !== transaction(this.#reply.at(exchange));
  }

  /** Judges the silences between all records by the speed of another line, or by none. */
  judgeSilences(line: TraceOptions['line']): void {
    this.#line = line;
    for (const [exchange, faults] of this.#faults) {
      const others = faults.filter(({ kind }) => kind !== 'timing');
      if (others.length > 0) this.#faults.set(exchange, others);
      else this.#faults.delete(exchange);
    }
    this.#counts.timing = 0;
    for (let index = 0; index < this.size; index++) this.#judgeSilence(index, this.#exchangeOf.at(index));
    this.#changed = 0;
  }

  /** The silence before an RTU frame is at least t3.5 (SL 2.5.1.1); the time of a record is that of its first character. */
  #judgeSilence(index: number, exchange: number): void {
    if (this.#line === undefined || index === 0) return;
    const [before, time] = [this.#records.time(index - 1), this.#records.time(index)];
    if (before === undefined || time === undefined) return;
    if (this.#records.transport(index) !== 'rtu' || this.#records.transport(index - 1) !== 'rtu') return;
    const { baud, bits } = this.#line;
    const character = (bits * SECOND) / baud;
    const gap = time - before - this.#records.length(index - 1) * character;
    const least = rtuSilences(baud, bits).t35;
    // A time that lies within the frame before is not that of a first character.
    if (gap < -character || gap >= least) return;
    this.#fault(exchange, 'timing', 'silence-short', [index - 1, index], { gap: Math.max(0, gap), least });
  }

  #fault(
    exchange: number,
    kind: FaultKind,
    code: string,
    records: readonly number[],
    data?: Readonly<Record<string, unknown>>,
  ): void {
    const fault: Fault = { ...data, kind, code, records };
    this.#counts[kind]++;
    this.#changed = Math.min(this.#changed, exchange);
    const faults = this.#faults.get(exchange);
    if (faults === undefined) this.#faults.set(exchange, [fault]);
    else faults.push(fault);
  }

  /** A record, with what its bytes are found to be. Throws a `RangeError` for an index that is not one of a record. */
  record(index: number): CaptureRecord & { readonly findings: readonly Finding[] } {
    this.#demand(index, this.size);
    const record = this.#records.record(index);
    const request = this.#request.at(this.#exchangeOf.at(index));
    const asked = request !== NONE && request !== index ? this.#records.bytes(request) : undefined;
    return { ...record, findings: diagnose(record.bytes, { transport: record.transport, request: asked }) };
  }

  /** A record as it is kept. Throws a `RangeError` for an index that is not one of a record. */
  plain(index: number): CaptureRecord {
    this.#demand(index, this.size);
    return this.#records.record(index);
  }

  /** What its source knows of a record better than its bytes. */
  known(index: number): Known | undefined {
    return this.#records.known(index);
  }

  /** The bytes of a record. Throws a `RangeError` for an index that is not one of a record. */
  bytes(index: number): Uint8Array {
    this.#demand(index, this.size);
    return this.#records.bytes(index);
  }

  /** When a record was made; `undefined` if its source has no times. */
  time(index: number): number | undefined {
    return this.#records.time(index);
  }

  /** The earliest and the latest time of the records; `undefined` if none of them has a time. */
  get span(): { readonly first: number; readonly last: number } | undefined {
    return Number.isNaN(this.#newest) ? undefined : { first: this.#oldest, last: this.#newest };
  }

  /** Who spoke to whom, when and how; the ends of a connection with the one that asks first. */
  spoken(index: number): Spoken {
    const [from, to] = this.#records.ends(index);
    const side = this.#records.side(index);
    const ends = side === 'response' ? [to, from] : [from, to];
    const connection = from === undefined && to === undefined ? undefined : `${ends[0] ?? ''} → ${ends[1] ?? ''}`;
    return { connection, time: this.#records.time(index), transport: this.#records.transport(index), side };
  }

  side(index: number): CaptureRecord['side'] {
    return this.#records.side(index);
  }

  transport(index: number): CaptureRecord['transport'] {
    return this.#records.transport(index);
  }

  /** Whether a record is a frame; others are bytes, or words, in no frame. */
  isFrame(index: number): boolean {
    return this.#pieces === 0 || this.#records.known(index)?.beside !== 'noise';
  }

  /** The exchange that a record belongs to. Throws a `RangeError` for an index that is not one of a record. */
  exchangeOf(index: number): number {
    this.#demand(index, this.size);
    return this.#exchangeOf.at(index);
  }

  /** The exchanges `[from, to)`, as far as there are such. */
  exchanges(from: number, to: number): readonly Exchange[] {
    const found: Exchange[] = [];
    for (let index = Math.max(0, from); index < Math.min(to, this.exchangeCount); index++)
      found.push(this.#exchange(index));
    return found;
  }

  /** Whom an exchange is with, and what it is about. */
  subject(exchange: number): Subject {
    if (this.isPiece(exchange)) return NO_SUBJECT;
    const address = this.#address.at(exchange);
    return {
      unit: this.#unit.at(exchange),
      functionCode: this.#function.at(exchange),
      address: address === NONE ? undefined : address,
      quantity: this.#quantity.at(exchange),
    };
  }

  /** Whether an exchange stands for bytes in no frame. */
  isPiece(exchange: number): boolean {
    return this.#pieces > 0 && this.#request.at(exchange) === NONE && !this.isFrame(this.#reply.at(exchange));
  }

  /** The faults of an exchange. */
  faults(exchange: number): readonly Fault[] {
    const faults = this.#faults.get(exchange) ?? NO_FAULTS;
    if (!this.#isUnanswered(exchange)) return faults;
    return [...faults, { kind: 'no-reply', code: 'no-reply', records: [this.#request.at(exchange)] }];
  }

  /** The record of the request of an exchange. */
  requestOf(exchange: number): number | undefined {
    const request = this.#request.at(exchange);
    return request === NONE ? undefined : request;
  }

  /** The record of the first reply of an exchange. */
  replyOf(exchange: number): number | undefined {
    const reply = this.#reply.at(exchange);
    return reply === NONE ? undefined : reply;
  }

  /** When an exchange began: the time of its request, or of the reply that nobody asked for. */
  began(exchange: number): number | undefined {
    const request = this.#request.at(exchange);
    return this.#records.time(request === NONE ? this.#reply.at(exchange) : request);
  }

  /** Microseconds from the request of an exchange to its first reply, if both have a time. */
  after(exchange: number): number | undefined {
    const [request, reply] = [this.#request.at(exchange), this.#reply.at(exchange)];
    if (request === NONE || reply === NONE) return undefined;
    const [asked, answered] = [this.#records.time(request), this.#records.time(reply)];
    return asked === undefined || answered === undefined ? undefined : answered - asked;
  }

  #exchange(index: number): Exchange {
    const request = this.#request.at(index);
    const after = this.after(index);
    return {
      ...(request !== NONE && { request }),
      replies: this.#replies(index),
      ...(after !== undefined && { after }),
      faults: this.faults(index),
    };
  }

  #replies(exchange: number): readonly number[] {
    const reply = this.#reply.at(exchange);
    return reply === NONE ? [] : [reply, ...(this.#moreReplies.get(exchange) ?? [])];
  }

  #isSilent(exchange: number): boolean {
    return this.#silent.at(exchange) === 1;
  }

  #isUnanswered(index: number): boolean {
    if (this.#request.at(index) === NONE || this.#reply.at(index) !== NONE || this.#isSilent(index)) return false;
    return !this.#isPending(index);
  }

  /** Whether a reply may still come: to what is heard just now, the last on its line, and not longer ago than the time-out. */
  #isPending(index: number): boolean {
    const line = this.#waitingLines.get(index);
    const record = this.#request.at(index);
    if (line === undefined || this.#reply.at(index) !== NONE || this.#isSilent(index)) return false;
    if (line.waiting.at(-1)?.exchange !== index) return false;
    const time = this.#records.time(record);
    return time === undefined || Number.isNaN(this.#newest) || this.#newest - time <= this.timeout;
  }

  /** The first exchange whose replies or faults have become others since this was asked before; `exchangeCount` if none has. */
  takeChanged(): number {
    this.#giveUp();
    const changed = Math.min(this.#changed, this.exchangeCount);
    this.#changed = Number.POSITIVE_INFINITY;
    return changed;
  }

  /** Waits no longer for what does not come any more: one that is not waited for never is again. */
  #giveUp(): void {
    for (const index of this.#waitingLines.keys()) {
      if (this.#isPending(index)) continue;
      this.#waitingLines.delete(index);
      this.#changed = Math.min(this.#changed, index);
    }
  }

  summary(): TraceSummary {
    this.#giveUp();
    const pending = this.#waitingLines.size;
    const units: number[] = [];
    this.#units.forEach((seen, unit) => {
      if (seen) units.push(unit);
    });
    const replyTime = this.#replyTimes.spread;
    return {
      frames: this.size - this.#pieces,
      exchanges: this.exchangeCount - this.#pieces,
      faults: { ...this.#counts, 'no-reply': this.#unanswered - pending },
      units,
      ...(replyTime && { replyTime }),
    };
  }

  /**
   * A trace of the records from one on, as they were found here, with the requests that wait: it goes on as this one would. Nothing is
   * decoded again; an exchange that began before it keeps what belongs to it of the records that stay.
   */
  behind(first: number): Trace {
    const rest = new Trace({ timeout: this.timeout / MILLISECOND, line: this.#line });
    rest.#records = this.#records.behind(first);
    const numbers = new Map<number, number>();
    for (let at = first; at < this.size; at++) {
      rest.#noteTime(this.#records.time(at));
      const exchange = this.#exchangeOf.at(at);
      let number = numbers.get(exchange);
      if (number === undefined) {
        number = rest.exchangeCount;
        numbers.set(exchange, number);
        rest.#takeExchange(this, exchange, at, first);
      }
      if (!this.isFrame(at)) rest.#pieces++;
      rest.#exchangeOf.push(number);
    }
    const renumbered = (asked: Asked): Asked | undefined => {
      const exchange = asked.record < first ? undefined : numbers.get(asked.exchange);
      return exchange === undefined ? undefined : { ...asked, exchange, record: asked.record - first };
    };
    const lines = rest.#waiting.takeFrom(this.#waiting, renumbered);
    for (const [exchange, before] of this.#waitingLines) {
      const [number, line] = [numbers.get(exchange), lines.get(before)];
      if (number !== undefined && line) rest.#waitingLines.set(number, line);
    }
    return rest;
  }

  /** Takes an exchange of another trace, of whose records those from `first` on are kept; `at` is the first of them. */
  #takeExchange(of: Trace, exchange: number, at: number, first: number): void {
    const number = this.exchangeCount;
    const kept = (records: readonly number[]) => records.flatMap((index) => (index < first ? [] : [index - first]));
    const [asked, all] = [of.#request.at(exchange), of.#replies(exchange)];
    const replies = kept(all);
    const isAsked = asked >= first;
    this.#request.push(isAsked ? asked - first : replies.length > 0 ? NONE : at - first);
    this.#reply.push(replies[0] ?? NONE);
    if (replies.length > 1) this.#moreReplies.set(number, replies.slice(1));
    this.#unit.push(of.#unit.at(exchange));
    this.#function.push(of.#function.at(exchange));
    this.#address.push(of.#address.at(exchange));
    this.#quantity.push(of.#quantity.at(exchange));
    const isSilent = !isAsked || of.#isSilent(exchange);
    this.#silent.push(Number(isSilent));
    if (!isSilent && replies.length === 0) this.#unanswered++;
    const found = of.#faults.get(exchange) ?? NO_FAULTS;
    for (const { kind, code, records, ...data } of found)
      if ((records.at(-1) ?? NONE) >= first) this.#fault(number, kind, code, kept(records), data);
    if (isAsked) {
      const echoes = found.flatMap(({ code, records }) => (code === 'echo' ? records : []));
      const sent = of.time(asked) ?? Number.NaN;
      for (const reply of all) if (!echoes.includes(reply)) this.#replyTimes.add((of.time(reply) ?? Number.NaN) - sent);
    }
    this.#noteUnits(
      of,
      exchange,
      (isAsked ? [asked, ...all] : all).filter((index) => index >= first),
    );
  }

  /** Notes who speaks in the records of another trace's exchange that a receiver takes. */
  #noteUnits(of: Trace, exchange: number, records: readonly number[]): void {
    const found = of.#faults.get(exchange) ?? NO_FAULTS;
    if (found.every(({ kind }) => !UNSURE_UNIT.has(kind))) {
      if (records.some((index) => of.known(index)?.beside === undefined)) this.#units[of.#unit.at(exchange)] = 1;
      return;
    }
    const damaged = new Set(found.flatMap(({ kind, records }) => (DAMAGED.has(kind) ? records : [])));
    for (const index of records) {
      if (damaged.has(index) || of.known(index)?.beside !== undefined) continue;
      const { unitId = 0 } = decodeFrame(of.bytes(index), {
        transport: of.transport(index),
        direction: of.side(index) ?? 'request',
      });
      this.#units[unitId] = 1;
    }
  }

  #demand(index: number, size: number): void {
    if (!Number.isInteger(index) || index < 0 || index >= size)
      throw new RangeError(`index: ${index} is not below ${size}`);
  }
}

/** Time-outs after which a reply to a request that was given up is not waited for. */
const LATEST = 10;

/** The trace of records in their order. Never throws. */
export function traceOf(records: Iterable<TraceInput>, options?: TraceOptions): Trace {
  const trace = new Trace(options);
  for (const record of records) trace.add(record);
  return trace;
}
