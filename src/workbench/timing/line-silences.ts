import {
  bitsTime,
  countedSilences,
  fixedSilences,
  type GapEffect,
  hasFixedSilences,
  RTU_CHARACTER_BITS,
  rtuGapEffect,
  type Silences,
} from '../../modbus/index.ts';
import type { SetLine } from './timing-entries.ts';

/** A way to find the silences of an RTU line (SL 2.5.1.1). */
export interface SilenceReading extends Silences {
  /** Bits of the characters that are counted; `undefined` for the fixed times. */
  readonly bits: number | undefined;
  /** Microseconds; `undefined` for the fixed times. */
  readonly character: number | undefined;
  /** Whether it is the one that this line goes by. */
  readonly inForce: boolean;
}

/** All ways: by the bits of the format, by the 11 of the specification, and fixed if the line is fast. */
export function silenceReadings({ baud, bits, countedBits }: SetLine): SilenceReading[] {
  const fixed = hasFixedSilences(baud);
  const sizes = [...new Set([bits, RTU_CHARACTER_BITS])];
  const counted = sizes.map((size) => ({
    bits: size,
    character: bitsTime(baud, size),
    ...countedSilences(baud, size),
    inForce: !fixed && size === countedBits,
  }));
  return fixed ? [...counted, { bits: undefined, character: undefined, ...fixedSilences, inForce: true }] : counted;
}

/** What a gap does to an RTU frame. */
export interface GapReading {
  readonly effect: GapEffect;
  /** What it does to a receiver that counts characters of this many bits, if that is different. */
  readonly other: { readonly bits: number; readonly effect: GapEffect } | undefined;
}

/** What a gap between two characters, in microseconds, does, and how receivers differ about it. */
export function gapReading(gap: number, { baud, bits, countedBits, silences }: SetLine): GapReading {
  const effect = rtuGapEffect(gap, silences);
  // Above 19200 baud both readings are fixed, and receivers differ in whether they count.
  const otherBits = hasFixedSilences(baud) || countedBits !== bits ? bits : RTU_CHARACTER_BITS;
  const other = rtuGapEffect(gap, countedSilences(baud, otherBits));
  return { effect, other: other === effect ? undefined : { bits: otherBits, effect: other } };
}
