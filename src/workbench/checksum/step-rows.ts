import { demandWhole } from '../../modbus/index.ts';
import { readNumber } from '../../notation/index.ts';

/** A row of the steps: a byte, or one of its eight shifts. */
export interface StepPlace {
  /** The byte, from 0. */
  readonly at: number;
  /** The shift, 1 to 8; 0 is the row of the byte itself. */
  readonly shift: number;
}

export const SHIFTS = 8;

/** Rows for more bytes would not fit into memory. */
const MOST_BYTES = 2 ** 24;

/** The rows of bytes, of which some are folded. */
export class StepRows {
  readonly bytes: number;
  private readonly unfolded: readonly boolean[];
  /** The row of each byte, and behind the last the number of rows. */
  private readonly starts: Uint32Array;

  constructor(bytes: number, isOpen: (at: number) => boolean) {
    demandWhole('bytes', bytes, 0, MOST_BYTES);
    this.bytes = bytes;
    this.unfolded = Array.from({ length: bytes }, (_, at) => isOpen(at));
    this.starts = new Uint32Array(bytes + 1);
    for (let at = 0; at < bytes; at++) {
      this.starts[at + 1] = (this.starts[at] as number) + (this.open(at) ? 1 + SHIFTS : 1);
    }
  }

  get length(): number {
    return this.starts[this.bytes] as number;
  }

  open(at: number): boolean {
    return this.unfolded[at] === true;
  }

  /** What a row shows. */
  place(row: number): StepPlace {
    let [from, to] = [0, this.bytes - 1];
    while (from < to) {
      const middle = (from + to + 1) >>> 1;
      if ((this.starts[middle] as number) <= row) from = middle;
      else to = middle - 1;
    }
    return { at: from, shift: row - (this.starts[from] as number) };
  }

  /** The row of a place; of a shift that is folded away, the row of its byte. */
  row({ at, shift }: StepPlace): number {
    return (this.starts[at] as number) + (this.open(at) ? shift : 0);
  }
}

const PARTS = /^([^.]+)(?:\.([^.]+))?$/;

/** The place that a text says, a byte or `byte.shift`; `undefined` if the bytes have no such place. */
export function readStepPlace(text: string, bytes: number): StepPlace | undefined {
  const parts = PARTS.exec(text.trim());
  const at = readNumber(parts?.[1] ?? '');
  const shift = parts?.[2] === undefined ? 0 : readNumber(parts[2]);
  const within = (value: number | undefined, most: number): value is number =>
    Number.isInteger(value) && (value as number) >= 0 && (value as number) <= most;
  return within(at, bytes - 1) && within(shift, SHIFTS) ? { at, shift } : undefined;
}
