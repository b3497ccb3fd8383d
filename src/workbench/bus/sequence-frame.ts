import { fromHex } from '../../modbus/index.ts';
import { formatBytes, readOctets } from '../../notation/index.ts';
import { evaluate } from '../frame/evaluate.ts';
import { readLink } from '../frame/link.ts';

/** The bytes of the frame that a link leads to, as pairs; `undefined` if the text is not a link to a frame. */
export function bytesOfLink(text: string): string | undefined {
  const link = text.includes('#') ? text.slice(text.indexOf('#')) : text;
  if (!/^#?\w+\/\w+\?/.test(link)) return undefined;
  const reading = readLink(link);
  const frame = reading && reading.unknown.length === 0 ? evaluate(reading.draft).frame : undefined;
  return frame && formatBytes(frame.bytes);
}

/** What was typed as pairs if it is bytes in any notation or a link to a frame, else unchanged. */
export function tidyFrame(text: string): string {
  const octets = readOctets(text);
  const bytes = octets === undefined ? undefined : fromHex(octets);
  if (bytes && bytes.length > 0) return formatBytes(bytes);
  return bytesOfLink(text.trim()) ?? text;
}
