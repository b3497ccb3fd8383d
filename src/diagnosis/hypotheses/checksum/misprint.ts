import { sameBytes } from '../../../modbus/index.ts';
import { CERTAIN } from '../../evidence.ts';
import type { Offer } from '../../finding.ts';
import { join, swapWord, word } from '../../frames.ts';
import type { Hypothesis } from '../../hypothesis.ts';
import { type MisprintedFrame, misprintedFrames } from '../../misprinted-frames.ts';

/** The evidence of exactly these bytes: more than any other cause of a wrong CRC has. */
const PRINTED = CERTAIN + 60;
/** The evidence of a misprinted address: less than what the bytes themselves prove. */
const ADDRESS = 13;

/** The frame of a manual or an article, with the mistake in its print. */
export const misprint: Hypothesis = {
  codes: ['known-misprint'],
  offer: ({ bytes, transport, cut }) =>
    cut || (transport !== undefined && transport !== 'rtu')
      ? []
      : misprintedFrames.flatMap((frame) => [...asPrinted(frame, bytes), ...withBytesSwapped(frame, bytes)]),
};

function offerOf({ id, wrong, right, printed }: MisprintedFrame, swapped: boolean): Offer {
  const code = 'known-misprint';
  const told = { code, misprint: id, wrong, swapped, repaired: [right] } as const;
  if (wrong === 'crc') {
    const from = printed.length - 2;
    const [got, expected] = [printed, right].map((frame) => swapWord(word(frame, from))) as [number, number];
    return { ...told, from, to: printed.length, got: swapped ? swapWord(got) : got, expected, bits: PRINTED };
  }
  const from = [...printed.keys()].find((index) => printed[index] !== right[index]) ?? 0;
  const [got, expected] = [printed[from] ?? 0, right[from] ?? 0];
  // With the wrong address it is another frame, which may be meant.
  return { ...told, from, to: from + 1, got, expected, bits: ADDRESS, guess: true };
}

const asPrinted = (frame: MisprintedFrame, bytes: Uint8Array): Offer[] =>
  sameBytes(frame.printed, bytes) ? [offerOf(frame, false)] : [];

/** The printed CRC with its bytes exchanged, as if the printed CRC were a number. */
function withBytesSwapped(frame: MisprintedFrame, bytes: Uint8Array): Offer[] {
  if (frame.wrong !== 'crc') return [];
  const { printed } = frame;
  const swapped = join(printed.subarray(0, -2), [...printed.subarray(-2)].reverse());
  return sameBytes(swapped, bytes) ? [offerOf(frame, true)] : [];
}
