import type { Candidate } from './candidate.ts';
import { likelihood, succession } from './likelihood.ts';

/** What adjoins a place: a candidate or the edge of the stream that ends or begins there. */
const ENDS = 1;
const BEGINS = 2;

/**
 * Chooses the frames that do not overlap and are together the most likely. Candidates are sorted by where they begin. A
 * chain of frames end to end outweighs anything that lies across it.
 */
export function chooseFrames(bytes: Uint8Array, candidates: readonly Candidate[]): Candidate[] {
  const places = new Uint8Array(bytes.length + 1);
  places[0] = ENDS;
  places[bytes.length] = (places[bytes.length] as number) | BEGINS;
  for (let i = 0; i < candidates.length; i++) {
    const { from, to } = candidates[i] as Candidate;
    places[from] = (places[from] as number) | BEGINS;
    places[to] = (places[to] as number) | ENDS;
  }
  const adjoins = ({ from, to }: Candidate) =>
    ((places[from] as number) & ENDS) !== 0 || ((places[to] as number) & BEGINS) !== 0;

  const chosen: Candidate[] = [];
  let at = 0;
  while (at < candidates.length) {
    const first = candidates[at] as Candidate;
    let { to } = first;
    let end = at + 1;
    for (let next = candidates[end]; next !== undefined && next.from < to; next = candidates[end]) {
      to = Math.max(to, next.to);
      end++;
    }
    if (end > at + 1) {
      const last = chosen[chosen.length - 1];
      // One by one, because a call takes only so many arguments.
      for (const frame of chooseAmong(bytes, candidates.slice(at, end), adjoins, last)) chosen.push(frame);
    } else if (adjoins(first) || likelihood(bytes, first, false) > 0) chosen.push(first);
    at = end;
  }
  return chosen;
}

/** A candidate with the most likely frames before it. */
interface Step {
  readonly frame: Candidate;
  readonly total: number;
  readonly before: Step | undefined;
}

/** The most likely frames of a group of candidates that overlap, after the frame `last`. */
function chooseAmong(
  bytes: Uint8Array,
  candidates: readonly Candidate[],
  adjoins: (candidate: Candidate) => boolean,
  last: Candidate | undefined,
): Candidate[] {
  // The best that ended before this place; those that end at it; and those that go on past it.
  let best: Step | undefined;
  let touching: Step[] = last === undefined ? [] : [{ frame: last, total: 0, before: undefined }];
  let pending: Step[] = [];
  let place = -1;
  for (const frame of candidates) {
    if (frame.from !== place) {
      place = frame.from;
      const ended = [...touching, ...pending];
      pending = ended.filter((step) => step.frame.to > place);
      touching = ended.filter((step) => step.frame.to === place);
      for (const step of ended) if (step.frame.to < place) best = better(best, step);
    }
    const own = likelihood(bytes, frame, adjoins(frame));
    let step: Step = { frame, total: own + (best?.total ?? 0), before: best };
    for (const before of touching) {
      const total = own + before.total + succession(bytes, before.frame, frame);
      if (total > step.total) step = { frame, total, before };
    }
    pending.push(step);
  }
  for (const step of [...touching, ...pending]) best = better(best, step);
  const chosen: Candidate[] = [];
  for (let step = best; step !== undefined && step.frame !== last; step = step.before) chosen.push(step.frame);
  return chosen.reverse();
}

const better = (best: Step | undefined, step: Step): Step | undefined =>
  step.total > (best?.total ?? 0) ? step : best;
