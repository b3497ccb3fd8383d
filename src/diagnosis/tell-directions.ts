import { areJudgedAlike, type Direction } from '../modbus/index.ts';
import { type Candidate, judgement } from './candidate.ts';
import { link } from './likelihood.ts';

/** The two directions, by their number in the tables below. */
const DIRECTIONS: readonly Direction[] = ['request', 'response'];

/**
 * The direction of each frame; `undefined` if both are equally likely. A frame that can be either gets its direction from
 * its neighbours without a gap, and from what a gap beside it shows of its partner.
 */
export function tellDirections(bytes: Uint8Array, frames: readonly Candidate[]): (Direction | undefined)[] {
  const { length } = frames;
  /** The number of the direction that a frame can only have, or `EITHER`. */
  const only = new Int8Array(length);
  for (let i = 0; i < length; i++) only[i] = onlyOne(bytes, frames[i] as Candidate);
  /** By frame, 1 if the next one begins where it ends. */
  const linked = new Uint8Array(length);
  for (let i = 0; i + 1 < length; i++)
    linked[i] = (frames[i] as Candidate).to === (frames[i + 1] as Candidate).from ? 1 : 0;
  // Two numbers for each frame, one for each direction: its own evidence, and the most that all frames before or after it add.
  const own = new Int32Array(2 * length);
  const before = new Int32Array(2 * length);
  const after = new Int32Array(2 * length);

  /** The most evidence that frame `i` and all beyond it give for direction `d` of the frame beside it. */
  const most = (i: number, beyond: Int32Array, d: number, follows: boolean): number => {
    let best = Number.NEGATIVE_INFINITY;
    const first = follows ? i - 1 : i;
    for (let other = 0; other < 2; other++) {
      if (only[i] !== EITHER && only[i] !== other) continue;
      const one = DIRECTIONS[follows ? d : other] as Direction;
      const two = DIRECTIONS[follows ? other : d] as Direction;
      const bits = link(bytes, frames[first] as Candidate, one, frames[first + 1] as Candidate, two);
      best = Math.max(best, bits + (own[2 * i + other] as number) + (beyond[2 * i + other] as number));
    }
    return best;
  };

  for (let i = 0; i < length; i++) {
    if (only[i] !== EITHER) continue;
    const follows = i > 0 && linked[i - 1] === 1;
    // Only a gap beside it shows anything of a partner: one behind a request, one before a reply.
    if (linked[i] === 0 && besidePartner(bytes, frames, i, 'request')) own[2 * i] = DAMAGED_PARTNER;
    if (!follows && besidePartner(bytes, frames, i, 'response')) own[2 * i + 1] = DAMAGED_PARTNER;
    if (!follows) continue;
    for (let d = 0; d < 2; d++) before[2 * i + d] = most(i - 1, before, d, false);
  }
  for (let i = length - 1; i >= 0; i--) {
    if (only[i] !== EITHER || linked[i] === 0) continue;
    for (let d = 0; d < 2; d++) after[2 * i + d] = most(i + 1, after, d, true);
  }
  const sum = (place: number) => (own[place] as number) + (before[place] as number) + (after[place] as number);
  const told: (Direction | undefined)[] = [];
  for (let i = 0; i < length; i++) {
    const [direction, asked, answered] = [only[i] as number, sum(2 * i), sum(2 * i + 1)];
    if (direction !== EITHER) told.push(DIRECTIONS[direction]);
    else told.push(asked === answered ? undefined : DIRECTIONS[asked > answered ? 0 : 1]);
  }
  return told;
}

const EITHER = -1;

/** The only direction of a frame, or the only one in which it breaks no rule if it is one alone; else `EITHER`. */
function onlyOne(bytes: Uint8Array, frame: Candidate): number {
  const [first] = frame.directions;
  if (frame.directions.length === 1) return first === 'request' ? 0 : 1;
  if (frame.transport === 'rtu' && areJudgedAlike(bytes[frame.from + 1] as number)) return EITHER;
  const [asks, answers] = DIRECTIONS.map((direction) => judgement(bytes, frame, direction) !== 'illegal');
  return asks === answers ? EITHER : asks ? 0 : 1;
}

/** The evidence that a damaged frame beside this one was its request or its reply. */
const DAMAGED_PARTNER = 3;
/** Bytes at the beginning or the end of a damaged frame that must match its partner. */
const TELLING = 2;

/** Whether the gap behind a request begins as its reply does, or the gap before a reply ends as its request does. */
function besidePartner(bytes: Uint8Array, frames: readonly Candidate[], i: number, direction: Direction): boolean {
  const { from, to } = frames[i] as Candidate;
  const asked = direction === 'request';
  const gapFrom = asked ? to : (frames[i - 1]?.to ?? 0);
  const gapTo = asked ? (frames[i + 1]?.from ?? bytes.length) : from;
  const length = to - from;
  if (gapTo - gapFrom < TELLING) return false;
  // A gap that is not longer than the frame holds the damaged partner alone, so either end tells.
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
