import { type Checksum, checksum } from '../modbus/index.ts';

/** A checksum that has the claimed bytes. */
export interface Match {
  readonly of: Checksum;
  readonly got: number;
  /** The claimed bytes begin with the lowest one. */
  readonly lowFirst: boolean;
}

/** The number that bytes make in each order. */
export const inBothOrders = (claimed: Uint8Array) => ({
  highFirst: claimed.reduce((value, byte) => value * 256 + byte, 0),
  lowFirst: claimed.reduceRight((value, byte) => value * 256 + byte, 0),
});

/** Which of these checksums of `bytes[from, to)` the claimed bytes are, in either order. */
export function matching(
  of: readonly Checksum[],
  bytes: Uint8Array,
  from: number,
  to: number,
  claimed: Uint8Array,
): Match[] {
  const { highFirst, lowFirst } = inBothOrders(claimed);
  return of.flatMap((one) => {
    const got = checksum(one, bytes, from, to);
    return got === highFirst || got === lowFirst ? [{ of: one, got, lowFirst: got === lowFirst }] : [];
  });
}

/** How many bytes may be left out in front and behind. */
const MOST_LEFT_OUT = 4;

/** The bytes a checksum may have been calculated over by mistake: all before `end`, or some fewer. */
export function partsOf(end: number, most = MOST_LEFT_OUT): { readonly from: number; readonly to: number }[] {
  const parts = [];
  for (let from = 0; from <= most; from++) {
    for (let left = 0; left <= most; left++) if (from < end - left) parts.push({ from, to: end - left });
  }
  return parts;
}
