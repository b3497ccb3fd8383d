import { type Direction, describeFunction } from '../modbus/index.ts';
import { type Candidate, judged } from './candidate.ts';
import { link } from './likelihood.ts';

/** The two directions, by their number in the tables below. */
const DIRECTIONS: readonly Direction[] = ['request', 'response'];

/**
 * For each frame, its direction; `undefined` where both are equally likely. Frames that can be either are told by those
 * that they follow or that follow them without a gap, and by what a gap beside them shows of their partner.
 */
export function tellDirections(bytes: Uint8Array, frames: readonly Candidate[]): (Direction | undefined)[] {
  const { length } = frames;
  const readings = frames.map((frame) => (frame.directions.length > 1 ? legalOnes(bytes, frame) : frame.directions));
  const isEither = (i: number) => (readings[i] as readonly Direction[]).length === 2;
  const linked = (i: number) => i >= 0 && i + 1 < length && frames[i]?.to === frames[i + 1]?.from;
  // Two numbers a frame: what speaks for each direction itself, and the most that all before it, or after it, say for it.
  const own = new Int32Array(2 * length);
  const before = new Int32Array(2 * length);
  const after = new Int32Array(2 * length);

  /** The most that frame `i` and all beyond it say for direction `d` of the frame beside it. */
  const most = (i: number, beyond: Int32Array, d: number, follows: boolean): number => {
    let best = Number.NEGATIVE_INFINITY;
    for (let other = 0; other < 2; other++) {
      if (!isEither(i) && readings[i]?.[0] !== DIRECTIONS[other]) continue;
      const first = follows ? i - 1 : i;
      const [one, two] = follows ? [d, other] : [other, d];
      const bits = link(
        bytes,
        frames[first] as Candidate,
        DIRECTIONS[one] as Direction,
        frames[first + 1] as Candidate,
        DIRECTIONS[two] as Direction,
      );
      best = Math.max(best, bits + (own[2 * i + other] as number) + (beyond[2 * i + other] as number));
    }
    return best;
  };

  for (let i = 0; i < length; i++) {
    if (!isEither(i)) continue;
    for (let d = 0; d < 2; d++) {
      if (besidePartner(bytes, frames, i, DIRECTIONS[d] as Direction)) own[2 * i + d] = DAMAGED_PARTNER;
      if (linked(i - 1)) before[2 * i + d] = most(i - 1, before, d, false);
    }
  }
  for (let i = length - 1; i >= 0; i--) {
    if (!isEither(i) || !linked(i)) continue;
    for (let d = 0; d < 2; d++) after[2 * i + d] = most(i + 1, after, d, true);
  }
  const sum = (place: number) => (own[place] as number) + (before[place] as number) + (after[place] as number);
  return readings.map((each, i) => {
    if (!isEither(i)) return each[0];
    const [asked, answered] = [sum(2 * i), sum(2 * i + 1)];
    return asked === answered ? undefined : DIRECTIONS[asked > answered ? 0 : 1];
  });
}

/** The directions in which the frame breaks no rule, if it is one alone: legal comes before illegal. */
function legalOnes(bytes: Uint8Array, frame: Candidate): readonly Direction[] {
  const functionCode = bytes[frame.from + 1] as number;
  const { request } = describeFunction(functionCode, 'request');
  const { response } = describeFunction(functionCode, 'response');
  // With the same fields in both directions there is nothing to be judged.
  if (frame.transport === 'rtu' && request === response) return frame.directions;
  const legal = judged(bytes, frame).filter((reading) => reading.legal);
  return legal.length === 1 ? legal.map(({ direction }) => direction) : frame.directions;
}

/** A damaged frame beside this one was its request or its reply. */
const DAMAGED_PARTNER = 3;
/** Bytes at the beginning or the end of a damaged frame that have to be those of its partner. */
const TELLING = 2;

/** Whether the gap behind a request begins as its reply does, or the gap before a reply ends as its request does. */
function besidePartner(bytes: Uint8Array, frames: readonly Candidate[], i: number, direction: Direction): boolean {
  const { from, to } = frames[i] as Candidate;
  const asked = direction === 'request';
  const gapFrom = asked ? to : (frames[i - 1]?.to ?? 0);
  const gapTo = asked ? (frames[i + 1]?.from ?? bytes.length) : from;
  const length = to - from;
  if (gapTo - gapFrom < TELLING) return false;
  // What is no longer than the frame is the damaged partner alone, so that either end tells.
  const alone = gapTo - gapFrom <= length;
  const begins = (place: number) =>
    bytes[place] === bytes[from] && ((bytes[place + 1] as number) & 0x7f) === bytes[from + 1];
  const ends = () => {
    for (let back = 1; back <= TELLING; back++) if (bytes[gapTo - back] !== bytes[to - back]) return false;
    return true;
  };
  if (asked) return begins(gapFrom) || (alone && ends());
  if (ends() || (alone && begins(gapFrom))) return true;
  // One or two of its bytes may be missing.
  for (let place = Math.max(gapFrom, gapTo - length); place <= gapTo - length + 2; place++) {
    if (begins(place)) return true;
  }
  return false;
}
