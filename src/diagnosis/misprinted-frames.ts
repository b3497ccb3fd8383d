import { fromHex } from '../modbus/index.ts';

/** Frames that a source prints wrongly, by the names of the examples that show them. */
const PRINTED = {
  'weg-set-30-hz': { printed: '060602AB1000E6A1', right: '060602AB1000F5E5', wrong: 'crc' },
  'weg-run': { printed: '060602AA0001F527', right: '060602AA00016825', wrong: 'crc' },
  'weg-stop': { printed: '060602AA00002635', right: '060602AA0000A9E5', wrong: 'crc' },
  'weg-read-speed': { printed: '060302A90001D5E7', right: '060302A900015425', wrong: 'crc' },
  'introduction-read-40108': { printed: '1103000B0003', right: '1103006B00037687', wrong: 'address' },
} as const;

export type MisprintedFrameId = keyof typeof PRINTED;

/** A frame as a source prints it and as it should be. */
export interface MisprintedFrame {
  readonly id: MisprintedFrameId;
  /** Without its CRC if the source leaves that out. */
  readonly printed: Uint8Array;
  readonly right: Uint8Array;
  /** What is wrong in print: the CRC, or the address. */
  readonly wrong: 'crc' | 'address';
}

const bytesOf = (digits: string): Uint8Array => fromHex(digits) ?? new Uint8Array();

/** The frames that our sources print wrongly; `right` was calculated from its fields. */
export const misprintedFrames: readonly MisprintedFrame[] = Object.entries(PRINTED).map(([id, frame]) => ({
  id: id as MisprintedFrameId,
  printed: bytesOf(frame.printed),
  right: bytesOf(frame.right),
  wrong: frame.wrong,
}));
