import { type Profile, placeOfRegister, writeTable } from '../../devices/index.ts';

/** Whether what was read is a profile beside one that is there, brings it up to date by address, or takes its place. */
export type MapImportWay = (typeof mapImportWays)[number];
export const mapImportWays = ['add', 'update', 'replace'] as const;

type Registers = Profile['registers'];

/** Where a register is, whatever it is called. */
const spotOf = ({ table, address, mask, models }: Registers[number]): string =>
  JSON.stringify([table, address, mask, models]);

/** For each register the one of another map that stands for it: of its name and address, or the only one of its address that is left. */
function partners(ones: Registers, others: Registers): ReadonlyMap<Registers[number], Registers[number]> {
  const byPlace = new Map(others.map((register) => [placeOfRegister(register), register]));
  const found = new Map<Registers[number], Registers[number]>();
  for (const one of ones) {
    const same = byPlace.get(placeOfRegister(one));
    if (same) found.set(one, same);
  }
  const taken = new Set(found.values());
  const left = bySpot(others.filter((other) => !taken.has(other)));
  for (const [spot, alone] of bySpot(ones.filter((one) => !found.has(one)))) {
    const [[one], [other, ...more]] = [alone, left.get(spot) ?? []];
    if (one && other && alone.length === 1 && more.length === 0) found.set(one, other);
  }
  return found;
}

function bySpot(registers: Registers): ReadonlyMap<string, Registers> {
  const found = new Map<string, Registers[number][]>();
  for (const register of registers) {
    const spot = spotOf(register);
    const there = found.get(spot);
    if (there) there.push(register);
    else found.set(spot, [register]);
  }
  return found;
}

/**
 * A profile brought up to date by another reading of its map: a register of an address that it has takes the old one's place, a new one
 * comes behind, and those that are not in the reading stay.
 */
export function mergeProfile(before: Profile, read: Profile): Profile {
  const partnerOf = partners(before.registers, read.registers);
  const taken = new Set(partnerOf.values());
  const registers = before.registers.map((register) => partnerOf.get(register) ?? register);
  const fresh = read.registers.filter((register) => !taken.has(register));
  return { ...before, ...(read.answers && { answers: read.answers }), registers: [...registers, ...fresh] };
}

/** Whether two profiles say the same under the same name; ids, and what a person answered, are the page's own. */
export const isSameMap = (one: Profile, other: Profile): boolean => contents(one) === contents(other);

const contents = (profile: Profile): string => JSON.stringify(writeTable({ ...profile, id: '' }));

/** What differs between two maps, by the place of each register. */
export interface MapDifference {
  readonly place: string;
  readonly one?: Profile['registers'][number] | undefined;
  readonly other?: Profile['registers'][number] | undefined;
}

/** The registers that only one of two maps has, or that differ in them, in the order of the first. */
export function compareProfiles(one: Profile, other: Profile): readonly MapDifference[] {
  const partnerOf = partners(one.registers, other.registers);
  const taken = new Set(partnerOf.values());
  const differing = one.registers.flatMap((register): MapDifference[] => {
    const same = partnerOf.get(register);
    const isSame = same && JSON.stringify(same) === JSON.stringify(register);
    return isSame ? [] : [{ place: placeOfRegister(register), one: register, other: same }];
  });
  const rest = other.registers.filter((register) => !taken.has(register));
  return [...differing, ...rest.map((register) => ({ place: placeOfRegister(register), other: register }))];
}
