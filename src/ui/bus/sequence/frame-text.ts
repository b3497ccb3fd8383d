import { fromHex } from '../../../modbus/index.ts';
import { formatBytes, readOctets } from '../../../notation/index.ts';
import { evaluate, readLink } from '../../../workbench/index.ts';

/** The bytes of the frame that a link is to, as pairs; `undefined` where it is to none. */
export function bytesOfLink(text: string): string | undefined {
  const link = text.includes('#') ? text.slice(text.indexOf('#')) : text;
  if (!/^#?\w+\/\w+\?/.test(link)) return undefined;
  const reading = readLink(link);
  const frame = reading && reading.unknown.length === 0 ? evaluate(reading.draft).frame : undefined;
  return frame && formatBytes(frame.bytes);
}

/** What was typed as pairs, where it is bytes in any way or a link to a frame; else as it is. */
export function tidyFrame(text: string): string {
  const octets = readOctets(text);
  const bytes = octets === undefined ? undefined : fromHex(octets);
  if (bytes && bytes.length > 0) return formatBytes(bytes);
  return bytesOfLink(text.trim()) ?? text;
}
