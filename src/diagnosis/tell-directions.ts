import type { Direction } from '../modbus/index.ts';
import { type Candidate, judged } from './candidate.ts';
import { link } from './likelihood.ts';

/** For each frame, its direction; `undefined` where both are equally likely. */
export function tellDirections(bytes: Uint8Array, frames: readonly Candidate[]): (Direction | undefined)[] {
  const readings = frames.map((frame) => (frame.directions.length > 1 ? legalOnes(bytes, frame) : frame.directions));
  const directions = readings.map((each): Direction | undefined => each[0]);
  for (let at = 0; at < frames.length; at++) {
    let end = at;
    while ((readings[end]?.length ?? 1) > 1) end++;
    if (end > at) tellRun(bytes, frames, readings, at, end, directions);
    at = end;
  }
  return directions;
}

/** The directions in which the frame breaks no rule, if there are any: legal comes before illegal. */
function legalOnes(bytes: Uint8Array, frame: Candidate): readonly Direction[] {
  const legal = judged(bytes, frame).filter((reading) => reading.legal);
  return legal.length === 1 ? legal.map(({ direction }) => direction) : frame.directions;
}

/** Tells the directions of frames `[first, end)`, which can be either; those beside them cannot. */
function tellRun(
  bytes: Uint8Array,
  frames: readonly Candidate[],
  readings: readonly (readonly Direction[])[],
  first: number,
  end: number,
  directions: (Direction | undefined)[],
): void {
  // Of each frame, what speaks for its readings itself, and the most that the frames before it, or after it, say for them.
  const own: number[][] = [];
  const before: number[][] = [];
  const after: number[][] = [];
  const linkOf = (i: number, a: Direction, b: Direction) => {
    const [frame, next] = [frames[i], frames[i + 1]];
    return frame === undefined || frame.to !== next?.from ? 0 : link(bytes, frame, a, next, b);
  };
  const most = (i: number, bits: (reading: Direction, r: number) => number) =>
    Math.max(0, ...(readings[i] ?? []).map(bits));
  for (let i = first; i < end; i++) {
    const each = readings[i] ?? [];
    own.push(each.map((direction) => (besidePartner(bytes, frames, i, direction) ? DAMAGED_PARTNER : 0)));
    const sums = own.at(-2)?.map((bits, r) => bits + (before.at(-1)?.[r] ?? 0));
    before.push(each.map((direction) => most(i - 1, (other, r) => (sums?.[r] ?? 0) + linkOf(i - 1, other, direction))));
  }
  for (let i = end - 1; i >= first; i--) {
    const sums = own[i + 1 - first]?.map((bits, r) => bits + (after[0]?.[r] ?? 0));
    const each = readings[i] ?? [];
    after.unshift(each.map((direction) => most(i + 1, (other, r) => (sums?.[r] ?? 0) + linkOf(i, direction, other))));
  }
  for (let i = first; i < end; i++) {
    const [asked = 0, answered = 0] = (own[i - first] ?? []).map(
      (bits, r) => bits + (before[i - first]?.[r] ?? 0) + (after[i - first]?.[r] ?? 0),
    );
    directions[i] = asked > answered ? 'request' : answered > asked ? 'response' : undefined;
  }
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
