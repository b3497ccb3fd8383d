import { word } from '../../frames.ts';
import type { Hypothesis } from '../../hypothesis.ts';

/** A few registers copied out of a program. */
const MOST_BYTES = 16;
const FLOAT_BYTES = 4;
/** Measured values usually lie between these. */
const SMALLEST = 1e-3;
const LARGEST = 1e7;
const BITS = 1.5;

/** Not a frame, but the contents of registers. */
export const data: Hypothesis = {
  codes: ['valid-data'],
  offer: ({ bytes, transport, request, preceding, following }) => {
    const { length } = bytes;
    const alone = transport === undefined && request === undefined && preceding.length + following.length === 0;
    if (!alone || length === 0 || length > MOST_BYTES || length % 2 !== 0) return [];
    const plausible = areIntegers(bytes) ? 'integer' : areFloats(bytes) ? 'float' : undefined;
    if (plausible === undefined) return [];
    return [{ code: 'valid-data', from: 0, to: length, repaired: [], registers: length / 2, plausible, bits: BITS }];
  },
};

/** Whether each register is a small number. */
function areIntegers(bytes: Uint8Array): boolean {
  for (let at = 0; at < bytes.length; at += 2) if (word(bytes, at) > 0x0fff) return false;
  return true;
}

/** Whether each pair of registers is a float, all in the same order of bytes and registers. */
function areFloats(bytes: Uint8Array): boolean {
  if (bytes.length % FLOAT_BYTES !== 0) return false;
  const orders = [
    [0, 1, 2, 3],
    [2, 3, 0, 1],
    [1, 0, 3, 2],
    [3, 2, 1, 0],
  ];
  return orders.some((order) => {
    for (let at = 0; at < bytes.length; at += FLOAT_BYTES) {
      const four = Uint8Array.from(order, (offset) => bytes[at + offset] as number);
      const value = Math.abs(new DataView(four.buffer).getFloat32(0));
      if (!(value >= SMALLEST && value <= LARGEST)) return false;
    }
    return true;
  });
}
