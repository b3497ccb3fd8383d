import { MOST_ASCII } from '../../modbus/index.ts';

/** An echo and a reply of the longest ASCII frames. A line from which more comes without a frame babbles: the oldest go. */
export const MOST_ARRIVALS = 2 * MOST_ASCII;

/** Bytes in the order in which they came, each with when it did. */
export class Arrivals {
  #bytes = new Uint8Array(MOST_ARRIVALS);
  #length = 0;
  /** Where each piece begins, and when it came. */
  #pieces: { from: number; at: number }[] = [];

  get bytes(): Uint8Array {
    return this.#bytes.subarray(0, this.#length);
  }

  get length(): number {
    return this.#length;
  }

  /** Adds bytes; answers the oldest where there is no room for all. */
  add(bytes: Uint8Array, at: number): Uint8Array | undefined {
    const fresh = bytes.length > MOST_ARRIVALS ? bytes.subarray(bytes.length - MOST_ARRIVALS) : bytes;
    const over = Math.max(0, this.#length + fresh.length - MOST_ARRIVALS);
    const dropped = over > 0 ? this.take(over) : undefined;
    this.#pieces.push({ from: this.#length, at });
    this.#bytes.set(fresh, this.#length);
    this.#length += fresh.length;
    return dropped;
  }

  /** When the byte at this place came. */
  at(place: number): number {
    return this.#pieces.findLast(({ from }) => from <= place)?.at ?? 0;
  }

  /** Takes the first bytes away. */
  take(number: number): Uint8Array {
    const taken = this.#bytes.slice(0, number);
    const first = this.at(number);
    this.#bytes.copyWithin(0, number, this.#length);
    this.#length -= taken.length;
    const behind = this.#pieces.filter(({ from }) => from > number);
    this.#pieces = behind.map(({ from, at }) => ({ from: from - number, at }));
    if (this.#length > 0) this.#pieces.unshift({ from: 0, at: first });
    return taken;
  }

  clear(): void {
    this.#length = 0;
    this.#pieces = [];
  }
}
