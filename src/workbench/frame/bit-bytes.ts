import { fromHex } from '../../modbus/index.ts';
import { readOctets } from '../../notation/index.ts';

/** Bits as a frame carries them (AP 6.1, AP 6.11): the lowest address is bit 0 of the first byte; what is left of the last byte is 0. */
export function bytesOfBits(bits: readonly number[]): Uint8Array {
  const bytes = new Uint8Array(Math.ceil(bits.length / 8));
  for (const [index, bit] of bits.entries())
    if (bit !== 0) bytes[index >> 3] = (bytes[index >> 3] ?? 0) | (1 << (index & 7));
  return bytes;
}

/**
 * The bits of bytes as typed, the lowest address first; `undefined` if the text is not bytes. They are `count` if these bytes
 * have room for no more and no less and no bit behind them is set; else as many as the bytes have.
 */
export function bitsOfBytes(text: string, count: number): readonly (0 | 1)[] | undefined {
  const octets = readOctets(text);
  if (octets === undefined) return undefined;
  const bytes = fromHex(octets);
  if (bytes === undefined) return undefined;
  const bits = Array.from({ length: 8 * bytes.length }, (_, index): 0 | 1 =>
    ((bytes[index >> 3] ?? 0) >>> (index & 7)) & 1 ? 1 : 0,
  );
  const fits = Math.ceil(count / 8) === bytes.length && !bits.includes(1, count);
  return fits ? bits.slice(0, count) : bits;
}

/** As many bits as wanted, at most 2000: those that are there, then zeros. */
export const withCount = (bits: readonly number[], count: number): readonly number[] =>
  Array.from({ length: Math.max(1, Math.min(2000, Math.trunc(count) || 1)) }, (_, index) => bits[index] ?? 0);
