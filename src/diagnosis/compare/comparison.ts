import type { Direction, FieldKind, Transport } from '../../modbus/index.ts';
import type { Cause } from './cause.ts';

/** Bytes `[from, to)` of one of the frames, and the field they belong to. */
export interface Place {
  readonly name: string;
  readonly kind: FieldKind;
  readonly from: number;
  readonly to: number;
  /** The byte or 16-bit number they make, if the field is one. */
  readonly value: number | undefined;
}

/**
 * Aligned bytes of one field that are all equal, all different, or all on one side only. The runs cover the compared bytes
 * of each frame once, in order.
 */
export interface Run {
  readonly kind: 'equal' | 'different' | 'only-mine' | 'only-theirs';
  /** The field of mine, or of theirs for bytes that only theirs has. */
  readonly name: string;
  readonly fieldKind: FieldKind;
  readonly mineFrom: number;
  readonly mineTo: number;
  readonly theirsFrom: number;
  readonly theirsTo: number;
}

/** A field that is not the same in both frames, or bytes that only one of them has. */
export interface Difference {
  readonly mine: Place | undefined;
  readonly theirs: Place | undefined;
  readonly cause: Cause;
}

/** Two frames side by side. */
export interface Comparison {
  /** How theirs was read. */
  readonly transport: Transport;
  readonly direction: Direction;
  /** Whether both have the same layout. If not, their fields are compared by name, and runs of bytes mean little. */
  readonly alike: boolean;
  readonly runs: readonly Run[];
  /** In the order of the bytes. */
  readonly differences: readonly Difference[];
  /** The causes about the frames as a whole, the most telling first; only `identical` if they are equal. */
  readonly causes: readonly Cause[];
}
