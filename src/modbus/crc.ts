import type { CrcAlgorithm } from './crc-catalogue.ts';
import { demandPart, demandWhole } from './demand.ts';

/** Slicing tables: entry `256 * s + b` is the register after byte `b` and `s` zero bytes, for a register of zero. */
const tables = new WeakMap<CrcAlgorithm, Int32Array>();

const WIDEST = 32;
/** Bytes folded into the register at a time. */
const SLICES = 8;
/** Fewer bytes are not worth the tables of all slices. */
const LONG = 2048;

/**
 * The CRC of `bytes[from, to)` by any parameters, as a number; the order in which its bytes are sent is not part of it.
 * Throws a `RangeError` for a width other than 1 to 32, and if `[from, to)` is not a part of the bytes.
 */
export function crc(algorithm: CrcAlgorithm, bytes: Uint8Array, from = 0, to = bytes.length): number {
  return crcValue(algorithm, crcAdd(algorithm, crcStart(algorithm), bytes, from, to));
}

/**
 * The register before the first byte, to be given to `crcAdd`. If bytes come in pieces, each `crcAdd` continues from the
 * register of the previous one, and `crcValue` turns the last register into the CRC. Throws as `crc` does.
 */
export function crcStart({ width, init, refin }: CrcAlgorithm): number {
  demandWidth(width);
  // Straight, the register stands at the top of 32 bits, so that one table serves every width.
  return refin ? reflect(init, width) : init << (WIDEST - width);
}

/** The register after `bytes[from, to)`. */
export function crcAdd(
  algorithm: CrcAlgorithm,
  register: number,
  bytes: Uint8Array,
  from = 0,
  to = bytes.length,
): number {
  demandPart(bytes, from, to);
  const table = tableOf(algorithm, to - from < LONG ? 1 : SLICES);
  return algorithm.refin
    ? addReflected(table, register, bytes, from, to)
    : addStraight(table, register, bytes, from, to);
}

/** The CRC that a register stands for. */
export function crcValue({ width, refin, refout, xorout }: CrcAlgorithm, register: number): number {
  demandWidth(width);
  const value = refin ? register >>> 0 : register >>> (WIDEST - width);
  return ((refin === refout ? value : reflect(value, width)) ^ xorout) >>> 0;
}

function addReflected(table: Int32Array, before: number, bytes: Uint8Array, from: number, to: number): number {
  let register = before;
  let i = from;
  if (table.length > 256) {
    for (const end = to - SLICES; i <= end; i += SLICES) {
      register =
        (table[1792 + ((register ^ (bytes[i] as number)) & 0xff)] as number) ^
        (table[1536 + (((register >>> 8) ^ (bytes[i + 1] as number)) & 0xff)] as number) ^
        (table[1280 + (((register >>> 16) ^ (bytes[i + 2] as number)) & 0xff)] as number) ^
        (table[1024 + ((register >>> 24) ^ (bytes[i + 3] as number))] as number) ^
        (table[768 + (bytes[i + 4] as number)] as number) ^
        (table[512 + (bytes[i + 5] as number)] as number) ^
        (table[256 + (bytes[i + 6] as number)] as number) ^
        (table[bytes[i + 7] as number] as number);
    }
  }
  for (; i < to; i++) register = (register >>> 8) ^ (table[(register ^ (bytes[i] as number)) & 0xff] as number);
  return register;
}

function addStraight(table: Int32Array, before: number, bytes: Uint8Array, from: number, to: number): number {
  let register = before;
  let i = from;
  if (table.length > 256) {
    for (const end = to - SLICES; i <= end; i += SLICES) {
      register =
        (table[1792 + ((register >>> 24) ^ (bytes[i] as number))] as number) ^
        (table[1536 + (((register >>> 16) ^ (bytes[i + 1] as number)) & 0xff)] as number) ^
        (table[1280 + (((register >>> 8) ^ (bytes[i + 2] as number)) & 0xff)] as number) ^
        (table[1024 + ((register ^ (bytes[i + 3] as number)) & 0xff)] as number) ^
        (table[768 + (bytes[i + 4] as number)] as number) ^
        (table[512 + (bytes[i + 5] as number)] as number) ^
        (table[256 + (bytes[i + 6] as number)] as number) ^
        (table[bytes[i + 7] as number] as number);
    }
  }
  for (; i < to; i++) register = (register << 8) ^ (table[(register >>> 24) ^ (bytes[i] as number)] as number);
  return register;
}

/** The tables of an algorithm, at least `slices` of them; made on first use. */
function tableOf(algorithm: CrcAlgorithm, slices: number): Int32Array {
  const known = tables.get(algorithm);
  if (known && known.length >= 256 * slices) return known;
  const { width, refin } = algorithm;
  demandWidth(width);
  const poly = refin ? reflect(algorithm.poly, width) : algorithm.poly << (WIDEST - width);
  const table = new Int32Array(256 * slices);
  for (let byte = 0; byte < 256; byte++) {
    let register = refin ? byte : byte << 24;
    for (let bit = 0; bit < 8; bit++) {
      if (refin) register = register & 1 ? (register >>> 1) ^ poly : register >>> 1;
      else register = register < 0 ? (register << 1) ^ poly : register << 1;
    }
    table[byte] = register;
  }
  for (let i = 256; i < table.length; i++) {
    const before = table[i - 256] as number;
    table[i] = refin
      ? (before >>> 8) ^ (table[before & 0xff] as number)
      : (before << 8) ^ (table[before >>> 24] as number);
  }
  tables.set(algorithm, table);
  return table;
}

/** Throws a `RangeError` for a width other than 1 to 32. */
export function demandWidth(width: number): void {
  demandWhole('bits of a CRC', width, 1, WIDEST);
}

/** The lowest `width` bits in the opposite order. */
export function reflect(value: number, width: number): number {
  let reflected = 0;
  for (let bit = 0; bit < width; bit++) reflected = (reflected << 1) | ((value >>> bit) & 1);
  return reflected >>> 0;
}

/**
 * SUM-8 of `bytes[from, to)`: their sum modulo 256. Modbus does not use it; its LRC is the two's complement of it. Throws as
 * `crc` does.
 */
export function sum8(bytes: Uint8Array, from = 0, to = bytes.length): number {
  demandPart(bytes, from, to);
  let sum = 0;
  for (let i = from; i < to; i++) sum = (sum + (bytes[i] as number)) & 0xff;
  return sum;
}

/** The xor of `bytes[from, to)`, which other protocols call LRC. Modbus does not use it. Throws as `crc` does. */
export function xor8(bytes: Uint8Array, from = 0, to = bytes.length): number {
  demandPart(bytes, from, to);
  let xor = 0;
  for (let i = from; i < to; i++) xor ^= bytes[i] as number;
  return xor;
}
