import { encodeFrame, type Reading } from '../../modbus/index.ts';
import { writeBytes } from '../../notation/index.ts';
import { type CopyChoice, canCopyAs } from './copy.ts';
import { frameName, programNames } from './frame-name.ts';

/** The frame as text in a format, programs with a name for it; `undefined` if the frame has no such form. */
export function copyText(
  reading: Reading,
  bytes: Uint8Array,
  { format, checksum }: CopyChoice,
  name: readonly string[] = frameName(reading),
): string | undefined {
  if (format === 'ascii-line') return asciiLine(reading, bytes);
  return writeBytes(checksum ? bytes : withoutChecksum(reading, bytes), format, name);
}

/** A frame under the name that a person gave it. */
export interface GivenFrame {
  readonly name: string;
  readonly reading: Reading;
  readonly bytes: Uint8Array;
}

/** Frames as text in a format, each on a line, in programs under names of their own; those that have no such form are left out. */
export function copyTogether(frames: readonly GivenFrame[], choice: CopyChoice): string {
  const names = programNames(frames);
  return frames
    .map(({ reading, bytes }, index) => copyText(reading, bytes, choice, names[index]))
    .filter((line) => line !== undefined)
    .join('\n');
}

function withoutChecksum({ spans }: Reading, bytes: Uint8Array): Uint8Array {
  const span = spans.find(({ kind }) => kind === 'checksum');
  return span === undefined ? bytes : bytes.filter((_, at) => at < span.from || at >= span.to);
}

/** The characters of the frame as ASCII sends it, without the CR LF that a terminal adds. A bare PDU has no unit for it. */
function asciiLine(reading: Reading, bytes: Uint8Array): string | undefined {
  if (!canCopyAs(reading, 'ascii-line')) return undefined;
  const { checksum: _checksum, length: _length, protocolId: _protocolId, ...force } = reading.forced;
  const characters = reading.transport === 'ascii' ? bytes : encodeFrame({ ...reading, transport: 'ascii', force });
  return String.fromCharCode(...characters).replace(/[\r\n]+$/, '');
}
