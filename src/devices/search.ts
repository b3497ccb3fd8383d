import { isTextType } from '../modbus/index.ts';
import { entityNumber, readNumber, sixDigitNumber } from '../notation/index.ts';
import { placesNear } from './line-index.ts';
import { addressesOf, indexOfName, lineName, printedNumber, stepOf, valuesOf } from './numbering.ts';
import { type EntityTable, entityTables, type Profile, type Register } from './profile.ts';

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
  const { registers } = profile;
  const named = new Set(placesNear(registers, wanted));
  const printed = entityTables.map((table) => addressOfNumber(profile, table, wanted));
  const address = readNumber(wanted);
  const all = texts.get(registers) ?? collected(registers);
  return registers.flatMap((register, place) => {
    const index =
      (named.has(place) ? indexOfName(register, wanted) : undefined) ??
      indexOfAddress(profile, register, printed[entityTables.indexOf(register.table)]) ??
      indexOfAddress(profile, register, address);
    if (index !== undefined) return [{ register, index: valuesOf(register) === 1 ? undefined : index }];
    return all[place]?.includes(wanted) ? [{ register, index: undefined }] : [];
  });
}

const texts = new WeakMap<readonly Register[], readonly string[]>();

/** The texts of each line; they are put together once for each list of lines. */
function collected(registers: readonly Register[]): readonly string[] {
  const all = registers.map((register) =>
    [lineName(register), register.description, register.unit, register.table, ...register.names.map(({ name }) => name)]
      .join('\n')
      .toLowerCase(),
  );
  texts.set(registers, all);
  return all;
}

function indexOfAddress(profile: Profile, register: Register, address: number | undefined): number | undefined {
  if (address === undefined) return undefined;
  const into = address - register.address;
  const inside = Number.isInteger(into) && into >= 0 && into < addressesOf(register, profile);
  return inside ? indexInto(profile, register, into) : undefined;
}

const indexInto = (profile: Profile, register: Register, into: number): number =>
  isTextType(register.type) ? 0 : Math.floor(into / stepOf(register, profile));

/**
 * The number that the manual prints; else one of five or six digits, with the digit of its table in front, in which people ask
 * for a register of any manual.
 */
function addressOfNumber({ convention }: Profile, table: EntityTable, wanted: string): number | undefined {
  if (!/^\d+$/.test(wanted)) return undefined;
  const address = Number(convention === 'one-based' ? wanted : wanted.slice(1)) - 1;
  if (convention !== 'zero-based' && printedNumber(convention, table, address) === wanted) return address;
  const behindDigit = Number(wanted.slice(1)) - 1;
  const numbers = [entityNumber(table, behindDigit), sixDigitNumber(table, behindDigit)];
  return numbers.includes(wanted) ? behindDigit : undefined;
}
