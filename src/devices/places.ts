import { placesNear } from './line-index.ts';
import { indexOfName, isCalled, stepOf, valueName } from './numbering.ts';
import type { EntityTable, Profile, Register } from './profile.ts';

/** What a name stands for in a device: one value of a line. */
export interface NamedPlace {
  readonly register: Register;
  /** As the device calls it. */
  readonly name: string;
  readonly table: EntityTable;
  /** As sent, counted from 0. */
  readonly address: number;
}

/** Every value of a device that has this name: `P0683`, `VW804`, `VW 804`, `Float 7002`. Case and blanks mean nothing. */
export function placesNamed(profile: Profile, text: string): readonly NamedPlace[] {
  if (text.trim() === '') return [];
  return placesNear(profile.registers, text).flatMap((place) => {
    const register = profile.registers[place] as Register;
    const index = indexOfName(register, text) ?? (isCalled(register, text) ? 0 : undefined);
    if (index === undefined) return [];
    const address = register.address + index * stepOf(register, profile);
    return [{ register, name: valueName(register, index), table: register.table, address }];
  });
}
