import { MOST_ASCII, MOST_RTU } from '../../modbus/index.ts';

/** Room for an echo and a reply of the longest ASCII frames. */
export const MOST_ARRIVALS = 2 * MOST_ASCII;

/**
 * Bytes are taken in pieces of this length at most, however many the system hands over at once. Bytes that are not a frame
 * are given out in such pieces too.
 */
export const MOST_PIECE = MOST_RTU;

/** Bytes that came. Times are the clock's. */
export interface Arrival {
  readonly bytes: Uint8Array;
  /** When the first byte came, and the last. */
  readonly at: number;
  readonly endAt: number;
  /** How many bytes had come before. */
  readonly place: number;
}

/** Cuts bytes into pieces of at most `MOST_PIECE`. */
export function piecesOf(bytes: Uint8Array): Uint8Array[] {
  const pieces: Uint8Array[] = [];
  for (let from = 0; from < bytes.length; from += MOST_PIECE) pieces.push(bytes.subarray(from, from + MOST_PIECE));
  return pieces;
}

/** Bytes in the order in which they came, each with the time it came. Whoever adds makes room first. */
export class Arrivals {
  #bytes = new Uint8Array(MOST_ARRIVALS);
  #length = 0;
  #taken = 0;
  /** Where each piece begins, and when it came. */
  #pieces: { from: number; at: number }[] = [];

  get bytes(): Uint8Array {
    return this.#bytes.subarray(0, this.#length);
  }

  get length(): number {
    return this.#length;
  }

  /** How many bytes can be added. */
  get room(): number {
    return MOST_ARRIVALS - this.#length;
  }

  /** Adds bytes. Throws a `RangeError` if they are more than there is room for. */
  add(bytes: Uint8Array, at: number): void {
    this.#bytes.set(bytes, this.#length);
    this.#pieces.push({ from: this.#length, at });
    this.#length += bytes.length;
  }

  /** Takes the first bytes away. */
  take(number: number): Arrival {
    const taken = {
      bytes: this.#bytes.slice(0, number),
      at: this.#at(0),
      endAt: this.#at(number - 1),
      place: this.#taken,
    };
    const first = this.#at(number);
    this.#bytes.copyWithin(0, number, this.#length);
    this.#length -= number;
    this.#taken += number;
    const behind = this.#pieces.filter(({ from }) => from > number);
    this.#pieces = behind.map(({ from, at }) => ({ from: from - number, at }));
    if (this.#length > 0) this.#pieces.unshift({ from: 0, at: first });
    return taken;
  }

  /** Takes the first bytes away, which are not a frame. */
  takePieces(number: number): Arrival[] {
    const pieces: Arrival[] = [];
    for (let left = number; left > 0; left -= MOST_PIECE) pieces.push(this.take(Math.min(left, MOST_PIECE)));
    return pieces;
  }

  /** When the byte at this place came. */
  #at(place: number): number {
    return this.#pieces.findLast(({ from }) => from <= place)?.at ?? 0;
  }
}
