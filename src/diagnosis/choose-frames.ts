import type { FrameAt } from '../modbus/index.ts';
import { likelihood, succession } from './likelihood.ts';

/** A place that a frame was found to take, and the readings in which it may be one: in one direction or in both. */
export interface Chosen {
  readonly from: number;
  readonly to: number;
  readonly readings: readonly [FrameAt, ...FrameAt[]];
}

/** A candidate with the most likely frames before it. */
interface Step {
  readonly frame: FrameAt;
  readonly total: number;
  readonly before: Step | undefined;
}

/**
 * The frames, none overlapping another, that are together the most likely of all candidates, which come in the order of
 * their beginnings. A chain of frames end to end outweighs whatever lies across it.
 */
export function chooseFrames(bytes: Uint8Array, candidates: readonly FrameAt[]): Chosen[] {
  // The best that ended before the place looked at; those that ended just there; and those that go on past it.
  let best: Step | undefined;
  let touching: Step[] = [];
  let pending: Step[] = [];
  let place = -1;
  for (const frame of candidates) {
    if (frame.from !== place) {
      place = frame.from;
      for (const step of touching) best = better(best, step);
      touching = [];
      const still: Step[] = [];
      for (const step of pending) {
        const { to } = step.frame;
        if (to < place) best = better(best, step);
        else if (to === place) touching.push(step);
        else still.push(step);
      }
      pending = still;
    }
    const own = likelihood(bytes, frame);
    let step: Step = { frame, total: own + (best?.total ?? 0), before: best };
    for (const before of touching) {
      const total = own + before.total + succession(bytes, before.frame, frame);
      if (total > step.total) step = { frame, total, before };
    }
    pending.push(step);
  }
  for (const step of [...touching, ...pending]) best = better(best, step);
  return together(best, candidates);
}

const better = (best: Step | undefined, step: Step): Step | undefined =>
  step.total > (best?.total ?? 0) ? step : best;

/** The frames up to `last`, in order, each with all readings of its place. */
function together(last: Step | undefined, candidates: readonly FrameAt[]): Chosen[] {
  const frames: FrameAt[] = [];
  for (let step = last; step !== undefined; step = step.before) frames.push(step.frame);
  frames.reverse();
  let next = 0;
  return frames.map((frame) => {
    const { from, to } = frame;
    while ((candidates[next] as FrameAt).from < from) next++;
    const others: FrameAt[] = [];
    for (let i = next; candidates[i]?.from === from; i++) {
      const other = candidates[i] as FrameAt;
      if (other.to === to && other !== frame) others.push(other);
    }
    return { from, to, readings: [frame, ...others] };
  });
}
