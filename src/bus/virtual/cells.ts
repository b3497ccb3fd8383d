import { LAST_ADDRESS } from '../../modbus/index.ts';

/** A range of addresses that a table has. */
export interface CellRange {
  readonly from: number;
  readonly count: number;
  /** Whether a request may write them; the device itself always may. */
  readonly writable: boolean;
}

const READABLE = 1;
const WRITABLE = 2;

/** The values of one table of a device, 0 until they are written: 16 bits each, or one. */
export class Cells {
  readonly ranges: readonly CellRange[];
  readonly #values: Uint16Array;
  readonly #access: Uint8Array;

  constructor(ranges: readonly CellRange[]) {
    this.ranges = ranges;
    const size = Math.min(LAST_ADDRESS + 1, Math.max(0, ...ranges.map(({ from, count }) => from + count)));
    this.#values = new Uint16Array(size);
    this.#access = new Uint8Array(size);
    for (const { from, count, writable } of ranges) {
      this.#access.fill(writable ? READABLE | WRITABLE : READABLE, from, from + count);
    }
  }

  /** Whether the device has all of these addresses; with `writing`, whether a request may write them. */
  has(from: number, count: number, writing = false): boolean {
    const end = from + count;
    if (from < 0 || end > this.#access.length) return false;
    const needed = writing ? WRITABLE : READABLE;
    return this.#access.subarray(from, end).every((access) => (access & needed) !== 0);
  }

  /** The values from an address on; 0 if the table does not have an address. */
  read(from: number, count: number): number[] {
    return Array.from({ length: count }, (_, i) => this.#values[from + i] ?? 0);
  }

  /** The values that are not 0, in runs. */
  runs(): { readonly from: number; readonly values: number[] }[] {
    const found: { from: number; values: number[] }[] = [];
    this.#values.forEach((value, at) => {
      const last = found.at(-1);
      if (value === 0) return;
      if (last !== undefined && last.from + last.values.length === at) last.values.push(value);
      else found.push({ from: at, values: [value] });
    });
    return found;
  }

  /** Writes values from an address on; addresses that the table does not have are skipped. */
  write(from: number, values: readonly number[]): void {
    for (let i = 0; i < values.length; i++) this.#values[from + i] = values[i] as number;
  }
}
