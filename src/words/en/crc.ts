import { formatBytes } from '../../notation/index.ts';
import type { FrameChecksum } from '../../workbench/index.ts';
import { byteHex, bytesOf, word } from './common.ts';

const none: Readonly<Record<Extract<FrameChecksum, { kind: 'none' }>['why'], string>> = {
  tcp: 'A Modbus TCP frame has no checksum of its own: TCP checks each segment, and Ethernet each packet. The same request as RTU has one; see Compare.',
  pdu: 'A bare PDU has no checksum: it is part of what carries the PDU. Choose RTU or ASCII to see it.',
  'not-digits': 'The characters before the LRC are not all hexadecimal digits: they give no bytes to add.',
};

/** How the checksum of the current frame comes about. */
export const crc = {
  none,
  noFrame: 'Correct the form to see the checksum of the frame.',
  crcCovers: (size: number) =>
    `CRC-16/MODBUS covers ${size === 1 ? 'the first byte' : `the first ${bytesOf(size)}`}: all that come before it.`,
  lrcCovers: (size: number) =>
    `The LRC covers ${bytesOf(size)}, not the characters that carry them, and neither the colon nor CR LF.`,
  columns: { byte: 'byte', hex: 'hex', register: 'register after it' },
  /** The register before the first byte. */
  initial: 'begins with',
  earlier: (count: number) => `after ${bytesOf(count)}`,
  /** The register at the end, and the bytes that are sent. */
  register: (register: number) => `The register ends as ${word(register)}.`,
  sent: (sent: Uint8Array) => `It is sent low byte first: ${formatBytes(sent)}.`,
  sum: (sum: number, lrc: number) =>
    `Their sum is ${word(sum)}, its low byte ${byteHex(sum & 0xff)}. 100 − ${byteHex(sum & 0xff)} makes the LRC ${byteHex(lrc)}.`,
  holds: 'The frame has it: the checksum holds.',
  wrong: (got: string) => `The frame has ${got} instead: the checksum does not hold.`,
  missing: 'The frame ends before it.',
  steps: 'Step by step in the Checksum view',
};

export type CrcWords = typeof crc;
