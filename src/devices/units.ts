import { LAST_ADDRESS, simplestFraction } from '../modbus/index.ts';
import type { UnitScale } from '../notation/index.ts';
import { wordsOf } from './codec.ts';
import { linesAt } from './named.ts';
import { type EntityTable, isBitTable, type Profile, type Register } from './profile.ts';
import { countsValues } from './traits.ts';

/** Most decimals that are chosen for a line that does not say how many. */
const MOST_DECIMALS = 6;

/** How a line's values in its unit stand in registers; `undefined` for a line without a unit. */
export function unitScale({ table, type, order, unit, factor, offset, decimals }: Register): UnitScale | undefined {
  if (unit === '' || type === 'text' || isBitTable(table)) return undefined;
  // As many digits as tell one raw number from the next.
  const digits = Math.min(MOST_DECIMALS, Math.max(0, Math.ceil(Math.log10(Math.abs(factor)))));
  const scale = {
    factor: simplestFraction(factor),
    offset: simplestFraction(offset),
    decimals: decimals ?? digits,
  };
  return { unit, scale, type, order };
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
