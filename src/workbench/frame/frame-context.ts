import { readSerialFormat, type SerialLine, serialFormatName } from '../../modbus/index.ts';
import { readSpeed } from '../wire/line-choice.ts';

/** The tabs beside the form; the first is open until another is. */
export const frameTabs = ['bytes', 'values', 'reply', 'wire', 'crc', 'compare'] as const;
export type FrameTab = (typeof frameTabs)[number];

/** What a link says beside the frame: the tab that is open, and the line that the frame is sent on. */
export interface FrameContext {
  readonly tab: FrameTab;
  /** `undefined` if it was not set for this frame. */
  readonly line: SerialLine | undefined;
}

export const firstContext: FrameContext = { tab: 'bytes', line: undefined };

/** A line as a link has it: `9600-8N1`. */
export const lineText = (line: SerialLine): string => `${line.baud}-${serialFormatName(line)}`;

/** Reads what `lineText` wrote; `undefined` for any other text. */
export function readLineText(text: string): SerialLine | undefined {
  const [, speed, name = ''] = /^(\d+)-(\w+)$/.exec(text) ?? [];
  const baud = speed === undefined ? undefined : readSpeed(speed);
  const format = readSerialFormat(name);
  return baud === undefined || format === undefined ? undefined : { baud, ...format };
}
