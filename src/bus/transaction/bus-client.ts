import type { Clock } from '../clock.ts';
import { defaultSettings, type LineError, type Link, type LinkEvent } from '../link/link.ts';
import { Listeners } from '../listeners.ts';
import { piecesOf } from './arrivals.ts';
import { Exchange } from './exchange.ts';
import { LineMemory } from './line-memory.ts';
import type { Stray, TransactionResult } from './result.ts';
import { defaultRules, lineTimes, type TransactionRules } from './rules.ts';

/** What a log of the bus is made of, in its order. Times are the clock's. */
export type BusEvent =
  | { readonly kind: 'sent'; readonly bytes: Uint8Array; readonly at: number }
  /** As it came, before anything is known of it. */
  | { readonly kind: 'received'; readonly bytes: Uint8Array; readonly at: number }
  | { readonly kind: 'line-error'; readonly error: LineError; readonly at: number }
  /** Bytes between transactions. Those that come during one are in its result. */
  | { readonly kind: 'stray'; readonly stray: Stray }
  | { readonly kind: 'result'; readonly result: TransactionResult };

/** A transaction that was asked for. */
export interface Transaction {
  /** Never rejects. */
  readonly result: Promise<TransactionResult>;
  /** Ends it, if it has not ended. A request that was sent already stays sent. */
  cancel(): void;
}

/**
 * Sends requests over a link and takes their replies: one after another, however many are asked for at the same time. The
 * rules can change between transactions; a transaction keeps those it was asked for with.
 */
export class BusClient {
  rules: TransactionRules;
  readonly #link: Link;
  readonly #clock: Clock;
  readonly #listeners = new Listeners<BusEvent>();
  readonly #stopListening: () => void;
  #line = new LineMemory();
  #queue: Exchange[] = [];
  #active: Exchange | undefined;
  #offIdle = () => {};

  constructor(link: Link, clock: Clock, rules: Partial<TransactionRules> = {}) {
    this.#link = link;
    this.#clock = clock;
    this.rules = { ...defaultRules, ...rules };
    this.#stopListening = link.listen((event) => this.#hear(event));
  }

  /** Transactions that have not ended. */
  get pending(): number {
    return this.#queue.length + (this.#active === undefined ? 0 : 1);
  }

  /** Answers how to stop listening. */
  listen(listener: (event: BusEvent) => void): () => void {
    return this.#listeners.add(listener);
  }

  /**
   * Sends these bytes, legal or not, once all that were asked for before have ended, and waits for their reply.
   *
   * @param probes whether silence is an answer too, as in a scan
   */
  transact(request: Uint8Array, rules: Partial<TransactionRules> = {}, probes = false): Transaction {
    let settle: (result: TransactionResult) => void = () => undefined;
    const result = new Promise<TransactionResult>((resolve) => {
      settle = resolve;
    });
    const exchange = this.#exchange(request.slice(), { ...this.rules, ...rules }, (result) => {
      const told = probes ? { ...result, probes } : result;
      this.#listeners.tell({ kind: 'result', result: told });
      settle(told);
    });
    this.#queue.push(exchange);
    this.#next();
    return { result, cancel: () => exchange.stop('cancelled') };
  }

  /**
   * Ends this client, and answers another for the same link, which knows what this one knew of the line: what was asked last
   * may still be answered.
   */
  successor(rules: Partial<TransactionRules>): BusClient {
    this.dispose();
    const client = new BusClient(this.#link, this.#clock, rules);
    client.#line = this.#line;
    if (this.#line.arrivals.length > 0) client.#drainBehindSilence();
    return client;
  }

  isOf(link: Link): boolean {
    return this.#link === link;
  }

  /** Cancels all transactions, and lets go of the link without closing it. */
  dispose(): void {
    this.#stopAll('cancelled');
    this.#offIdle();
    this.#stopListening();
  }

  #exchange(request: Uint8Array, rules: TransactionRules, settle: (result: TransactionResult) => void): Exchange {
    const { state } = this.#link;
    const exchange: Exchange = new Exchange({
      link: this.#link,
      clock: this.#clock,
      line: this.#line,
      request,
      rules,
      times: lineTimes(state.kind === 'open' ? state.settings : defaultSettings, rules),
      queuedAt: this.#clock.now(),
      sent: (bytes, at) => this.#listeners.tell({ kind: 'sent', bytes, at }),
      ended: (result) => {
        this.#queue = this.#queue.filter((other) => other !== exchange);
        if (this.#active === exchange) this.#active = undefined;
        settle(result);
        this.#next();
      },
    });
    return exchange;
  }

  #next(): void {
    if (this.#active !== undefined) return;
    this.#active = this.#queue.shift();
    if (this.#active === undefined) return;
    this.#offIdle();
    this.#active.start();
  }

  #hear(event: LinkEvent): void {
    switch (event.kind) {
      case 'received':
        this.#receive(event.bytes, event.at);
        break;
      case 'line-error':
        this.#active?.lineError(event.error);
        this.#listeners.tell(event);
        break;
      case 'state':
        if (event.state.kind === 'opening') this.#line = new LineMemory();
        else if (event.state.kind === 'lost') this.#stopAll('lost');
        else if (event.state.kind !== 'open') this.#stopAll('cancelled');
        break;
    }
  }

  #receive(bytes: Uint8Array, at: number): void {
    this.#listeners.tell({ kind: 'received', bytes, at });
    for (const piece of piecesOf(bytes)) this.#take(piece, at);
  }

  #take(piece: Uint8Array, at: number): void {
    const line = this.#line;
    const gone = line.add(piece, at, this.rules.transport);
    if (this.#active !== undefined) {
      this.#active.receive(gone);
      return;
    }
    this.#tellStrays(gone);
    this.#drainBehindSilence();
  }

  #drainBehindSilence(): void {
    this.#offIdle();
    const { state } = this.#link;
    if (state.kind !== 'open') return;
    this.#offIdle = this.#clock.after(lineTimes(state.settings, this.rules).silence, () => {
      this.#tellStrays(this.#line.drain(this.rules.transport));
    });
  }

  #tellStrays(strays: readonly Stray[]): void {
    for (const stray of strays) this.#listeners.tell({ kind: 'stray', stray });
  }

  #stopAll(kind: 'lost' | 'cancelled'): void {
    const all = [...(this.#active === undefined ? [] : [this.#active]), ...this.#queue];
    this.#queue = [];
    for (const exchange of all) exchange.stop(kind);
  }
}
