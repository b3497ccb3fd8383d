import { readBytes } from '../../../notation/index.ts';
import { Cell } from '../../state/cell.ts';

/** What the device sent, as typed, and whether it is being compared: both while the page is open. */
export const sentText = new Cell('');
export const comparing = new Cell(false);

/** The bytes of a text, however it says them; `undefined` for a text that says none. */
export function readSent(text: string): Uint8Array | undefined {
  const { bytes } = readBytes(text);
  return bytes.length === 0 && text.trim() !== '' ? undefined : bytes;
}
