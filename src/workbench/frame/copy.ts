import { encodeFrame, type Reading } from '../../modbus/index.ts';
import { type ByteFormat, byteFormats, writeBytes } from '../../notation/index.ts';
import type { FrameNames } from './device-names.ts';
import { frameName } from './frame-name.ts';

export type CopyFormat = ByteFormat | 'ascii-line';

export const copyFormats: readonly CopyFormat[] = [...(Object.keys(byteFormats) as ByteFormat[]), 'ascii-line'];

/** A format, and whether the checksum is copied with the frame. */
export interface CopyChoice {
  readonly format: CopyFormat;
  readonly checksum: boolean;
}

/** What is copied until something else is chosen. */
export const firstCopyFormat: CopyFormat = 'spaced';

/** The format that was stored, alone or with more; `undefined` if the value has none. */
export function readCopyFormat(value: unknown): CopyFormat | undefined {
  const { format } = (typeof value === 'object' ? (value ?? {}) : { format: value }) as { readonly format?: unknown };
  return copyFormats.find((each) => each === format);
}

/** Whether the frame has a checksum that could be left out. */
export const hasChecksum = ({ spans }: Reading): boolean => spans.some(({ kind }) => kind === 'checksum');

/** Whether the frame can be said in a format: only the ASCII line needs what a bare PDU or half a frame lacks. */
export const canCopyAs = ({ transport, unitId, outcome }: Reading, format: CopyFormat): boolean =>
  format !== 'ascii-line' || (transport !== 'pdu' && unitId !== undefined && outcome.kind === 'whole');

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
