import type { Reading } from '../../../modbus/index.ts';
import { type CopyFormat, copyText, type FrameNames, frameName } from '../../../workbench/index.ts';
import { withChecksum } from './copied-as.ts';

interface Copied {
  readonly reading: Reading;
  readonly bytes: Uint8Array;
  readonly names?: FrameNames | undefined;
}

/** A frame as it is copied in a format; empty if it has no such form. */
export const copiedAs = (as: CopyFormat, { reading, bytes, names }: Copied): string =>
  copyText(reading, bytes, { format: as, checksum: withChecksum.value }, frameName(reading, names)) ?? '';
