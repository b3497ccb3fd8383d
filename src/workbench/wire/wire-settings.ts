import { readNumber } from '../../notation/index.ts';
import { number, oneOf, record } from '../stored.ts';
import { type LevelKind, levelKinds } from './geometry.ts';

/** How frames are drawn on the line, besides its own setting. */
export interface WireSettings {
  readonly level: LevelKind;
  /** Milliseconds until the device answers. */
  readonly delay: number;
}

export const firstWire: WireSettings = { level: 'rs485', delay: 5 };

const MOST_MILLISECONDS = 2000;

/** The settings kept last; a part that is missing or not legal is as in `firstWire`. */
export const storedWire = record<WireSettings>(
  { level: oneOf(Object.keys(levelKinds) as LevelKind[]), delay: number(0, MOST_MILLISECONDS) },
  firstWire,
);

/** A time in milliseconds as typed. */
export function readMilliseconds(typed: string): number | undefined {
  const time = readNumber(typed.replace(/\s*ms$/i, ''));
  return time !== undefined && time >= 0 && time <= MOST_MILLISECONDS ? time : undefined;
}

/** The byte that a gap precedes, as typed: 1 to `last`. A blank text means no gap; `undefined` for any other text. */
export function readGapAt(typed: string, last: number): { readonly gapAt: number | undefined } | undefined {
  if (typed.trim() === '') return { gapAt: undefined };
  const at = readNumber(typed);
  return at !== undefined && Number.isInteger(at) && at >= 1 && at <= last ? { gapAt: at } : undefined;
}
