import { type Profile, placeOfRegister } from '../../devices/index.ts';

/** Whether what was read is a profile beside one that is there, brings it up to date by address, or takes its place. */
export type MapImportWay = (typeof mapImportWays)[number];
export const mapImportWays = ['add', 'update', 'replace'] as const;

/**
 * A profile brought up to date by another reading of its map: a register of an address that it has takes the old one's place, a new one
 * comes behind, and those that are not in the reading stay.
 */
export function mergeProfile(before: Profile, read: Profile): Profile {
  const fresh = new Map(read.registers.map((register) => [placeOfRegister(register), register]));
  const registers = before.registers.map((register) => {
    const place = placeOfRegister(register);
    const found = fresh.get(place);
    fresh.delete(place);
    return found ?? register;
  });
  return { ...before, ...(read.answers && { answers: read.answers }), registers: [...registers, ...fresh.values()] };
}

/** What differs between two maps, by the place of each register. */
export interface MapDifference {
  readonly place: string;
  readonly one?: Profile['registers'][number] | undefined;
  readonly other?: Profile['registers'][number] | undefined;
}

/** The registers that only one of two maps has, or that differ in them, in the order of the first. */
export function compareProfiles(one: Profile, other: Profile): readonly MapDifference[] {
  const others = new Map(other.registers.map((register) => [placeOfRegister(register), register]));
  const differing = one.registers.flatMap((register): MapDifference[] => {
    const place = placeOfRegister(register);
    const same = others.get(place);
    others.delete(place);
    return same && JSON.stringify(same) === JSON.stringify(register) ? [] : [{ place, one: register, other: same }];
  });
  return [...differing, ...[...others].map(([place, register]) => ({ place, other: register }))];
}
