/** The two masks of function 16 (AP 6.16). */
export interface Masks {
  readonly andMask: number;
  readonly orMask: number;
}

/** What a mask write does to a bit. */
export type BitEffect = 'keep' | 'set' | 'clear';

/** The masks that set the bits of `set` and clear those of `clear`, both 16 bits; a bit in both is set. */
export const masksFor = (set: number, clear: number): Masks => ({ andMask: ~(set | clear) & 0xffff, orMask: set });

/** What a register holds after a mask write: (current AND and) OR (or AND NOT and) (AP 6.16). */
export const maskedValue = (current: number, { andMask, orMask }: Masks): number =>
  (current & andMask) | (orMask & ~andMask & 0xffff);

/** What the masks do to each bit, bit 0 first. */
export const bitEffects = ({ andMask, orMask }: Masks): readonly BitEffect[] =>
  Array.from({ length: 16 }, (_, bit) => (andMask & (1 << bit) ? 'keep' : orMask & (1 << bit) ? 'set' : 'clear'));
