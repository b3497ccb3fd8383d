import { type FrameAt, framesAt, MOST_ASCII, toHex } from '../../../modbus/index.ts';
import { type Case, wholesOf } from '../../case.ts';
import { endsThere, tries } from '../../evidence.ts';
import type { Offer } from '../../finding.ts';
import type { Hypothesis } from '../../hypothesis.ts';

/** Frames of each transport and direction may begin anywhere. */
const WINDOWS = 2;
const ENDS_WITH_BYTES = 2;

/** Whole frames stand in the bytes, with bytes before, between or behind them that belong to none. */
export const framesInside: Hypothesis = {
  codes: ['stray-leading', 'stray-trailing', 'stray-around', 'merged'],
  offer: (item) => {
    const frames = bestFrames(item);
    const [first] = frames;
    const last = frames[frames.length - 1];
    if (first === undefined || last === undefined) return [];
    const { bytes, cut } = item;
    const leading = first.from;
    const trailing = cut ? 0 : bytes.length - last.to;
    if (frames.length === 1 && leading + trailing === 0) return [];
    const repaired = frames.map(({ from, to }) => bytes.slice(from, to));
    const bits = evidence(item, frames, trailing);
    if (frames.length > 1) {
      const between = bytes.length - frames.reduce((sum, { from, to }) => sum + to - from, 0);
      return [{ code: 'merged', from: 0, to: last.to, frames: frames.length, between, repaired, bits }];
    }
    return [stray(item, first, leading, trailing, { repaired, bits })];
  },
};

function stray(
  { bytes, request }: Case,
  { from, to }: FrameAt,
  leading: number,
  trailing: number,
  found: Pick<Offer, 'repaired' | 'bits'>,
): Offer {
  if (leading > 0 && trailing > 0)
    return { code: 'stray-around', from: 0, to: bytes.length, leading, trailing, ...found };
  if (trailing > 0) {
    const zero = bytes.subarray(to).every((byte) => byte === 0);
    return { code: 'stray-trailing', from: to, to: bytes.length, trailing, zero, ...found };
  }
  const front = toHex(bytes, 0, leading);
  const previous =
    toHex(bytes, Math.max(from, to - leading), to) === front ||
    (request !== undefined && toHex(request.bytes).endsWith(front));
  return { code: 'stray-leading', from: 0, to: leading, leading, previous, ...found };
}

/** The frames that together cover most of the bytes, found from the end. */
function bestFrames({ bytes, transport, request, cut }: Case): FrameAt[] {
  const { length } = bytes;
  const best: { value: number; frame: FrameAt | undefined }[] = new Array(length + 1);
  best[length] = { value: 0, frame: undefined };
  for (let at = length - 1; at >= 0; at--) {
    let choice = { value: best[at + 1]?.value ?? 0, frame: undefined as FrameAt | undefined };
    for (const frame of framesAt(bytes, at, Math.min(length, at + MOST_ASCII))) {
      if (transport !== undefined && frame.transport !== transport) continue;
      if (request !== undefined && frame.direction === 'request') continue;
      // A whole frame and a zero behind it is a frame too, but a far less likely one.
      if (wholesOf(bytes.subarray(at, frame.to), frame.transport, undefined).length === 0) continue;
      // A field that takes all bytes takes those behind a frame too, and with zeros the CRC still holds.
      if (frame.open && (frame.to < length || cut || !frame.legal)) continue;
      const value =
        frame.to - at + (frame.legal ? 2 : 0) + (frame.to === length ? ENDS_WITH_BYTES : 0) + valueAt(best, frame.to);
      if (value > choice.value) choice = { value, frame };
    }
    best[at] = choice;
  }
  const frames: FrameAt[] = [];
  for (let at = 0; at < length; ) {
    const frame = best[at]?.frame;
    if (frame) frames.push(frame);
    at = frame ? frame.to : at + 1;
  }
  return frames;
}

const valueAt = (best: readonly { value: number }[], at: number) => best[at]?.value ?? 0;

/** The evidence of the frames, less the number of places searched, less the bytes they leave unexplained. */
function evidence({ bytes, request }: Case, frames: readonly FrameAt[], trailing: number): number {
  let bits = 0;
  let end = 0;
  for (const { from, to, transport, direction } of frames) {
    const whole = wholesOf(bytes.subarray(from, to), transport, frames.length === 1 ? request : undefined).find(
      ({ reading }) => reading.direction === direction,
    );
    // Only for the last frame is it evidence that it ends where the bytes end.
    const elsewhere = whole && to < bytes.length ? endsThere(whole.reading) : 0;
    if (whole) bits += whole.bits - elsewhere - tries(WINDOWS * bytes.length);
    bits -= unexplained(from - end);
    end = to;
  }
  return bits - unexplained(trailing);
}

const unexplained = (bytes: number) => (bytes === 0 ? 0 : 2 + 2 * Math.log2(bytes));
