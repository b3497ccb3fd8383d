// Frames put together by hand, byte by byte: what every program's answers are held against.
import assert from 'node:assert/strict';

/** CRC-16/MODBUS, bit by bit (SL 6.2.2). */
export function referenceCrc16(bytes) {
  let crc = 0xffff;
  for (let i = 0; i < bytes.length; i++) {
    crc ^= bytes[i];
    for (let bit = 0; bit < 8; bit++) crc = crc & 1 ? (crc >>> 1) ^ 0xa001 : crc >>> 1;
  }
  return crc;
}

/** A request to read holding registers (AP 6.3). */
export function readRequest({ unitId, startAddress, quantity }) {
  return closed([unitId, 0x03, ...u16(startAddress), ...u16(quantity)]);
}

/** A reply with holding registers (AP 6.3). */
export function readReply({ unitId, registers }) {
  return closed([unitId, 0x03, 2 * registers.length, ...registers.flatMap(u16)]);
}

/** A request to write registers (AP 6.12). */
export function writeRequest({ unitId, startAddress, registers }) {
  const { length } = registers;
  return closed([unitId, 0x10, ...u16(startAddress), ...u16(length), 2 * length, ...registers.flatMap(u16)]);
}

/** The PDU of an RTU frame: without the unit identifier and the CRC. */
export const pduOf = (frame) => frame.subarray(1, -2);

const u16 = (value) => [value >>> 8, value & 0xff];

/** Adds the CRC, low byte first (SL 2.5.1.2). */
function closed(body) {
  const crc = referenceCrc16(body);
  return Uint8Array.of(...body, crc & 0xff, crc >>> 8);
}

// The reference itself, against a frame known from many manuals.
assert.deepEqual(
  readRequest({ unitId: 17, startAddress: 107, quantity: 3 }),
  Uint8Array.of(0x11, 0x03, 0x00, 0x6b, 0x00, 0x03, 0x76, 0x87),
);
