import type { Case, WrongCrc } from '../../case.ts';
import { CRC_BITS, tries } from '../../evidence.ts';
import { withCrc } from '../../frames.ts';

/** How rare it is, in bits, that a frame is right but for a checksum that went wrong in a way that can be told. */
const COST = 6;

/** What every finding about a CRC has: the two bytes, what they say and should say, and the frame with the right ones. */
export const aboutCrc = ({ bytes }: Case, { end, got, expected }: WrongCrc) => ({
  from: end,
  to: end + 2,
  got,
  expected,
  repaired: [withCrc(bytes.subarray(0, end))],
});

/** The evidence where one of `tried` explanations gives just the two bytes that are there. */
export const explainedBits = ({ bits }: WrongCrc, tried: number, cost = COST): number =>
  bits + CRC_BITS - tries(tried) - cost;
