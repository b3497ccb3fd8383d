import { isTextType } from '../modbus/index.ts';
import { readNumber } from '../notation/index.ts';
import { addressesOf, indexOfName, lineName, printedNumber, stepOf, valuesOf } from './numbering.ts';
import type { Profile, Register } from './profile.ts';

/** A line of a profile, or one value of it. */
export interface FoundRegister {
  readonly register: Register;
  readonly index: number | undefined;
}

/**
 * The lines of a profile that a search is about: by words of their texts, by the name of one of their values, by an address
 * counted from 0 in decimal or hexadecimal, or by the number that the manual prints. All lines for a blank search.
 */
export function searchProfile(profile: Profile, text: string): readonly FoundRegister[] {
  const wanted = text.trim().toLowerCase();
  if (wanted === '') return profile.registers.map((register) => ({ register, index: undefined }));
  const address = readNumber(wanted);
  return profile.registers.flatMap((register) => {
    const named = indexOfName(register, wanted) ?? indexOfNumber(profile, register, wanted);
    const index = named ?? (address === undefined ? undefined : indexOfAddress(profile, register, address));
    if (index !== undefined) return [{ register, index: valuesOf(register) === 1 ? undefined : index }];
    return says(register, wanted) ? [{ register, index: undefined }] : [];
  });
}

const says = (register: Register, wanted: string): boolean =>
  [lineName(register), register.description, register.unit, register.table, ...register.names.map(({ name }) => name)]
    .join('\n')
    .toLowerCase()
    .includes(wanted);

function indexOfAddress(profile: Profile, register: Register, address: number): number | undefined {
  const into = address - register.address;
  const inside = Number.isInteger(into) && into >= 0 && into < addressesOf(register, profile);
  return inside ? indexInto(profile, register, into) : undefined;
}

const indexInto = (profile: Profile, register: Register, into: number): number =>
  isTextType(register.type) ? 0 : Math.floor(into / stepOf(register, profile));

/** The number that the manual prints has the table's digit in front, which leaves the address counted from one. */
function indexOfNumber(profile: Profile, register: Register, wanted: string): number | undefined {
  const { convention } = profile;
  if (!/^\d+$/.test(wanted) || convention === 'zero-based') return undefined;
  const address = Number(convention === 'one-based' ? wanted : wanted.slice(1)) - 1;
  return printedNumber(convention, register.table, address) === wanted
    ? indexOfAddress(profile, register, address)
    : undefined;
}
