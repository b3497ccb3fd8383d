import type { Candidate } from './candidate.ts';
import { likelihood, succession } from './likelihood.ts';

/** A candidate with the most likely frames before it. */
interface Step {
  readonly frame: Candidate;
  readonly total: number;
  readonly before: Step | undefined;
  /** Another candidate overlaps it. */
  readonly contested: boolean;
}

/**
 * The frames, none overlapping another, that are together the most likely of all candidates, which come in the order of
 * their beginnings. A chain of frames end to end outweighs whatever lies across it.
 */
export function chooseFrames(bytes: Uint8Array, candidates: readonly Candidate[]): Candidate[] {
  const begins = new Uint8Array(bytes.length + 1);
  for (const { from } of candidates) begins[from] = 1;
  begins[bytes.length] = 1;
  // The best that ended before the place looked at; those that ended just there; and those that go on past it.
  let best: Step | undefined;
  let touching: Step[] = [];
  let pending: Step[] = [];
  let place = -1;
  let reached = 0;
  for (let i = 0; i < candidates.length; i++) {
    const frame = candidates[i] as Candidate;
    const { from, to } = frame;
    if (from !== place) {
      place = from;
      for (const step of touching) best = better(best, step);
      touching = [];
      const still: Step[] = [];
      for (const step of pending) {
        if (step.frame.to < place) best = better(best, step);
        else if (step.frame.to === place) touching.push(step);
        else still.push(step);
      }
      pending = still;
    }
    const contested = from < reached || (candidates[i + 1]?.from ?? to) < to;
    reached = Math.max(reached, to);
    const adjoins = touching.length > 0 || from === 0 || begins[to] === 1;
    const own = likelihood(bytes, frame, adjoins, contested);
    let step: Step = { frame, total: own + (best?.total ?? 0), before: best, contested };
    for (const before of touching) {
      const link = succession(bytes, before.frame, frame, contested || before.contested);
      const total = own + before.total + link;
      if (total > step.total) step = { frame, total, before, contested };
    }
    pending.push(step);
  }
  for (const step of [...touching, ...pending]) best = better(best, step);
  const chosen: Candidate[] = [];
  for (let step = best; step !== undefined; step = step.before) chosen.push(step.frame);
  return chosen.reverse();
}

const better = (best: Step | undefined, step: Step): Step | undefined =>
  step.total > (best?.total ?? 0) ? step : best;
