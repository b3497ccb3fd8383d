import { type FrameAt, framesAt, MOST_ASCII } from '../../modbus/index.ts';
import type { ByteText } from './types.ts';

/** Places at which frames are looked for, of all a text has: enough to tell one reading from another. */
const PLACES = 1000;

/** The part of the bytes, 0 to 1, that stands in frames whose checksum and fields hold. */
export function provedPart({ bytes, chunks }: Pick<ByteText, 'bytes' | 'chunks'>): number {
  let places = 0;
  let proved = 0;
  let tried = 0;
  for (const { from, to } of chunks) {
    let at = from;
    while (at < to && places < PLACES) {
      places++;
      const frame = longest(framesAt(bytes, at, Math.min(to, at + MOST_ASCII)));
      proved += frame === undefined ? 0 : frame.to - at;
      at = frame?.to ?? at + 1;
    }
    tried += at - from;
    if (places >= PLACES) break;
  }
  return tried === 0 ? 0 : proved / tried;
}

/** Whether bytes are one frame from end to end whose checksum and fields hold. */
export const isFrame = (bytes: Uint8Array): boolean =>
  framesAt(bytes, 0, bytes.length).some(({ to, legal }) => legal && to === bytes.length);

const longest = (frames: readonly FrameAt[]): FrameAt | undefined =>
  frames.filter(({ legal }) => legal).sort((one, other) => other.to - one.to)[0];
