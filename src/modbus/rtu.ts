import type { Reading } from './reading.ts';
import { CRC, readSerial } from './serial.ts';

/** Most bytes of an RTU frame (SL 2.5.1). */
export const MOST_RTU = 256;

/** Reads an RTU frame: unit identifier, PDU, CRC low byte first (SL 2.5.1). RTU over TCP is the same. */
export function readRtu(reading: Reading, bytes: Uint8Array): void {
  readSerial(reading, bytes, CRC, 'unknown');
}
