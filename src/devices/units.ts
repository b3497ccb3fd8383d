import { simplestFraction } from '../modbus/index.ts';
import type { UnitScale } from '../notation/index.ts';
import { linesAt } from './named.ts';
import { stepOf } from './numbering.ts';
import { type EntityTable, isBitTable, type Profile, type Register } from './profile.ts';

/** Most decimals that are chosen where a line names none. */
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

/**
 * The lines whose value begins so many registers behind the address `first`. Where a device counts each value as one
 * address, the registers between are as many as the values are long.
 */
export function linesBehind(profile: Profile, table: EntityTable, first: number, place: number): readonly Register[] {
  let [address, at] = [first, 0];
  while (at < place) {
    const lines = linesAt(profile, table, address).filter(({ begins }) => begins);
    const sizes = lines.map(({ register }) => stepOf(register, { ...profile, traits: [] }) / stepOf(register, profile));
    at += Math.max(1, ...sizes);
    address += 1;
  }
  if (at > place) return [];
  return linesAt(profile, table, address)
    .filter(({ begins }) => begins)
    .map(({ register }) => register);
}
