import type { Case, WrongCrc } from '../../case.ts';
import { CRC_BITS, tries } from '../../evidence.ts';
import { withCrc } from '../../frames.ts';

/** How rare it is, in bits, that only the checksum of a frame is wrong, for a reason that can be found. */
const COST = 6;

/** What every finding about a CRC has: the two bytes, their value, the right value, and the repaired frame. */
export const aboutCrc = ({ bytes }: Case, { end, got, expected }: WrongCrc) => ({
  from: end,
  to: end + 2,
  got,
  expected,
  repaired: [withCrc(bytes.subarray(0, end))],
});

/** The evidence if one of `tried` explanations gives exactly these two bytes. */
export const explainedBits = ({ bits }: WrongCrc, tried: number, cost = COST): number =>
  bits + CRC_BITS - tries(tried) - cost;
