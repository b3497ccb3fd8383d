import { reflect, requireWidth } from '../crc.ts';
import type { CrcAlgorithm } from '../crc-catalogue.ts';

/** One polynomial in the three ways it is printed. */
export interface PolynomialForms {
  /** Without its highest term, the others from the left: 0x8005. */
  readonly normal: number;
  /** The same from the right, as it is xored into a register that moves to the right: 0xA001. */
  readonly reversed: number;
  /** With its highest term and without its lowest, the 1: 0xC002. There is none for a polynomial without a 1. */
  readonly koopman: number | undefined;
}

/** The polynomial of an algorithm in the three ways. Throws a `RangeError` for a width other than 1 to 32. */
export function polynomialForms({ width, poly }: Pick<CrcAlgorithm, 'width' | 'poly'>): PolynomialForms {
  requireWidth(width);
  return {
    normal: poly >>> 0,
    reversed: reflect(poly, width),
    koopman: poly & 1 ? ((1 << (width - 1)) | (poly >>> 1)) >>> 0 : undefined,
  };
}
