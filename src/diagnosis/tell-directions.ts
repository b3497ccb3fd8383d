import type { Direction, FrameAt } from '../modbus/index.ts';
import type { Chosen } from './choose-frames.ts';
import { likelihood, succession } from './likelihood.ts';

/** For each frame, its direction; `undefined` where both are equally likely. */
export function tellDirections(bytes: Uint8Array, frames: readonly Chosen[]): (Direction | undefined)[] {
  const links = frames.map((frame, i) => linksTo(bytes, frame, frames[i + 1]));
  const own = frames.map((frame, i) => frame.readings.map((reading) => ownBits(bytes, reading, frames, i)));
  // The most that can be said for a reading by the frames before it, and by those after it.
  const before = own.map((each) => each.map(() => 0));
  const after = own.map((each) => each.map(() => 0));
  for (let i = 1; i < frames.length; i++) {
    before[i] = numbers(before[i]).map((_, to) =>
      Math.max(...numbers(before[i - 1]).map((bits, from) => bits + at(own, i - 1, from) + at(links[i - 1], from, to))),
    );
  }
  for (let i = frames.length - 2; i >= 0; i--) {
    after[i] = numbers(after[i]).map((_, from) =>
      Math.max(...numbers(after[i + 1]).map((bits, to) => bits + at(own, i + 1, to) + at(links[i], from, to))),
    );
  }
  return frames.map(({ readings }, i) => {
    let best: Direction | undefined;
    let most = Number.NEGATIVE_INFINITY;
    readings.forEach(({ direction }, r) => {
      const bits = at(before, i, r) + at(own, i, r) + at(after, i, r);
      if (bits === most) best = undefined;
      if (bits <= most) return;
      best = direction;
      most = bits;
    });
    return best;
  });
}

type Table = readonly (readonly number[])[];
const at = (table: Table | undefined, i: number, j: number): number => table?.[i]?.[j] ?? 0;
const numbers = (list: readonly number[] | undefined): readonly number[] => list ?? [];

/** What each reading of a frame says for each reading of the next. */
function linksTo(bytes: Uint8Array, frame: Chosen, next: Chosen | undefined): Table | undefined {
  if (next === undefined || next.from !== frame.to) return undefined;
  if (frame.readings.length + next.readings.length === 2) return undefined;
  return frame.readings.map((reading) => next.readings.map((following) => succession(bytes, reading, following)));
}

/** A damaged frame beside this one that was its request or its reply. */
const DAMAGED_PARTNER = 3;
/** Bytes at the beginning or the end of a damaged frame that have to be those of its partner. */
const TELLING = 2;

function ownBits(bytes: Uint8Array, reading: FrameAt, frames: readonly Chosen[], i: number): number {
  const frame = frames[i] as Chosen;
  if (frame.readings.length === 1) return 0;
  const gapFrom = reading.direction === 'request' ? frame.to : (frames[i - 1]?.to ?? 0);
  const gapTo = reading.direction === 'request' ? (frames[i + 1]?.from ?? bytes.length) : frame.from;
  const partner = gapFrom < gapTo && holdsPartner(bytes, frame, reading.direction, gapFrom, gapTo);
  return likelihood(bytes, reading) + (partner ? DAMAGED_PARTNER : 0);
}

/** Whether the gap behind a request begins as its reply does, or the gap before a reply ends as its request does. */
function holdsPartner(
  bytes: Uint8Array,
  { from, to }: Chosen,
  direction: Direction,
  gapFrom: number,
  gapTo: number,
): boolean {
  const length = to - from;
  const alone = gapTo - gapFrom <= length + 1;
  const begins = (place: number) =>
    bytes[place] === bytes[from] && ((bytes[place + 1] as number) & 0x7f) === bytes[from + 1];
  const ends = () => {
    for (let i = 1; i <= TELLING; i++) if (bytes[gapTo - i] !== bytes[to - i]) return false;
    return gapTo - gapFrom >= TELLING;
  };
  if (direction === 'request') return begins(gapFrom) || (alone && ends());
  if (ends() || (alone && begins(gapFrom))) return true;
  // Some of its bytes may be missing.
  for (let place = Math.max(gapFrom, gapTo - length); place <= gapTo - length + 2; place++) {
    if (begins(place)) return true;
  }
  return false;
}
