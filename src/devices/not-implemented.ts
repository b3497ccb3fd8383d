import { hexDigits, isNumberType, type Value, type ValueType, writeValue } from '../modbus/index.ts';
import type { Register } from './profile.ts';

/** Whether a number in the registers of a line is the one that says “no value here”. */
export function saysNothing(raw: Value, { type, notImplemented, mask }: Register): boolean {
  if (notImplemented === undefined || mask !== undefined) return false;
  if (typeof raw === 'string') return raw === notImplemented;
  if (/^nan$/i.test(notImplemented)) return Number.isNaN(raw);
  return /^0x[\da-f]+$/i.test(notImplemented)
    ? bitsOf(raw, type) === BigInt(notImplemented)
    : Number(raw) === Number(notImplemented);
}

/** The bits of a number, high byte first. */
function bitsOf(raw: number | bigint, type: ValueType): bigint | undefined {
  if (!isNumberType(type)) return undefined;
  const written = writeValue(raw, type, 'ABCD');
  const digits = written.kind === 'registers' ? written.registers.map((word) => hexDigits(word, 4)).join('') : '';
  return digits === '' ? undefined : BigInt(`0x${digits}`);
}
