import type { Register } from '../../devices/index.ts';
import { decimalOf, type Fraction, formatFraction, shownDigits } from '../../modbus/index.ts';

/** A number of a device, with as many digits as its line says or its type holds. */
export function numberText(value: number | bigint, { type, decimals }: Register): string {
  if (typeof value === 'bigint') return String(value);
  if (!Number.isFinite(value)) return Number.isNaN(value) ? 'not a number (NaN)' : value > 0 ? 'infinity' : '−infinity';
  if (decimals !== undefined) return value.toFixed(decimals).replace(/^-/, '−');
  return String(Number(value.toPrecision(shownDigits(type)))).replace(/^-/, '−');
}

/** More digits behind the point are rounded. */
const MOST_DECIMALS = 12;

/** The value of a line: all digits where a number of the program would lose some, as with scaled numbers of 64 bits. */
export function valueText(value: number | bigint, register: Register, exactly: Fraction | undefined): string {
  const { decimals } = register;
  const shown =
    decimals === undefined
      ? exactly && decimalOf(exactly, MOST_DECIMALS)
      : exactly && formatFraction(exactly, decimals);
  const isLong = shown !== undefined && shown.replace(/\D/g, '').length > shownDigits('f64');
  return isLong ? shown.replace(/^-/, '−') : numberText(value, register);
}
