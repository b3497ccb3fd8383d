import type { SerialLine } from '../../modbus/index.ts';

/** The tabs beside the form; the first is open until another is. */
export const frameTabs = ['bytes', 'values', 'reply', 'wire', 'crc', 'compare', 'program'] as const;
export type FrameTab = (typeof frameTabs)[number];

/** What a link says beside the frame: the tab that is open, the line that the frame is sent on, and the device. */
export interface FrameContext {
  readonly tab: FrameTab;
  /** `undefined` if it was not set for this frame. */
  readonly line: SerialLine | undefined;
  /** The id of the device that is chosen, which names what is in the frame. A draft that was read from a link has it itself. */
  readonly device: string | undefined;
  /** The device itself as a text, if it is a person's own. */
  readonly profile?: string | undefined;
  /** The target and the part of the program that the tab shows, as a text. */
  readonly program?: string | undefined;
}

export const firstContext: FrameContext = { tab: 'bytes', line: undefined, device: undefined };
