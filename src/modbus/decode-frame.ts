import { readAscii } from './ascii.ts';
import { closePdu, readPdu } from './pdu.ts';
import { type Direction, Reading, type Transport } from './reading.ts';
import { readRtu } from './rtu.ts';
import { readAfter, reportShort } from './serial.ts';
import { readTcp } from './tcp.ts';
import { checkAgainstRequest } from './unit-rules.ts';

/** How to read the bytes. */
export interface DecodeContext {
  readonly transport: Transport;
  readonly direction: Direction;
  /** The bytes of the request that a reply answers, of the same transport. */
  readonly request?: Uint8Array | undefined;
}

/**
 * Reads the bytes as one frame: its fields, the place of each, whether it is whole, and every rule it breaks, with the
 * section. Never throws; takes time linear in the number of bytes.
 */
export function decodeFrame(bytes: Uint8Array, { transport, direction, request }: DecodeContext): Reading {
  const asked =
    request !== undefined && direction === 'response'
      ? decodeFrame(request, { transport, direction: 'request' })
      : undefined;
  const reading = new Reading(transport, direction, asked);
  switch (transport) {
    case 'rtu':
      readRtu(reading, bytes);
      break;
    case 'ascii':
      readAscii(reading, bytes);
      break;
    case 'tcp':
      readTcp(reading, bytes);
      break;
    case 'pdu':
      readBarePdu(reading, bytes);
      break;
  }
  if (asked !== undefined) checkAgainstRequest(reading, asked);
  return reading;
}

function readBarePdu(reading: Reading, bytes: Uint8Array): void {
  const { length } = bytes;
  const pdu = readPdu(reading, bytes, 0, length);
  const end = Math.min(pdu, length);
  closePdu(reading, bytes, 0, pdu, end, false);
  if (end < length) readAfter(reading, bytes, end);
  else if (pdu > length) reportShort(reading, pdu - length, length);
}
