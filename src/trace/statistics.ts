import type { Subject } from './exchanges.ts';
import { type FaultKind, faultKinds } from './fault.ts';
import { Distribution, type Spread } from './spread.ts';
import type { Trace } from './trace.ts';

/** The exchanges of one unit, function, address, connection, or of one request that is sent again and again. */
export interface Tally {
  readonly unit: number | undefined;
  readonly functionCode: number | undefined;
  readonly address: number | undefined;
  readonly quantity: number | undefined;
  /** The two ends of a connection, the one that asks first; `undefined` where the records name none. */
  readonly connection: string | undefined;
  readonly exchanges: number;
  readonly replies: number;
  readonly faults: Readonly<Record<FaultKind, number>>;
  /** How often each exception came, by its code. */
  readonly exceptions: ReadonlyMap<number, number>;
  readonly replyTime: Spread | undefined;
  /** From one request to the next of the same. */
  readonly interval: Spread | undefined;
}

/** By what exchanges are counted together. */
export const tallied = ['unit', 'function', 'address', 'connection', 'poll'] as const;
export type Tallied = (typeof tallied)[number];

class Counts {
  exchanges = 0;
  replies = 0;
  readonly faults = Object.fromEntries(faultKinds.map((kind) => [kind, 0])) as Record<FaultKind, number>;
  readonly exceptions = new Map<number, number>();
  readonly times = new Distribution();
  readonly intervals = new Distribution();
  asked: number | undefined;
  readonly subject: Partial<Subject> & { readonly connection?: string | undefined };

  constructor(subject: Counts['subject']) {
    this.subject = subject;
  }

  get tally(): Tally {
    const { subject, exchanges, replies, faults, exceptions, times, intervals } = this;
    const { unit, functionCode, address, quantity, connection } = subject;
    return {
      unit,
      functionCode,
      address,
      quantity,
      connection,
      exchanges,
      replies,
      faults,
      exceptions,
      replyTime: times.spread,
      interval: intervals.spread,
    };
  }
}

/** What exchanges of a trace are like, counted in several ways at once; a trace that has grown is gone on with. */
export class Statistics {
  readonly #trace: Trace;
  readonly #groups = new Map<Tallied, Map<string, Counts>>(tallied.map((by) => [by, new Map()]));
  #next = 0;

  constructor(trace: Trace) {
    this.#trace = trace;
  }

  /** How many exchanges have been counted. */
  get taken(): number {
    return this.#next;
  }

  /** Takes the exchanges that are settled, `most` at a time: the last `open` of them may still change, and are left for later. */
  take(open = 0, most = Number.POSITIVE_INFINITY): this {
    const end = Math.min(this.#trace.exchangeCount - open, this.#next + most);
    const step = 1024;
    for (; this.#next < end; ) {
      const to = Math.min(end, this.#next + step);
      for (const exchange of this.#trace.exchanges(this.#next, to)) this.#count(this.#next++, exchange);
    }
    return this;
  }

  #count(index: number, { request, replies, after, faults }: ReturnType<Trace['exchanges']>[number]): void {
    if (this.#trace.isPiece(index)) return;
    const subject = this.#trace.subject(index);
    const record = request ?? replies[0];
    const { connection, time } = record === undefined ? {} : this.#trace.spoken(record);
    const { unit, functionCode, address, quantity } = subject;
    const groups: readonly (readonly [Tallied, string, Counts['subject']])[] = [
      ['unit', `${unit}`, { unit }],
      ['function', `${functionCode}`, { functionCode }],
      ['address', `${unit} ${functionCode} ${address}`, { unit, functionCode, address }],
      ['connection', connection ?? '', { connection }],
      ['poll', `${connection} ${unit} ${functionCode} ${address} ${quantity}`, { ...subject, connection }],
    ];
    for (const [by, key, what] of groups) {
      if (by === 'address' && address === undefined) continue;
      const group = this.#groups.get(by) as Map<string, Counts>;
      let counts = group.get(key);
      if (counts === undefined) {
        counts = new Counts(what);
        group.set(key, counts);
      }
      counts.exchanges++;
      counts.replies += replies.length > 0 ? 1 : 0;
      if (after !== undefined) counts.times.add(after);
      if (request !== undefined && time !== undefined) {
        if (counts.asked !== undefined) counts.intervals.add(time - counts.asked);
        counts.asked = time;
      }
      for (const fault of faults) {
        counts.faults[fault.kind]++;
        const { exception } = fault;
        if (fault.kind === 'exception' && typeof exception === 'number') {
          counts.exceptions.set(exception, (counts.exceptions.get(exception) ?? 0) + 1);
        }
      }
    }
  }

  /** The tallies of one kind, those with the lowest numbers first. */
  by(kind: Tallied): readonly Tally[] {
    const group = this.#groups.get(kind) ?? new Map<string, Counts>();
    const order = ({ unit = -1, functionCode = -1, address = -1 }: Tally) => [unit, functionCode, address] as const;
    return [...group.values()]
      .map(({ tally }) => tally)
      .sort((a, b) => {
        const [one, other] = [order(a), order(b)];
        return one[0] - other[0] || one[1] - other[1] || one[2] - other[2];
      });
  }
}
