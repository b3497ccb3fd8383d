import { demandPositive } from '../demand.ts';
import { bitsPerCharacter, type SerialLine } from './serial-format.ts';

// All times are microseconds.
const SECOND = 1_000_000;

/** Bits of every RTU character in SL 2.5.1; many devices count them so whatever their format. */
export const RTU_CHARACTER_BITS = 11;

/** The fastest speed at which the silences are counted in characters (SL 2.5.1.1). */
export const LAST_COUNTED_BAUD = 19_200;

/** The silences that bound characters and frames, in microseconds. */
export interface Silences {
  /** The longest silence between two characters of a frame. */
  readonly t15: number;
  /** The shortest silence between two frames. */
  readonly t35: number;
}

/** What is recommended above 19200 baud (SL 2.5.1.1). */
export const fixedSilences: Silences = { t15: 750, t35: 1750 };

/** How long a number of bits takes, in microseconds. Throws a `RangeError` for a speed of 0 or less, and a number below 0. */
export function bitsTime(baud: number, bits: number): number {
  demandPositive('bits a second', baud, 'not-zero');
  demandPositive('bits', bits, 'or-zero');
  return (bits * SECOND) / baud;
}

/** How long a number of characters without gaps takes, in microseconds. */
export const charactersTime = (line: SerialLine, characters: number): number =>
  bitsTime(line.baud, characters * bitsPerCharacter(line));

/** One and a half and three and a half characters of `bits` bits, whatever the speed. */
export const countedSilences = (baud: number, bits: number): Silences => ({
  t15: bitsTime(baud, 1.5 * bits),
  t35: bitsTime(baud, 3.5 * bits),
});

/** Whether the fixed silences hold at a speed: strictly above 19200 baud. */
export const hasFixedSilences = (baud: number): boolean => baud > LAST_COUNTED_BAUD;

/** The silences of RTU at a speed, with characters of `bits` bits: counted up to 19200 baud, fixed above (SL 2.5.1.1). */
export const rtuSilences = (baud: number, bits: number): Silences =>
  hasFixedSilences(baud) ? fixedSilences : countedSilences(baud, bits);

/** The longest that may pass between two characters of an ASCII frame, if both sides have not agreed on more (SL 2.5.2.1). */
export const ASCII_SILENCE = SECOND;

/** What becomes of a frame with a gap in it. */
export type GapEffect = 'whole' | 'discarded' | 'two-frames';

/** What a gap between two characters of an RTU frame does, in microseconds (SL 2.5.1.1). */
export function rtuGapEffect(gap: number, { t15, t35 }: Silences): GapEffect {
  if (gap <= t15) return 'whole';
  return gap < t35 ? 'discarded' : 'two-frames';
}

/** What a gap between two characters of an ASCII frame does, in microseconds (SL 2.5.2.1). */
export const asciiGapEffect = (gap: number): GapEffect => (gap <= ASCII_SILENCE ? 'whole' : 'discarded');
