import { BROADCAST, fieldValue, type Reading, rtuSilences, sameBytes } from '../modbus/index.ts';
import type { Subject } from './exchanges.ts';
import type { FaultKind } from './fault.ts';
import type { Held } from './held.ts';
import type { Beside } from './known.ts';
import type { Carried, TraceInput } from './record.ts';
import { carriedAs, flawKind, type Told, tell } from './told.ts';
import type { Asked, Line } from './waiting.ts';

/** The speed of a line, and the bits of a character with start, parity and stop bits (10 or 11). */
export interface LineSpeed {
  readonly baud: number;
  readonly bits: number;
}

/** A record that is placed, with what is known of where. */
interface Heard {
  readonly index: number;
  readonly bytes: Uint8Array;
  readonly transport: Carried;
  readonly time: number | undefined;
  readonly line: Line;
}

const OTHER_TRANSACTION = 'transaction-not-as-requested';
const LIVE = Object.freeze({ kind: 'live' });
const SECOND = 1_000_000;
const EXCEPTION = 0x80;
/** Time-outs after which a reply to a request that was given up is not waited for. */
const LATEST = 10;

/** An adapter that hears itself is not a fault. */
const BESIDE_FAULTS: Readonly<Record<Beside, FaultKind | undefined>> = {
  echo: undefined,
  late: 'late',
  copy: 'stray',
  other: 'stray',
  noise: 'broken',
};

/** Hears one record after the other, and finds the exchange that each belongs to and what is wrong with it. */
export class Hearing {
  readonly #held: Held;
  /** How long a reply may stay away, in microseconds. */
  readonly #timeout: number;
  line: LineSpeed | undefined;

  constructor(held: Held, timeout: number, line: LineSpeed | undefined) {
    this.#held = held;
    this.#timeout = timeout;
    this.line = line;
  }

  /** Takes the next record. Never throws. */
  add(input: TraceInput): void {
    const { records, exchangeOf, waiting } = this.#held;
    const index = records.size;
    const { bytes, time, from, to, known } = input;
    const transport = input.transport ?? carriedAs(bytes, index > 0 ? records.transport(index - 1) : undefined);
    const line = waiting.line(transport, bytes, from, to);
    const beside = known?.beside;
    const told = beside
      ? tell(bytes, transport, beside === 'echo' ? 'request' : 'response', undefined, false)
      : this.#tell(input, transport, line.waiting.at(-1));
    records.add({ bytes, time, side: told.side, transport, from, to, place: input.place ?? LIVE, known });
    this.#held.noteTime(time);
    const heard: Heard = { index, bytes, transport, time, line };
    const exchange = beside
      ? this.#beside(heard, told, beside)
      : told.side === 'request'
        ? this.#ask(heard, told)
        : this.#answer(heard, told);
    exchangeOf.push(exchange);
    this.#judgeSilence(index, exchange);
  }

  #tell({ bytes, side, time }: TraceInput, transport: Carried, last: Asked | undefined): Told {
    const fresh = last?.time === undefined || time === undefined || time - last.time <= this.#timeout;
    return tell(bytes, transport, side, last && this.#bytes(last), fresh);
  }

  #bytes({ record }: Asked): Uint8Array {
    return this.#held.records.bytes(record);
  }

  /** A record read as the reply to a request. */
  #asReply({ bytes, transport }: Heard, asked: Asked): Told {
    return tell(bytes, transport, 'response', this.#bytes(asked), false);
  }

  /** A new exchange that begins with a request. */
  #ask({ index, bytes, line, time }: Heard, { reading, flaw }: Told): number {
    const { exchanges, records, units, waiting, waitingLines } = this.#held;
    const { unitId: unit = 0, transport } = reading;
    const isBroadcast = unit === BROADCAST && transport !== 'tcp';
    const outcome = records.known(index)?.outcome;
    const isSilent = isBroadcast || flaw !== undefined || (outcome !== undefined && outcome !== 'silent');
    const exchange = exchanges.begin({ request: index, isSilent, subject: subjectOf(reading) });
    if (flaw === undefined) units[unit] = 1;
    else this.#fault(exchange, flawKind(flaw, reading, bytes), flaw.code, [index]);
    if (!isBroadcast) {
      waiting.add(line, { exchange, record: index, damaged: flaw !== undefined, time, tcp: transport === 'tcp' });
      if (records.isLive(index) && outcome === undefined) waitingLines.set(exchange, line);
    }
    return exchange;
  }

  /** The exchange that a reply belongs to, which is a new one if nobody asked. */
  #answer(heard: Heard, told: Told): number {
    const { index, line, time } = heard;
    const { waiting } = line;
    const last = waiting.at(-1);
    if (last === undefined) return this.#answerOther(heard) ?? this.#stray(heard, told);
    if (told.echo) {
      this.#addReply(last.exchange, index);
      this.#fault(last.exchange, 'stray', 'echo', [index]);
      return last.exchange;
    }
    let [asked, found] = [last, told];
    if (told.strange) {
      // A reply to a request that was given up comes late, behind the next request.
      const fitting = waiting
        .slice(0, -1)
        .map((one) => [one, this.#asReply(heard, one)] as const)
        .find(([, { strange, flaw }]) => !strange && flaw === undefined);
      if (fitting) [asked, found] = fitting;
    }
    const { exchange } = asked;
    this.#addReply(exchange, index);
    this.#judgeReply(heard, exchange, found);
    const outcome = this.#held.records.known(asked.record)?.outcome;
    if (outcome === 'doubtful') this.#fault(exchange, 'doubtful', 'unsure', [index]);
    else if (found.flaw === undefined && !found.strange && outcome === undefined && asked === last)
      this.#judgeDoubt(heard, last);
    if (asked.time !== undefined && time !== undefined) this.#judgeTime(index, exchange, time - asked.time);
    this.#isAnswered(line, asked);
    return exchange;
  }

  /** No reply to this request is waited for any more. */
  #isAnswered(line: Line, asked: Asked): void {
    this.#held.waiting.answered(line, asked);
    this.#held.waitingLines.delete(asked.exchange);
  }

  /** What came beside the replies, as its source knows: a request that waits goes on waiting. */
  #beside(heard: Heard, told: Told, beside: Beside): number {
    const { index, line, time } = heard;
    const { waiting } = line;
    const last = waiting.at(-1);
    if (beside === 'echo' && last) return last.exchange;
    if (beside === 'late') {
      const fits = (one: Asked) => {
        const { strange, flaw } = this.#asReply(heard, one);
        return !strange && flaw === undefined;
      };
      const asked = waiting.slice(0, -1).findLast(fits) ?? waiting.slice(-1).find(fits);
      if (asked) {
        this.#addReply(asked.exchange, index);
        const after = asked.time !== undefined && time !== undefined ? time - asked.time : undefined;
        if (after !== undefined) this.#held.replyTimes.add(after);
        this.#fault(asked.exchange, 'late', 'late', [index], { after });
        this.#isAnswered(line, asked);
        return asked.exchange;
      }
    }
    const exchange = this.#held.exchanges.begin({
      [beside === 'echo' ? 'request' : 'reply']: index,
      isSilent: true,
      subject: subjectOf(told.reading),
    });
    if (beside === 'noise') this.#held.pieces++;
    const kind = BESIDE_FAULTS[beside];
    if (kind) this.#fault(exchange, kind, beside, [index]);
    return exchange;
  }

  /** A reply of TCP that answers the last request but for its transaction (TG 3.1.3). */
  #answerOther(heard: Heard): number | undefined {
    const { index, transport, time } = heard;
    const beside = transport === 'tcp' ? this.#held.waiting.lastBeside(heard.line) : undefined;
    if (beside === undefined) return undefined;
    const { asked, line } = beside;
    const { reading, flaw } = this.#asReply(heard, asked);
    const other = reading.problems.filter(({ code, severity }) => severity === 'error' && code !== OTHER_TRANSACTION);
    if (flaw !== undefined || other.length > 0) return undefined;
    const { exchange } = asked;
    this.#addReply(exchange, index);
    this.#fault(exchange, 'mismatch', OTHER_TRANSACTION, [index]);
    if (asked.time !== undefined && time !== undefined) this.#judgeTime(index, exchange, time - asked.time);
    this.#held.waiting.seemsAnswered(line);
    this.#held.waitingLines.delete(exchange);
    return exchange;
  }

  /** A reply that nobody asked for. */
  #stray({ index, bytes }: Heard, { reading, flaw }: Told): number {
    const exchange = this.#held.exchanges.begin({ reply: index, isSilent: false, subject: subjectOf(reading) });
    if (flaw === undefined) {
      this.#held.units[reading.unitId ?? 0] = 1;
      this.#fault(exchange, 'stray', 'no-request', [index]);
    } else this.#fault(exchange, flawKind(flaw, reading, bytes), flaw.code, [index]);
    return exchange;
  }

  #addReply(exchange: number, index: number): void {
    const { exchanges, records } = this.#held;
    exchanges.addReply(exchange, index, records.transport(index) === 'tcp' && this.#answers(exchange, index));
  }

  /** Whether a reply has the transaction of its request, which the first reply had not: it is the first one then. */
  #answers(exchange: number, index: number): boolean {
    const { exchanges } = this.#held;
    const [request, before] = [exchanges.request(exchange), exchanges.reply(exchange)];
    if (request === undefined || before === undefined) return false;
    const asked = this.#transaction(request);
    return asked === this.#transaction(index) && asked !== this.#transaction(before);
  }

  /** TG 3.1.3. */
  #transaction(record: number): string {
    return this.#held.records.bytes(record).subarray(0, 2).join();
  }

  #judgeReply({ index, bytes }: Heard, exchange: number, { reading, flaw, strange }: Told): void {
    const { unitId: unit = 0, functionCode = 0, fields } = reading;
    if (flaw !== undefined) {
      this.#fault(exchange, flawKind(flaw, reading, bytes), flaw.code, [index]);
      return;
    }
    this.#held.units[unit] = 1;
    if (strange) {
      const { code } = reading.problems.find(({ severity }) => severity === 'error') ?? { code: 'echo-differs' };
      this.#fault(exchange, 'mismatch', code, [index]);
    } else if ((functionCode & EXCEPTION) !== 0) {
      this.#fault(exchange, 'exception', 'exception', [index], { exception: fields['exceptionCode'] });
    }
  }

  /** Whether the reply to the last request may be the one to the request before it, which was given up. */
  #judgeDoubt(heard: Heard, last: Asked): void {
    const before = heard.line.waiting.at(-2);
    if (before === undefined || before.damaged || this.#isLater(before, heard.time)) return;
    if (this.#asReply(heard, before).strange || sameBytes(this.#bytes(before), this.#bytes(last))) return;
    const records = [before.record, heard.index];
    this.#fault(last.exchange, 'doubtful', 'may-answer-the-request-before', records);
  }

  /** Whether so long has passed since a request that its reply does not come any more. */
  #isLater(asked: Asked, time: number | undefined): boolean {
    return asked.time !== undefined && time !== undefined && time - asked.time > LATEST * this.#timeout;
  }

  #judgeTime(index: number, exchange: number, after: number): void {
    this.#held.replyTimes.add(after);
    const request = this.#held.exchanges.request(exchange);
    // Who has waited for it longer knows that it came in time.
    if (request !== undefined && this.#held.records.known(request) !== undefined) return;
    if (after > this.#timeout) this.#fault(exchange, 'late', 'late', [index], { after });
  }

  /** Judges the silences between all records by the speed of another line, or by none. */
  judgeSilences(line: LineSpeed | undefined): void {
    this.line = line;
    const { exchanges, exchangeOf, records } = this.#held;
    exchanges.forget('timing');
    for (let index = 0; index < records.size; index++) this.#judgeSilence(index, exchangeOf.at(index));
  }

  /** The silence before an RTU frame is at least t3.5 (SL 2.5.1.1); the time of a record is that of its first character. */
  #judgeSilence(index: number, exchange: number): void {
    if (this.line === undefined || index === 0) return;
    const { records } = this.#held;
    const [before, time] = [records.time(index - 1), records.time(index)];
    if (before === undefined || time === undefined) return;
    if (records.transport(index) !== 'rtu' || records.transport(index - 1) !== 'rtu') return;
    const { baud, bits } = this.line;
    const character = (bits * SECOND) / baud;
    const gap = time - before - records.length(index - 1) * character;
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
    this.#held.exchanges.addFault(exchange, { ...data, kind, code, records });
  }
}

function subjectOf(reading: Reading): Subject {
  const { unitId: unit = 0, functionCode = 0, fields, spans } = reading;
  const address = spans.find(({ kind }) => kind === 'address');
  const quantity = spans.find(({ kind }) => kind === 'quantity');
  // Where a list has the quantity, it is a derived value.
  const count = quantity && fieldValue(reading, quantity.name);
  const first = address && fields[address.name];
  return {
    unit,
    functionCode: functionCode & ~EXCEPTION,
    address: typeof first === 'number' ? first : undefined,
    quantity: typeof count === 'number' ? count : 1,
  };
}
