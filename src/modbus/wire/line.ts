import { demandFinite } from '../demand.ts';
import { bitsPerCharacter, type SerialFormat } from '../timing/index.ts';
import { characterBits } from './character.ts';

/** A pause inside a frame. */
export interface Gap {
  /** How many characters of the frame come before it. */
  readonly after: number;
  /** Bit times. */
  readonly length: number;
}

/** A frame that is put on the line: its bytes (RTU) or its characters (ASCII). */
export interface LineFrame {
  readonly bytes: Uint8Array;
  readonly gap?: Gap | undefined;
}

/** The silences around frames, in bit times. */
export interface LineTimes {
  /** How much of the idle line is shown, before the first frame's silence and after the last one's. */
  readonly lead: number;
  /** The silence before and after a frame: 3.5 character times (SL 2.5.1.1), or 0 if frames need no silence. */
  readonly silence: number;
  /** From the end of a frame to the start of the next; never less than `silence`. */
  readonly delay: number;
}

/** A character on the line; its bits follow each other from `start` to `end`. */
export interface LineCharacter {
  /** Of the frames put on the line, and of the bytes in it, from 0. */
  readonly frame: number;
  readonly index: number;
  readonly value: number;
  readonly start: number;
  readonly end: number;
}

/** A part of the line that is idle, and its neighbours. */
export interface Quiet {
  readonly kind: 'before' | 'inside' | 'between' | 'after';
  /** The frame before it; of `before`, the one that follows. */
  readonly frame: number;
  readonly from: number;
  readonly to: number;
}

/** What a line carries, from 0 to `end`. All times are in bit times of the sender. */
export interface Line {
  readonly format: SerialFormat;
  readonly characters: readonly LineCharacter[];
  readonly quiets: readonly Quiet[];
  /** From the first start bit to the last stop bit of each frame. */
  readonly frames: readonly { readonly from: number; readonly to: number }[];
  readonly end: number;
}

/** Puts frames on a line one after the other. Throws a `RangeError` for times that are not finite. */
export function lineOf(sent: readonly LineFrame[], format: SerialFormat, times: LineTimes): Line {
  const length = bitsPerCharacter(format);
  const characters: LineCharacter[] = [];
  const quiets: Quiet[] = [];
  const frames: { from: number; to: number }[] = [];
  let at = 0;
  const pause = (kind: Quiet['kind'], frame: number, bits: number) => {
    demandFinite('bit times', bits);
    if (bits > 0) quiets.push({ kind, frame, from: at, to: at + bits });
    at += Math.max(0, bits);
  };
  sent.forEach(({ bytes, gap }, frame) => {
    if (frame === 0) pause('before', frame, times.lead + times.silence);
    else pause('between', frame - 1, Math.max(times.delay, times.silence));
    const from = at;
    bytes.forEach((value, index) => {
      if (gap && index > 0 && gap.after === index) pause('inside', frame, gap.length);
      characters.push({ frame, index, value, start: at, end: at + length });
      at += length;
    });
    frames.push({ from, to: at });
  });
  pause('after', sent.length - 1, times.silence + times.lead);
  return { format, characters, quiets, frames, end: at };
}

/**
 * Where the line changes its level, in bit times: first to 0, because an idle line is at 1, then to 1, and so on
 * alternately. Throws a `RangeError` for a character that does not begin at a finite time.
 */
export function edgesOf({ characters, format }: Pick<Line, 'characters' | 'format'>): number[] {
  const edges: number[] = [];
  for (const { value, start } of characters) {
    demandFinite('bit times', start);
    let level = 1;
    characterBits(value, format).forEach((bit, index) => {
      if (bit.level !== level) edges.push(start + index);
      level = bit.level;
    });
  }
  return edges;
}

/** The index of the first of a line's characters that ends after a time, or their number. Takes logarithmic time. */
export function firstAfter(characters: readonly LineCharacter[], time: number): number {
  let low = 0;
  let high = characters.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((characters[middle] as LineCharacter).end > time) high = middle;
    else low = middle + 1;
  }
  return low;
}
