import { demandWidth, reflect } from '../crc.ts';
import type { CrcAlgorithm } from '../crc-catalogue.ts';

const BYTE = 8;

/** How the register of a CRC stands and moves while the bytes go in. */
export interface RegisterForm {
  /** Bits of the register: those of the CRC, but at least 8, because a byte must fit into it. */
  readonly bits: number;
  /** Whether it moves to the right, its lowest bit first, or to the left, its highest bit first. */
  readonly reflected: boolean;
  /** The polynomial as it is xored in: reversed if the register moves to the right. */
  readonly poly: number;
  /** The register before the first byte. */
  readonly initial: number;
}

/**
 * The register of an algorithm. If it moves to the left and has fewer than 8 bits, it is at the top of 8. Throws a
 * `RangeError` for a width other than 1 to 32.
 */
export function registerForm({ width, poly, init, refin }: CrcAlgorithm): RegisterForm {
  demandWidth(width);
  const bits = Math.max(width, BYTE);
  const place = (value: number) => (refin ? reflect(value, width) : lowest(value << (bits - width), bits));
  return { bits, reflected: refin, poly: place(poly), initial: place(init) };
}

/** The CRC without its final xor, of a register after the last byte. */
export function withoutXor({ width, refin, refout }: CrcAlgorithm, register: number): number {
  const value = refin ? register : register >>> (Math.max(width, BYTE) - width);
  return refin === refout ? value : reflect(value, width);
}

/** The bit that the next shift moves out. */
export const outOf = ({ bits, reflected }: RegisterForm, register: number): 0 | 1 =>
  ((reflected ? register : register >>> (bits - 1)) & 1) as 0 | 1;

/** The register after one shift: moved by a bit, and xored with the polynomial if the bit moved out was 1. */
export function shifted(form: RegisterForm, register: number): number {
  const moved = form.reflected ? register >>> 1 : lowest(register << 1, form.bits);
  return outOf(form, register) === 1 ? (moved ^ form.poly) >>> 0 : moved;
}

/** A byte placed at the end of the register from which the bits leave. */
export const placed = ({ bits, reflected }: RegisterForm, byte: number): number =>
  reflected ? byte : (byte << (bits - BYTE)) >>> 0;

/** The eight bits of the register that the next eight shifts move out. */
export const leaving = ({ bits, reflected }: RegisterForm, register: number): number =>
  (reflected ? register : register >>> (bits - BYTE)) & 0xff;

/** The register moved by eight bits, without any xor. */
export const movedByByte = ({ bits, reflected }: RegisterForm, register: number): number =>
  reflected ? register >>> BYTE : lowest(register << BYTE, bits);

const lowest = (value: number, bits: number) => (value & (bits === 32 ? -1 : (1 << bits) - 1)) >>> 0;
