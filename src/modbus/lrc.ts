import { demandPart } from './demand.ts';

/**
 * LRC of `bytes[from, to)`, one byte: the two's complement of their sum modulo 256 (SL 2.5.2.2). It is taken over the
 * binary bytes, unit identifier to the last data byte, not over the characters that carry them: `0A 01 04 A1 00 01` → 4F.
 * Throws a `RangeError` if `[from, to)` is not a part of the bytes.
 */
export function lrc(bytes: Uint8Array, from = 0, to = bytes.length): number {
  demandPart(bytes, from, to);
  let sum = 0;
  for (let i = from; i < to; i++) sum = (sum + (bytes[i] as number)) & 0xff;
  return -sum & 0xff;
}
