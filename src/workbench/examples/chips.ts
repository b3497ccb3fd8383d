import type { FrameTab } from '../frame/frame-context.ts';

export type ChipId = 'set-30-hz' | 'wrong-crc' | 'float-reply' | 'faulty-log';

/** A text that one click puts into the input. */
export interface Chip {
  readonly id: ChipId;
  readonly text: string;
  /** The tab that shows what it is about. */
  readonly tab?: FrameTab;
}

/** Ten frames of a drive: an exception, a unit that does not answer twice, and one bit of a reply that changed. */
const FAULTY_LOG = [
  '10:31:12.300 Tx 06 03 02 A9 00 01 54 25',
  '10:31:12.316 Rx 06 03 02 10 00 00 44',
  '10:31:13.300 Tx 06 06 02 AB 10 00 F5 E5',
  '10:31:13.314 Rx 06 06 02 AB 10 00 F5 E5',
  '10:31:14.300 Tx 06 03 03 E7 00 01 35 CE',
  '10:31:14.315 Rx 06 83 02 71 30',
  '10:31:15.300 Tx 07 03 02 A9 00 01 55 F4',
  '10:31:16.300 Tx 07 03 02 A9 00 01 55 F4',
  '10:31:17.300 Tx 06 03 02 A9 00 01 54 25',
  '10:31:17.316 Rx 06 03 02 0F FE 89 F5',
].join('\n');

/** What somebody who has nothing to paste may begin with. */
export const chips: readonly Chip[] = [
  { id: 'set-30-hz', text: 'P0683 30 Hz' },
  { id: 'wrong-crc', text: '06 06 02 AB 10 00 E6 A1' },
  { id: 'float-reply', text: '01 03 04 07 7A 42 9B AB 95', tab: 'values' },
  { id: 'faulty-log', text: FAULTY_LOG },
];
