import { type Profile, unitScale } from '../../devices/index.ts';
import { type Place, type UnitSource, unitsAt } from './targets.ts';

const sameUnit = (unit: string) => (scale: { readonly unit: string } | undefined) =>
  scale?.unit.toLowerCase() === unit.toLowerCase();

/** The devices that have values in a unit; those that have it at a place first. */
export function devicesWithUnit(
  profiles: readonly Profile[],
  unit: string,
  place: Place | undefined,
): readonly Profile[] {
  const here = (device: Profile) => {
    const source: UnitSource = { device, own: undefined };
    return place !== undefined && unitsAt(source, place, 0).some(sameUnit(unit));
  };
  const anywhere = profiles.filter(({ registers }) => registers.map(unitScale).some(sameUnit(unit)));
  return [...anywhere.filter(here), ...anywhere.filter((profile) => !here(profile))];
}
