import type { CrcAlgorithm } from './crc-catalogue.ts';

/** The register after each byte, for a register of zero. Made once an algorithm, when it is first used. */
const tables = new WeakMap<CrcAlgorithm, Uint32Array>();

const WIDEST = 32;

/**
 * The CRC of `bytes[from, to)` by any parameters, as the number that is called its value; in which order its bytes are
 * sent is not part of it. Throws a `RangeError` for a width other than 1 to 32.
 */
export function crc(algorithm: CrcAlgorithm, bytes: Uint8Array, from = 0, to = bytes.length): number {
  const { width, init, refin, refout, xorout } = algorithm;
  requireWidth(width);
  const table = tableOf(algorithm);
  // Straight, the register stands at the top of 32 bits, so that one table serves every width.
  let register = refin ? reflect(init, width) : init << (WIDEST - width);
  if (refin) for (let i = from; i < to; i++) register = (register >>> 8) ^ at(table, register ^ (bytes[i] as number));
  else for (let i = from; i < to; i++) register = (register << 8) ^ at(table, (register >>> 24) ^ (bytes[i] as number));
  const value = refin ? register >>> 0 : register >>> (WIDEST - width);
  return ((refin === refout ? value : reflect(value, width)) ^ xorout) >>> 0;
}

const at = (table: Uint32Array, index: number) => table[index & 0xff] as number;

function tableOf(algorithm: CrcAlgorithm): Uint32Array {
  const known = tables.get(algorithm);
  if (known) return known;
  const { width, refin } = algorithm;
  const poly = refin ? reflect(algorithm.poly, width) : algorithm.poly << (WIDEST - width);
  const table = Uint32Array.from({ length: 256 }, (_, byte) => {
    let register = refin ? byte : byte << 24;
    for (let bit = 0; bit < 8; bit++) {
      if (refin) register = register & 1 ? (register >>> 1) ^ poly : register >>> 1;
      else register = register < 0 ? (register << 1) ^ poly : register << 1;
    }
    return register;
  });
  tables.set(algorithm, table);
  return table;
}

/** Throws a `RangeError` for a width other than 1 to 32. */
export function requireWidth(width: number): void {
  if (!Number.isInteger(width) || width < 1 || width > WIDEST) throw new RangeError(`a CRC of ${width} bits`);
}

/** The lowest `width` bits in the opposite order. */
export function reflect(value: number, width: number): number {
  let reflected = 0;
  for (let bit = 0; bit < width; bit++) reflected = (reflected << 1) | ((value >>> bit) & 1);
  return reflected >>> 0;
}

/** SUM-8 of `bytes[from, to)`: their sum modulo 256. Modbus does not use it; its LRC is the two's complement of it. */
export function sum8(bytes: Uint8Array, from = 0, to = bytes.length): number {
  let sum = 0;
  for (let i = from; i < to; i++) sum = (sum + (bytes[i] as number)) & 0xff;
  return sum;
}

/** The xor of `bytes[from, to)`, which other protocols call LRC. Modbus does not use it. */
export function xor8(bytes: Uint8Array, from = 0, to = bytes.length): number {
  let xor = 0;
  for (let i = from; i < to; i++) xor ^= bytes[i] as number;
  return xor;
}
