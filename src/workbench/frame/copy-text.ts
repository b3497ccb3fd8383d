import { encodeFrame, type Reading } from '../../modbus/index.ts';
import { writeBytes } from '../../notation/index.ts';
import { type CopyChoice, canCopyAs } from './copy.ts';
import type { FrameNames } from './device-names.ts';
import { frameName } from './frame-name.ts';

/** The frame as text in a format, programs with a name for it; `undefined` if the frame has no such form. */
export function copyText(
  reading: Reading,
  bytes: Uint8Array,
  { format, checksum }: CopyChoice,
  names?: FrameNames,
): string | undefined {
  if (format === 'ascii-line') return asciiLine(reading, bytes);
  return writeBytes(checksum ? bytes : withoutChecksum(reading, bytes), format, frameName(reading, names));
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
