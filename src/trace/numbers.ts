type Typed = Uint8Array | Uint32Array | Int32Array | Float64Array;

/** A column of numbers that grows: a typed array that doubles. */
export class Column<T extends Typed> {
  length = 0;
  #values: T;

  /** `first` is an empty array of the type, with room for the first values. */
  constructor(first: T) {
    this.#values = first;
  }

  push(value: number): void {
    if (this.length === this.#values.length) {
      const wider = new (this.#values.constructor as new (length: number) => T)(2 * this.length);
      wider.set(this.#values);
      this.#values = wider;
    }
    this.#values[this.length++] = value;
  }

  /** The value at an index below `length`. */
  at(index: number): number {
    return this.#values[index] as number;
  }

  set(index: number, value: number): void {
    this.#values[index] = value;
  }
}

const ROOM = 64;
export const bytesColumn = (): Column<Uint8Array> => new Column(new Uint8Array(ROOM));
export const countsColumn = (): Column<Uint32Array> => new Column(new Uint32Array(ROOM));
/** Indexes, with −1 for none. */
export const indexColumn = (): Column<Int32Array> => new Column(new Int32Array(ROOM));
export const timesColumn = (): Column<Float64Array> => new Column(new Float64Array(ROOM));
