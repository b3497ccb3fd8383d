type Typed = Uint8Array | Uint16Array | Uint32Array | Float64Array;

/** Values of a piece, a power of two, and the room that the first piece begins with. */
const BITS = 14;
const PIECE = 1 << BITS;
const INTO = PIECE - 1;
const FIRST_ROOM = 64;
const ANY = Number.POSITIVE_INFINITY;

/** What types hold, whole numbers from 0 or any, the smallest first. */
const types: readonly (readonly [most: number, type: new (length: number) => Typed])[] = [
  [0xff, Uint8Array],
  [0xffff, Uint16Array],
  [0xffffffff, Uint32Array],
  [ANY, Float64Array],
];

/**
 * A column of numbers that grows: pieces of equal length, each of the smallest type that holds its values. Nothing but the first piece is
 * copied when there are more values, and no room is kept for many that do not come.
 */
export class Column {
  #length = 0;
  readonly #pieces: Typed[] = [];
  /** The least of its values, which are whole; `undefined` for any numbers. */
  readonly #least: number | undefined;
  readonly #base: number;
  #last: Typed = new Uint8Array(0);
  /** The most that the last piece holds. */
  #most = -1;

  constructor(least: number | undefined) {
    this.#least = least;
    this.#base = least ?? 0;
  }

  get length(): number {
    return this.#length;
  }

  push(value: number): void {
    const stored = value - this.#base;
    const into = this.#length & INTO;
    if (into === 0) this.#begin(stored);
    else if (into === this.#last.length) this.#copy(this.#pieces.length - 1, this.#most, 2 * into);
    if (stored > this.#most) this.#copy(this.#pieces.length - 1, this.#mostFor(stored), this.#last.length);
    this.#last[into] = stored;
    this.#length++;
  }

  /** The value at an index below `length`. */
  at(index: number): number {
    return ((this.#pieces[index >> BITS] as Typed)[index & INTO] as number) + this.#base;
  }

  set(index: number, value: number): void {
    const stored = value - this.#base;
    const piece = index >> BITS;
    const values = this.#pieces[piece] as Typed;
    if (stored > mostIn(values)) this.#copy(piece, this.#mostFor(stored), values.length);
    (this.#pieces[piece] as Typed)[index & INTO] = stored;
  }

  /** Leaves out the values from an index on. */
  cut(length: number): void {
    this.#length = length;
    this.#pieces.length = Math.ceil(length / PIECE);
    this.#last = this.#pieces.at(-1) ?? new Uint8Array(0);
    this.#most = mostIn(this.#last);
  }

  #mostFor(stored: number): number {
    return this.#least === undefined ? ANY : (types.find(([most]) => stored <= most)?.[0] ?? ANY);
  }

  #begin(stored: number): void {
    this.#most = this.#mostFor(stored);
    this.#last = roomFor(this.#most, this.#length === 0 ? FIRST_ROOM : PIECE);
    this.#pieces.push(this.#last);
  }

  #copy(piece: number, most: number, room: number): void {
    const values = roomFor(most, room);
    values.set(this.#pieces[piece] as Typed);
    this.#pieces[piece] = values;
    if (piece < this.#pieces.length - 1) return;
    this.#last = values;
    this.#most = most;
  }
}

function roomFor(most: number, room: number): Typed {
  const [, type] = types.find(([one]) => one === most) ?? [most, Float64Array];
  return new type(room);
}

const mostIn = (values: Typed): number => types.find(([, type]) => values instanceof type)?.[0] ?? ANY;

export const countsColumn = (): Column => new Column(0);
/** Indexes, with −1 for none. */
export const indexColumn = (): Column => new Column(-1);
export const timesColumn = (): Column => new Column(undefined);
