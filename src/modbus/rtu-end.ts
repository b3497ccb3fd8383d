import type { CrcWindows } from './crc-windows.ts';
import { crc16 } from './crc16.ts';
import { PduWalk, type Side } from './pdu-walk.ts';
import { MOST_RTU } from './rtu.ts';
import { CRC } from './serial.ts';

/** Unit identifier, function code and CRC. */
export const LEAST_RTU = 4;

const walk = new PduWalk();

/**
 * Where the PDU of an RTU frame that begins at `at` ends, by its fields and its CRC, after `past`; 0 if there is no such
 * frame. Only an open PDU has more than one end.
 */
export function rtuPduEnd(
  side: Side,
  bytes: Uint8Array,
  at: number,
  end: number,
  past: number,
  windows?: CrcWindows,
): number {
  const near = end <= at + MOST_RTU;
  const functionCode = bytes[at + 1] as number;
  if (!near && side.open[functionCode] === 1) return 0;
  const last = (near ? end : at + MOST_RTU) - CRC.width;
  const width = side.widths[functionCode] as number;
  if (width > 0) return closed(bytes, at, at + 1 + width, last, past, windows);
  const countAt = side.countAt[functionCode] as number;
  if (countAt > 0) {
    const place = at + 1 + countAt;
    if (place >= last) return 0;
    const pdu = at + 1 + (side.uncounted[functionCode] as number) + (bytes[place] as number);
    return closed(bytes, at, pdu, last, past, windows);
  }
  const pdu = walk.end(side, bytes, at + 1, last);
  if (walk.usual > past && walk.usual < pdu && crcHolds(bytes, at, walk.usual, windows)) return walk.usual;
  if (pdu > last || pdu <= past || (walk.open && !near)) return 0;
  return crcHolds(bytes, at, pdu, windows) ? pdu : 0;
}

const closed = (
  bytes: Uint8Array,
  at: number,
  pdu: number,
  last: number,
  past: number,
  windows: CrcWindows | undefined,
): number => (pdu <= last && pdu > past && crcHolds(bytes, at, pdu, windows) ? pdu : 0);

const crcHolds = (bytes: Uint8Array, at: number, pdu: number, windows: CrcWindows | undefined): boolean =>
  windows === undefined
    ? crc16(bytes, at, pdu) === ((bytes[pdu] as number) | ((bytes[pdu + 1] as number) << 8))
    : windows.closes(at, pdu + CRC.width);
