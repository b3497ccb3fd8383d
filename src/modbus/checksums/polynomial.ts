import { demandWidth, reflect } from '../crc.ts';
import type { CrcAlgorithm } from '../crc-catalogue.ts';

/** One polynomial in the three ways it is printed. */
export interface PolynomialForms {
  /** Highest power first, without the top one: 8005 for CRC-16/MODBUS. */
  readonly normal: number;
  /** The same bits the other way round, as programs that shift to the right have it: A001. */
  readonly reversed: number;
  /** Highest power first, without the lowest one: C002. */
  readonly koopman: number;
}

/** The polynomial of an algorithm as it is printed elsewhere. Throws a `RangeError` for a width other than 1 to 32. */
export function polynomialForms({ width, poly }: Pick<CrcAlgorithm, 'width' | 'poly'>): PolynomialForms {
  demandWidth(width);
  return { normal: poly, reversed: reflect(poly, width), koopman: ((2 ** (width - 1)) | (poly >>> 1)) >>> 0 };
}
