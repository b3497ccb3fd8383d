import type { Register } from '../../devices/index.ts';
import { shownDigits } from '../../modbus/index.ts';

/** A number of a device, with as many digits as its line says or its type holds. */
export function numberText(value: number | bigint, { type, decimals }: Register): string {
  if (typeof value === 'bigint') return String(value);
  if (!Number.isFinite(value)) return Number.isNaN(value) ? 'not a number (NaN)' : value > 0 ? 'infinity' : '−infinity';
  if (decimals !== undefined) return value.toFixed(decimals).replace(/^-/, '−');
  return String(Number(value.toPrecision(shownDigits(type)))).replace(/^-/, '−');
}
