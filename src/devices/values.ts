import { demandWhole, type Fraction, isNumberType, numberTypes, toNumber, type Value } from '../modbus/index.ts';
import { heldValue } from './codec.ts';
import { exactlyInUnits, isScaled, scaleOf } from './line-scale.ts';
import type { NamedNumber, Register } from './profile.ts';

/** The value of a raw number in the unit of its line; `raw` itself if the line has no scale. */
export function inUnits(raw: number | bigint, register: Register, exponent = 0): number | bigint {
  if (!isScaled(register)) return raw;
  const exactly = exactValue(raw, register, exponent);
  if (exactly !== undefined) return toNumber(exactly);
  const { factor, offset } = scaleOf(register);
  return Number(raw) * toNumber(factor) + toNumber(offset);
}

/** The same exactly; `undefined` for NaN and infinities. */
export const exactValue = (raw: number | bigint, register: Register, exponent = 0): Fraction | undefined =>
  typeof raw === 'number' && !Number.isFinite(raw) ? undefined : exactlyInUnits(raw, register, exponent);

/** The names of the bits that are 1, or the name of the value. */
export function namesOf(raw: Value, { type, names, mask }: Register): readonly string[] {
  if (typeof raw === 'string') return [];
  const ofBits = isNumberType(type) && numberTypes[type].kind === 'bits' && mask === undefined;
  const holds = ({ number }: NamedNumber) =>
    ofBits ? number >= 0 && ((BigInt(raw) >> BigInt(number)) & 1n) === 1n : number === Number(raw);
  return names.filter(holds).map(({ name }) => name);
}

/** What registers hold of a line: a value of its type, or the bits of it that the line is about; `undefined` if they hold none. */
export function rawOf(words: readonly number[], { type, order, mask }: Register): Value | undefined {
  const whole = heldValue(words, type, order);
  return whole === undefined || mask === undefined ? whole : masked(whole, mask);
}

/** The bits of a whole number that are the value of a line, moved down. */
function masked(raw: Value, mask: number): Value {
  demandWhole('mask', mask, 1, Number.MAX_SAFE_INTEGER);
  if (typeof raw === 'string' || (typeof raw === 'number' && !Number.isInteger(raw))) return raw;
  const bits = BigInt(mask);
  const low = bits & -bits;
  const part = (BigInt.asUintN(64, BigInt(raw)) & bits) / low;
  return typeof raw === 'bigint' ? part : Number(part);
}
