import { batch, computed, signal } from '@preact/signals-core';
import type { Doubt, Refusal, SentResult, SessionCommand, TransactionRules } from '../bus/index.ts';

/** A request and its mode. */
export interface Asked {
  readonly request: Uint8Array;
  readonly transport: TransactionRules['transport'];
}

/** Somebody is asked whether requests are to be sent. */
export interface Question {
  /** What is done if the answer is yes. */
  readonly command: Extract<SessionCommand, { readonly confirmed: boolean }>;
  readonly why: Doubt;
}

type SendCommand = Extract<SessionCommand, { readonly kind: 'send' }>;

/** The requests that somebody sends by hand, one at a time: the last of them, and what became of it. */
export class SentRequests {
  /** The number of the request that is being sent. */
  readonly #sent = signal<number | undefined>(undefined);
  readonly sending = computed(() => this.#sent.value !== undefined);
  readonly asked = signal<Asked | undefined>(undefined);
  readonly refused = signal<Refusal | undefined>(undefined);
  readonly last = signal<SentResult | undefined>(undefined);
  readonly #post: (command: SendCommand) => void;

  constructor(post: (command: SendCommand) => void) {
    this.#post = post;
  }

  send(id: number, asked: Asked): void {
    this.asked.value = asked;
    this.post({ kind: 'send', id, request: asked.request, confirmed: false });
  }

  /** The request that “Read only” holds back; `undefined` if there is none, or if another is being sent. */
  get held(): Asked | undefined {
    return this.refused.peek() === 'read-only' && !this.sending.peek() ? this.asked.peek() : undefined;
  }

  /** Sends a request that is held back. */
  sendOnce(id: number, { request }: Asked): void {
    this.post({ kind: 'send', id, request, confirmed: false, allowed: true });
  }

  post(command: SendCommand): void {
    batch(() => {
      this.#sent.value = command.id;
      this.refused.value = undefined;
      this.last.value = undefined;
    });
    this.#post(command);
  }

  /** A request is no longer being sent, with its outcome if it has one. */
  ended(id: number, { last, refused }: { readonly last?: SentResult; readonly refused?: Refusal } = {}): void {
    if (this.#sent.peek() === id) this.#sent.value = undefined;
    if (last) this.last.value = last;
    if (refused) this.refused.value = refused;
  }

  /** Nothing is told any more of the request that is being sent. */
  drop(): void {
    this.#sent.value = undefined;
  }
}
