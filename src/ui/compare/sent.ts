import { fromHex } from '../../modbus/index.ts';
import { readOctets } from '../../notation/index.ts';
import { Cell } from '../cell.ts';

/** What the device sent, as typed, and whether it is being compared: both while the page is open. */
export const sentText = new Cell('');
export const comparing = new Cell(false);

/** The bytes of a text; `undefined` for a text that is none. */
export function readSent(text: string): Uint8Array | undefined {
  const octets = readOctets(text);
  return octets === undefined ? undefined : fromHex(octets);
}
