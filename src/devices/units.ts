import { compare, type Fraction, fraction, isNumberType, isPartial, LAST_ADDRESS, multiply } from '../modbus/index.ts';
import type { UnitScale } from '../notation/index.ts';
import { wordsOf } from './codec.ts';
import { scaleOf } from './line-scale.ts';
import { linesAt } from './named.ts';
import { type EntityTable, isBitTable, type Profile, type Register } from './profile.ts';
import { countsValues } from './traits.ts';

/** Most decimals that are chosen for a line that does not say how many. */
const MOST_DECIMALS = 6;

/**
 * How a line's values in its unit stand in registers; `undefined` for a line without a unit, and for one whose value is only
 * some bits of the registers or has a power of ten in another register.
 */
export function unitScale(register: Register): UnitScale | undefined {
  const { table, type, order, unit, decimals, mask, scaleRegister } = register;
  if (unit === '' || !isNumberType(type) || isBitTable(table) || mask !== undefined || scaleRegister) return undefined;
  if (isPartial(type)) return undefined;
  const scale = scaleOf(register);
  return { unit, scale: { ...scale, decimals: decimals ?? decimalsOf(scale.factor) }, type, order };
}

/** As many digits as tell one raw number from the next. */
function decimalsOf({ numerator, denominator }: Fraction): number {
  const size = fraction(numerator < 0n ? -numerator : numerator, denominator);
  for (let decimals = 0; decimals < MOST_DECIMALS; decimals++)
    if (compare(multiply(size, fraction(10n ** BigInt(decimals))), fraction(1)) >= 0) return decimals;
  return MOST_DECIMALS;
}

/** The lines whose value begins `place` registers after the address `first`. */
export function linesBehind(profile: Profile, table: EntityTable, first: number, place: number): readonly Register[] {
  const address = countsValues(profile) ? addressBehind(profile, table, first, place) : first + place;
  return address === undefined ? [] : beginningAt(profile, table, address);
}

/** The address of a register if each value counts as one address, however long it is; `undefined` inside a value. */
function addressBehind(profile: Profile, table: EntityTable, first: number, place: number): number | undefined {
  if (place > LAST_ADDRESS) return undefined;
  let [address, at] = [first, 0];
  for (; at < place; address++) {
    at += Math.max(1, ...beginningAt(profile, table, address).map(({ type }) => wordsOf(type)));
  }
  return at === place ? address : undefined;
}

const beginningAt = (profile: Profile, table: EntityTable, address: number): readonly Register[] =>
  linesAt(profile, table, address)
    .filter(({ begins }) => begins)
    .map(({ register }) => register);
