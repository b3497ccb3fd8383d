import type { FrameTab } from '../frame/frame-context.ts';

export type ChipId = 'set-30-hz' | 'wrong-crc' | 'float-reply' | 'faulty-log';

/** A text that one click puts into the input. */
interface TextChip {
  readonly id: ChipId;
  readonly text: string;
  /** The tab that shows what it is about. */
  readonly tab?: FrameTab;
}

/** A log of the page's own, which one click opens. */
interface LogChip {
  readonly id: ChipId;
  readonly log: 'demo';
}

/** What somebody who has nothing to paste may begin with. */
export const chips: readonly (TextChip | LogChip)[] = [
  { id: 'set-30-hz', text: 'unit 6 P0683 30 Hz' },
  { id: 'wrong-crc', text: '06 06 02 AB 10 00 E6 A1' },
  { id: 'float-reply', text: '01 03 04 07 7A 42 9B AB 95', tab: 'values' },
  { id: 'faulty-log', log: 'demo' },
];
