import { demandWidth, reflect } from '../crc.ts';
import type { CrcAlgorithm } from '../crc-catalogue.ts';
import { demandWhole } from '../demand.ts';

const BITS = 8;

/**
 * The register after two runs of bytes: `first` is the register after the one, `second` that after the other, starting
 * from a register of zero, and `size` the number of bytes of the other. This lets the parts of a file be processed in
 * parallel.
 */
export function joinRegisters(algorithm: CrcAlgorithm, first: number, second: number, size: number): number {
  const { width, refin } = algorithm;
  demandWidth(width);
  demandWhole('bytes', size, 0, Number.MAX_SAFE_INTEGER);
  // As polynomials, highest power first: zeros after the first run multiply its register by a power of x.
  const asPolynomial = (register: number) => (refin ? reflect(register, width) : register >>> (32 - width));
  const shifted = multiply(asPolynomial(first), powerOfX(BITS * size, algorithm), algorithm);
  return (refin ? reflect(shifted, width) : shifted << (32 - width)) ^ second;
}

/** x to the power `n`, modulo the polynomial. */
function powerOfX(n: number, algorithm: CrcAlgorithm): number {
  let power = 1;
  // From the highest bit of n on: square, then multiply by x if the bit is set.
  for (const bit of n.toString(2)) {
    power = multiply(power, power, algorithm);
    if (bit === '1') power = timesX(power, algorithm);
  }
  return power;
}

/** A register times x modulo the polynomial, both highest power first: one bit more of zero. */
export function timesX(value: number, { width, poly }: CrcAlgorithm): number {
  const top = 2 ** (width - 1);
  const rest = ((value % top) * 2) >>> 0;
  return value >= top ? (rest ^ poly) >>> 0 : rest;
}

/** The product of two polynomials, modulo the algorithm's. */
function multiply(one: number, other: number, algorithm: CrcAlgorithm): number {
  let product = 0;
  for (let bit = algorithm.width - 1; bit >= 0; bit--) {
    product = timesX(product, algorithm);
    if ((one >>> bit) & 1) product = (product ^ other) >>> 0;
  }
  return product;
}
