import { demandPart } from './demand.ts';

/** Bytes folded into the register at a time by the slicing tables. */
const SLICES = 8;

/**
 * Slicing tables, 256 entries a slice: entry `256 * s + b` is the register after byte `b` and `s` zero bytes, starting
 * from zero. Because a CRC is linear over xor, eight bytes are folded with eight independent look-ups.
 */
const TABLE = (() => {
  const table = new Uint16Array(256 * SLICES);
  for (let byte = 0; byte < 256; byte++) {
    let register = byte;
    for (let bit = 0; bit < 8; bit++) register = register & 1 ? (register >>> 1) ^ 0xa001 : register >>> 1;
    table[byte] = register;
  }
  for (let i = 256; i < table.length; i++) {
    const before = table[i - 256] as number;
    table[i] = (before >>> 8) ^ (table[before & 0xff] as number);
  }
  return table;
})();

/**
 * CRC-16/MODBUS of `bytes[from, to)` as the 16-bit register value: initial FFFF, polynomial A001 (8005 reflected),
 * no final xor. The wire carries its low byte first (SL 2.5.1.2, SL 6.2): for `02 07` the value is 0x1241, sent `41 12`.
 * `before` is the CRC of the bytes before these, from which it continues. Throws a `RangeError` if `[from, to)` is not a part of
 * the bytes.
 */
export function crc16(bytes: Uint8Array, from = 0, to = bytes.length, before = 0xffff): number {
  demandPart(bytes, from, to);
  const table = TABLE;
  let crc = before;
  let i = from;
  for (const end = to - SLICES; i <= end; i += SLICES) {
    const first = (bytes[i] as number) ^ (crc & 0xff);
    const second = (bytes[i + 1] as number) ^ (crc >>> 8);
    crc =
      (table[1792 + first] as number) ^
      (table[1536 + second] as number) ^
      (table[1280 + (bytes[i + 2] as number)] as number) ^
      (table[1024 + (bytes[i + 3] as number)] as number) ^
      (table[768 + (bytes[i + 4] as number)] as number) ^
      (table[512 + (bytes[i + 5] as number)] as number) ^
      (table[256 + (bytes[i + 6] as number)] as number) ^
      (table[bytes[i + 7] as number] as number);
  }
  for (; i < to; i++) crc = (crc >>> 8) ^ (table[(crc ^ (bytes[i] as number)) & 0xff] as number);
  return crc;
}
