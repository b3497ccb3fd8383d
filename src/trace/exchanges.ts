import { type Fault, type FaultKind, faultKinds } from './fault.ts';
import { countsColumn, indexColumn } from './numbers.ts';

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

/** How an exchange begins; records by their index. */
export interface Begun {
  readonly request?: number | undefined;
  readonly reply?: number | undefined;
  /** Whether nobody has to answer its request. */
  readonly isSilent: boolean;
  readonly subject: Subject;
}

/** Stands in a column for a record or an address that there is not. */
const NONE = -1;
const NO_FAULTS: readonly Fault[] = Object.freeze([]);

const present = (value: number): number | undefined => (value === NONE ? undefined : value);

/** Requests with their replies and what went wrong between them: a column for each of what they have, by exchange. */
export class Exchanges {
  readonly #request = indexColumn();
  readonly #reply = indexColumn();
  readonly #unit = countsColumn();
  readonly #function = countsColumn();
  readonly #address = indexColumn();
  readonly #quantity = countsColumn();
  readonly #silent = countsColumn();
  readonly #moreReplies = new Map<number, number[]>();
  readonly #faults = new Map<number, Fault[]>();
  readonly #counts = Object.fromEntries(faultKinds.map((kind) => [kind, 0])) as Record<FaultKind, number>;
  /** The first exchange that has become another since somebody asked. */
  #changed = Number.POSITIVE_INFINITY;
  #unanswered = 0;

  get count(): number {
    return this.#request.length;
  }

  /** How many faults of each kind there are, of those that were added. */
  get counts(): Readonly<Record<FaultKind, number>> {
    return this.#counts;
  }

  /** How many requests have no reply that somebody has to answer. */
  get unanswered(): number {
    return this.#unanswered;
  }

  /** A new exchange; answers its number. */
  begin({ request = NONE, reply = NONE, isSilent, subject }: Begun): number {
    const exchange = this.count;
    this.#request.push(request);
    this.#reply.push(reply);
    this.#unit.push(subject.unit);
    this.#function.push(subject.functionCode);
    this.#address.push(subject.address ?? NONE);
    this.#quantity.push(subject.quantity);
    this.#silent.push(Number(isSilent));
    if (this.isUnanswered(exchange)) this.#unanswered++;
    return exchange;
  }

  /** Adds a reply behind those that there are, or in front of them. */
  addReply(exchange: number, record: number, isFirst = false): void {
    this.note(exchange);
    if (this.isUnanswered(exchange)) this.#unanswered--;
    const before = this.#reply.at(exchange);
    if (before === NONE || isFirst) this.#reply.set(exchange, record);
    if (before === NONE) return;
    const more = this.#moreReplies.get(exchange) ?? [];
    if (isFirst) more.unshift(before);
    else more.push(record);
    this.#moreReplies.set(exchange, more);
  }

  addFault(exchange: number, fault: Fault): void {
    this.#counts[fault.kind]++;
    this.note(exchange);
    const faults = this.#faults.get(exchange);
    if (faults === undefined) this.#faults.set(exchange, [fault]);
    else faults.push(fault);
  }

  /** Takes back every fault of a kind. */
  forget(kind: FaultKind): void {
    for (const [exchange, faults] of this.#faults) {
      const others = faults.filter((fault) => fault.kind !== kind);
      if (others.length > 0) this.#faults.set(exchange, others);
      else this.#faults.delete(exchange);
    }
    this.#counts[kind] = 0;
    this.#changed = 0;
  }

  /** Notes that an exchange has become another. */
  note(exchange: number): void {
    if (exchange < this.#changed) this.#changed = exchange;
  }

  /** The first exchange that has become another since this was asked before; `count` if none has. */
  takeChanged(): number {
    const changed = Math.min(this.#changed, this.count);
    this.#changed = Number.POSITIVE_INFINITY;
    return changed;
  }

  subject(exchange: number): Subject {
    return {
      unit: this.#unit.at(exchange),
      functionCode: this.#function.at(exchange),
      address: present(this.#address.at(exchange)),
      quantity: this.#quantity.at(exchange),
    };
  }

  /** The record of the request. */
  request(exchange: number): number | undefined {
    return present(this.#request.at(exchange));
  }

  /** The record of the first reply. */
  reply(exchange: number): number | undefined {
    return present(this.#reply.at(exchange));
  }

  /** The records of all replies. */
  replies(exchange: number): readonly number[] {
    const reply = this.#reply.at(exchange);
    return reply === NONE ? [] : [reply, ...(this.#moreReplies.get(exchange) ?? [])];
  }

  /** Those that were added. */
  faults(exchange: number): readonly Fault[] {
    return this.#faults.get(exchange) ?? NO_FAULTS;
  }

  isSilent(exchange: number): boolean {
    return this.#silent.at(exchange) === 1;
  }

  /** Whether there is a request to be answered, and no reply. */
  isUnanswered(exchange: number): boolean {
    return this.#request.at(exchange) !== NONE && this.#reply.at(exchange) === NONE && !this.isSilent(exchange);
  }
}
