import { demandWhole } from '../demand.ts';

/** The two masks of function 16 (AP 6.16). */
export interface Masks {
  readonly andMask: number;
  readonly orMask: number;
}

/** What a mask write does to a bit. */
export type BitEffect = 'keep' | 'set' | 'clear';

/** The masks that set the bits of `set` and clear those of `clear`, both 16 bits; a bit in both is set. */
export function masksFor(set: number, clear: number): Masks {
  demandBits(set, clear);
  return { andMask: ~(set | clear) & 0xffff, orMask: set };
}

/** What a register holds after a mask write: (current AND and) OR (or AND NOT and) (AP 6.16). */
export function maskedValue(current: number, { andMask, orMask }: Masks): number {
  demandBits(current, andMask, orMask);
  return (current & andMask) | (orMask & ~andMask & 0xffff);
}

/** What the masks do to each bit, bit 0 first. */
export function bitEffects({ andMask, orMask }: Masks): readonly BitEffect[] {
  demandBits(andMask, orMask);
  return Array.from({ length: 16 }, (_, bit) =>
    andMask & (1 << bit) ? 'keep' : orMask & (1 << bit) ? 'set' : 'clear',
  );
}

/** All of these throw a `RangeError` for what is not 16 bits. */
function demandBits(...all: readonly number[]): void {
  for (const bits of all) demandWhole('16 bits', bits, 0, 0xffff);
}
