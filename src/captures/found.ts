import { decodeFrame } from '../modbus/index.ts';
import { type CaptureRecord, countsColumn, type Place, timesColumn } from '../trace/index.ts';
import type { Carriage } from './adus.ts';

/** Two ends that speak to each other, and which of them is the server: 0 or 1; −1 as long as nobody knows, 2 if they share a wire so that nobody can know. */
export interface Conversation {
  readonly ends: readonly [string | undefined, string | undefined];
  server: number;
}

/** Records of one end that are tried when the roles are told by their structure. */
const SAMPLE = 24;

const CARRIAGES: readonly Carriage[] = ['tcp', 'rtu', 'ascii'];

/** The records of a capture, in columns: each is made when it is asked for. */
export class Found {
  /** What holds the bytes of nearly all records, and what holds those of others. */
  #source: Uint8Array | undefined;
  readonly #elsewhere = new Map<number, Uint8Array>();
  readonly #from = countsColumn();
  readonly #length = countsColumn();
  readonly #time = timesColumn();
  readonly #packet = countsColumn();
  readonly #packets = new Map<number, readonly number[]>();
  /** The number of the conversation, the side that spoke, and the carriage. */
  readonly #spoken = countsColumn();
  readonly #conversations: Conversation[] = [];
  readonly #numberOf = new Map<Conversation, number>();
  #order: Uint32Array | undefined;
  #sorted = true;
  #last = Number.NEGATIVE_INFINITY;

  get length(): number {
    return this.#from.length;
  }

  add(
    conversation: Conversation,
    side: 0 | 1,
    carriage: Carriage,
    bytes: Uint8Array,
    from: number,
    to: number,
    time: number,
    packets: readonly number[],
  ): void {
    this.#source ??= bytes;
    if (bytes !== this.#source) this.#elsewhere.set(this.length, bytes);
    let number = this.#numberOf.get(conversation);
    if (number === undefined) {
      number = this.#conversations.push(conversation) - 1;
      this.#numberOf.set(conversation, number);
    }
    if (packets.length !== 1) this.#packets.set(this.length, packets);
    this.#from.push(from);
    this.#length.push(to - from);
    this.#time.push(time);
    this.#packet.push(packets.length === 1 ? (packets[0] as number) : 0);
    this.#spoken.push(number * 8 + side * 4 + CARRIAGES.indexOf(carriage));
    if (time < this.#last) this.#sorted = false;
    if (time > this.#last) this.#last = time;
  }

  /** Tells the roles where neither a handshake nor a port did, and puts the records in the order of time. */
  finish(): void {
    for (const conversation of this.#conversations)
      if (conversation.server < 0) conversation.server = this.#serverBy(conversation);
    if (this.#sorted) return;
    const times = new Float64Array(this.length);
    let before = 0;
    for (let index = 0; index < times.length; index++) {
      const time = this.#time.at(index);
      before = Number.isNaN(time) ? before : time;
      times[index] = before;
    }
    this.#order = Uint32Array.from(times.keys()).sort((a, b) => (times[a] as number) - (times[b] as number) || a - b);
  }

  #serverBy(conversation: Conversation): number {
    const number = this.#numberOf.get(conversation);
    const asks = [0, 0];
    const seen = [0, 0];
    let first = -1;
    for (
      let index = 0;
      index < this.length && Math.min(...seen) < SAMPLE && Math.max(...seen) < 100 * SAMPLE;
      index++
    ) {
      const spoken = this.#spoken.at(index);
      if (spoken >> 3 !== number) continue;
      const side = (spoken >> 2) & 1;
      if (first < 0) first = side;
      seen[side] = (seen[side] as number) + 1;
      const transport = CARRIAGES[spoken & 3] as Carriage;
      const bytes = this.#bytes(index);
      const [request, response] = (['request', 'response'] as const).map((direction) => {
        const { outcome, problems } = decodeFrame(bytes, { transport, direction });
        return outcome.kind === 'whole' && problems.every(({ severity }) => severity !== 'error');
      });
      if (request !== response) asks[side] = (asks[side] as number) + (request ? 1 : -1);
    }
    const [one = 0, other = 0] = asks;
    if (one !== other) return one > other ? 1 : 0;
    return first === 0 ? 1 : 0;
  }

  #bytes(index: number): Uint8Array {
    const from = this.#from.at(index);
    return ((this.#elsewhere.get(index) ?? this.#source) as Uint8Array).subarray(from, from + this.#length.at(index));
  }

  /** The record at a place in the order of time. */
  record(place: number): CaptureRecord {
    const index = this.#order?.[place] ?? place;
    const spoken = this.#spoken.at(index);
    const conversation = this.#conversations[spoken >> 3] as Conversation;
    const side = (spoken >> 2) & 1;
    const [from, to] = side === 0 ? conversation.ends : [conversation.ends[1], conversation.ends[0]];
    const time = this.#time.at(index);
    const numbers = this.#packets.get(index) ?? [this.#packet.at(index)];
    const at: Place = { kind: 'packet', numbers };
    const bytes = this.#bytes(index);
    const transport = CARRIAGES[spoken & 3] as Carriage;
    if (!Number.isNaN(time) && conversation.server <= 1 && from !== undefined && to !== undefined) {
      // Nearly all records are such, and a literal is made faster than what spreads add up.
      return {
        bytes,
        time,
        side: conversation.server === side ? 'response' : 'request',
        transport,
        from,
        to,
        place: at,
      };
    }
    return {
      bytes,
      ...(Number.isNaN(time) ? undefined : { time }),
      ...(conversation.server > 1 ? undefined : { side: conversation.server === side ? 'response' : 'request' }),
      transport,
      ...(from === undefined ? undefined : { from }),
      ...(to === undefined ? undefined : { to }),
      place: at,
    };
  }
}
