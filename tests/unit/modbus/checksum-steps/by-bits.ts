import type { CrcAlgorithm } from '../../../../src/modbus/index.ts';

/** One shift: the register before, the bit moved out, the register after. */
export type Shift = readonly [before: number, out: number, after: number];

/**
 * A CRC as a second opinion, on lists of bits: the register always moves to the left, as catalogues define it, and is
 * turned round to be looked at where the algorithm reflects its input.
 */
export function byBits(algorithm: CrcAlgorithm, bytes: Iterable<number>) {
  const { width, refin } = algorithm;
  const bits = Math.max(width, 8);
  const list = (value: number) => Array.from({ length: width }, (_, i) => Math.floor(value / 2 ** (width - 1 - i)) % 2);
  const room = Array.from({ length: bits - width }, () => 0);
  const poly = [...list(algorithm.poly), ...room];
  const look = (register: readonly number[]) => Number.parseInt((refin ? register.toReversed() : register).join(''), 2);

  let register = [...list(algorithm.init), ...room];
  const registers = [look(register)];
  const mixed: number[] = [];
  const shifts: Shift[][] = [];
  for (const byte of bytes) {
    const data = Array.from({ length: 8 }, (_, i) => (refin ? byte >> i : byte >> (7 - i)) & 1);
    register = register.map((bit, i) => (bit + (data[i] ?? 0)) % 2);
    mixed.push(look(register));
    const eight: Shift[] = [];
    for (let i = 0; i < 8; i++) {
      const before = look(register);
      const out = register[0] ?? 0;
      register = [...register.slice(1), 0].map((bit, at) => (bit + out * (poly[at] ?? 0)) % 2);
      eight.push([before, out, look(register)]);
    }
    shifts.push(eight);
    registers.push(look(register));
  }
  return { registers, mixed, shifts };
}
