import { type Reading, type SerialMode, sameBytes } from '../../modbus/index.ts';
import { fits } from './find-frame.ts';

/** A request whose reply may still come. Times are the clock's milliseconds. */
export interface Owed {
  readonly transport: SerialMode;
  readonly request: Uint8Array;
  readonly asked: Reading;
  readonly sentAt: number;
  /** Until then nothing is sent to which its reply could be taken for the answer. */
  readonly quietUntil: number;
  /** The reply is not expected any more after this. */
  readonly until: number;
  /**
   * The reply is hardly expected: an exception or a damaged frame has come in its place, or the reply to a later request.
   * Only a frame that comes at another time than the device answers is taken for it all the same.
   */
  readonly weak: boolean;
  /** It became clear that a later request was answered, so that this reply is lost, or comes out of order. */
  readonly passed?: boolean;
  /** A reply has come that answers this request or one of these, and it is not known which: one is still owed. */
  readonly perhaps?: readonly Owed[];
}

const MOST = 8;
const ALL = { weak: true, passed: true };

/** The requests whose replies may still come, in the order in which they were sent: a device answers in that order. */
export class OwedReplies {
  #all: readonly Owed[] = [];

  get isEmpty(): boolean {
    return this.#all.length === 0;
  }

  add(owed: Owed): void {
    this.#all = [...this.#all.filter(({ until }) => until > owed.sentAt).slice(1 - MOST), owed];
  }

  /**
   * The first request that a frame may answer, if there is one. `odd`: the frame came at another time than the device answers.
   * `except`: the request that is waited for now; its earlier sendings are the same request.
   */
  answeredBy(frame: Uint8Array, now: number, odd = ALL, except?: Uint8Array): Owed | undefined {
    if (this.#all.length === 0) return undefined;
    const may = (one: Owed) => one.request !== except && fits(frame, one);
    const fitting = this.#all.filter((one) => one.until > now && (may(one) || one.perhaps?.some(may) === true));
    return (
      fitting.find(({ weak }) => !weak) ??
      (odd.weak ? fitting.find(({ passed }) => !passed) : undefined) ??
      (odd.passed ? fitting.find(({ passed }) => passed) : undefined)
    );
  }

  /** The first earlier sending of this request, if there was one. */
  earlier(request: Uint8Array): Owed | undefined {
    return this.#all.find((one) => one.request === request);
  }

  /** The reply has come: those to what its unit was asked before are hardly expected any more. */
  settle(owed: Owed): void {
    const index = this.#all.indexOf(owed);
    this.#all = this.#all.flatMap((one, at) =>
      at === index ? [] : at < index && one.asked.unitId === owed.asked.unitId ? [weakened(one)] : [one],
    );
  }

  /** A request has been answered for sure: the replies to what its unit was asked before are hardly expected any more. */
  weaken(unit: number | undefined): void {
    if (this.#all.length === 0) return;
    this.#all = this.#all.map((one) => (one.asked.unitId === unit ? weakened(one) : one));
  }

  /** Until when the line is left quiet before this request, because another one's reply could be taken for its reply. */
  quietUntil({ unitId, functionCode }: Reading, request: Uint8Array): number {
    let until = Number.NEGATIVE_INFINITY;
    for (const { asked, quietUntil, request: other } of this.#all) {
      const alike = (asked.unitId === unitId && asked.functionCode === functionCode) || sameBytes(other, request);
      if (alike) until = Math.max(until, quietUntil);
    }
    return until;
  }
}

const weakened = (owed: Owed): Owed => ({ ...owed, weak: true, quietUntil: 0 });
