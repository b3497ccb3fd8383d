import { type Awaited, fits } from './find-frame.ts';
import type { LineMemory } from './line-memory.ts';
import type { Stray, TransactionResult } from './result.ts';
import type { EchoRule } from './rules.ts';

/** What the beginning of what has come is. `doubt`: the request again, which may be its echo or the reply. */
export type EchoState = { readonly kind: 'settled'; readonly echo?: Stray } | { readonly kind: 'wait' | 'doubt' };

const SETTLED: EchoState = { kind: 'settled' };

/**
 * Takes the echo out of what comes after a request. If the reply is the same as the request, only a second copy
 * tells the two apart; what a line does is remembered.
 */
export class EchoFilter {
  found: TransactionResult['echo'] = 'none';
  readonly #awaited: Awaited;
  readonly #rule: EchoRule;
  readonly #line: LineMemory;
  #settled: boolean;

  constructor(awaited: Awaited, rule: EchoRule, line: LineMemory) {
    this.#awaited = awaited;
    this.#rule = rule;
    this.#line = line;
    this.#settled = rule === 'off';
  }

  /** `ended` says that a silence has followed what has come. */
  look(ended: boolean): EchoState {
    if (this.#settled) return SETTLED;
    const { request } = this.#awaited;
    const { bytes } = this.#line.arrivals;
    const known = this.#rule === 'on' ? true : this.#line.echoes;
    const here = Math.min(bytes.length, request.length);
    let wrong = 0;
    for (let i = 0; i < here; i++) if (bytes[i] !== request[i]) wrong++;
    if (wrong === 0 && here < request.length && known !== false && !ended) return { kind: 'wait' };
    if (wrong > 0 || here < request.length) {
      // What collides on the line comes back damaged.
      const damaged = known === true && here === request.length && 4 * wrong <= request.length;
      return damaged ? this.#remove() : this.settle('none');
    }
    const twice = bytes[request.length] === request[0];
    if (known !== true && fits(request, this.#awaited) && !(known === undefined && twice)) {
      return known === false ? this.settle('none') : { kind: 'doubt' };
    }
    if (this.#rule === 'auto') this.#line.echoes = true;
    return this.#remove();
  }

  /** Nothing more is asked about the echo, if it still is. */
  settle(found: TransactionResult['echo']): EchoState {
    if (!this.#settled) this.found = found;
    this.#settled = true;
    return SETTLED;
  }

  /** A reply was taken; `same` says that it is the request again. */
  replied(same: boolean): void {
    if (this.found === 'undecided') this.#line.perhapsEcho = this.#awaited.request;
    else if (this.#rule === 'auto' && this.found === 'none' && !same) this.#line.echoes = false;
  }

  #remove(): EchoState {
    const { arrivals } = this.#line;
    this.settle('removed');
    return { kind: 'settled', echo: { what: 'echo', ...arrivals.take(this.#awaited.request.length) } };
  }
}
