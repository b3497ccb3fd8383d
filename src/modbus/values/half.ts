/** Bits of the fraction, and the exponents of the smallest and the largest numbers (IEEE 754 binary16). */
const FRACTION = 10;
const LEAST_EXPONENT = -14;
const BIAS = 15;
const INFINITY = 0x7c00;
const NOT_A_NUMBER = 0x7e00;
/** From here on a number rounds to infinity: half a step above the largest, 65504. */
const OVERFLOW = 65520;

/** The number that 16 bits hold as IEEE 754 binary16. */
export function readHalf(bits: number): number {
  const sign = bits & 0x8000 ? -1 : 1;
  const exponent = (bits >>> FRACTION) & 0x1f;
  const fraction = bits & 0x3ff;
  if (exponent === 0x1f) return fraction === 0 ? sign * Infinity : Number.NaN;
  if (exponent === 0) return sign * fraction * 2 ** (LEAST_EXPONENT - FRACTION);
  return sign * (0x400 + fraction) * 2 ** (exponent - BIAS - FRACTION);
}

/** The 16 bits of the binary16 number nearest to a number, of two as near the even one. */
export function writeHalf(value: number): number {
  if (Number.isNaN(value)) return NOT_A_NUMBER;
  const sign = value < 0 || Object.is(value, -0) ? 0x8000 : 0;
  const size = Math.abs(value);
  if (size >= OVERFLOW) return sign | INFINITY;
  const exponent = Math.max(LEAST_EXPONENT, exponentOf(size));
  // Powers of two divide without loss, so that only this rounds.
  const steps = roundHalfEven(size / 2 ** (exponent - FRACTION));
  // The hidden bit, and a carry out of the fraction, add themselves to the exponent.
  return sign | (steps + ((exponent - LEAST_EXPONENT) << FRACTION));
}

function exponentOf(size: number): number {
  const view = new DataView(new ArrayBuffer(8));
  view.setFloat64(0, size);
  return ((view.getUint16(0) >>> 4) & 0x7ff) - 1023;
}

function roundHalfEven(value: number): number {
  const below = Math.floor(value);
  const rest = value - below;
  return rest > 0.5 || (rest === 0.5 && below % 2 === 1) ? below + 1 : below;
}
