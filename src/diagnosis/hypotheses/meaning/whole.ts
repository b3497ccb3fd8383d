import type { Problem, ProblemCode } from '../../../modbus/index.ts';
import { type Case, isClean, type WholeFrame } from '../../case.ts';

/** The readings of a whole frame with something wrong; empty if one reading is clean. */
export function faulty({ wholes, request }: Case): WholeFrame | undefined {
  const awaited = request ? wholes.filter(({ reading }) => reading.direction === 'response') : wholes;
  if (awaited.length === 0 || awaited.some(isClean)) return undefined;
  return awaited.reduce((a, b) => (b.bits > a.bits ? b : a));
}

/** A problem of this kind in a reading. */
export const problemOf = <C extends ProblemCode>(
  { reading }: WholeFrame,
  wanted: C,
): Extract<Problem, { code: C }> | undefined =>
  reading.problems.find((problem): problem is Extract<Problem, { code: C }> => problem.code === wanted);

/**
 * The evidence for a fault in a whole frame, which was sent with it: that of the frame, without what its faults took from it.
 * Of several faults the one with the lowest `place` comes first.
 */
export const said = ({ bits }: WholeFrame, place: number): number => bits + 10 - place / 10;
