import { decodeFrame, type ProblemCode, type Reading } from '../../modbus/index.ts';
import type { Place } from './log-pieces.ts';

/** A request, and its place in the list of items. */
export interface OpenRequest extends Place {
  readonly index: number;
  /** Something is wrong with it by itself, so that its reply may differ from it. */
  readonly broken: boolean;
}

/** A reply with two of these problems answers another request. */
const STRANGE: ReadonlySet<ProblemCode> = new Set<ProblemCode>([
  'unit-not-as-requested',
  'transaction-not-as-requested',
  'function-not-as-requested',
]);

/**
 * The requests of a conversation that have no reply yet: on a serial line the last one, on TCP one for each transaction
 * identifier (TG 4.4.1.4).
 */
export class OpenRequests {
  readonly #bytes: Uint8Array;
  readonly #open = new Map<string, OpenRequest>();
  #last: OpenRequest | undefined = undefined;

  constructor(bytes: Uint8Array) {
    this.#bytes = bytes;
  }

  add(request: OpenRequest): void {
    this.#last = request;
    this.#open.set(this.#key(request), request);
  }

  /** The request that waits for this frame, if it is a reply. */
  bytesFor(frame: Place): Uint8Array | undefined {
    const request = this.#waitingFor(frame);
    return request && this.#bytes.subarray(request.from, request.to);
  }

  /** The frame read as a reply to the request that waits for it; `undefined` if it is not one. */
  replyOf(frame: Place): { reading: Reading; answers: OpenRequest } | undefined {
    const request = this.bytesFor(frame);
    if (request === undefined) return undefined;
    const { transport, from, to } = frame;
    const reading = decodeFrame(this.#bytes.subarray(from, to), { transport, direction: 'response', request });
    const answers = this.answeredBy(reading, frame);
    return answers && { reading, answers };
  }

  /** The request that waits for this frame, if the frame can be the reply to it. */
  answeredBy({ problems }: Reading, frame: Place): OpenRequest | undefined {
    let strange = 0;
    for (const { code } of problems) if (STRANGE.has(code)) strange++;
    return strange > 1 ? undefined : this.#waitingFor(frame);
  }

  /** Marks a request as answered. */
  close(request: OpenRequest): void {
    this.#open.delete(this.#key(request));
    if (this.#last === request) this.#last = undefined;
  }

  /** With another transaction identifier a reply may answer the last request. */
  #waitingFor(frame: Place): OpenRequest | undefined {
    const last = this.#last?.transport === frame.transport ? this.#last : undefined;
    return this.#open.get(this.#key(frame)) ?? last;
  }

  /** What request and reply have in common: on TCP the transaction identifier. */
  #key({ transport, from }: Place): string {
    return transport === 'tcp' ? `tcp ${this.#bytes[from]} ${this.#bytes[from + 1]}` : transport;
  }
}
