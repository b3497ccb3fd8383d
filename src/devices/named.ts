import { type Fraction, isTextType, type Value } from '../modbus/index.ts';
import { wordsOf } from './codec.ts';
import { linesNear } from './line-index.ts';
import { isScaled, powerIn } from './line-scale.ts';
import { saysNothing } from './not-implemented.ts';
import { stepOf, valueName, valuesOf } from './numbering.ts';
import { type EntityTable, isBitTable, type Profile, type Register } from './profile.ts';
import { countsValues } from './traits.ts';
import { exactValue, inUnits, namesOf, rawOf } from './values.ts';

/** A value of a device, found in a frame. */
export interface NamedValue {
  readonly register: Register;
  readonly name: string;
  /** As sent, counted from 0. */
  readonly address: number;
  /** Where it begins in the list of registers or bits, and how many of them it takes. */
  readonly at: number;
  readonly size: number;
  /** `undefined` if the list ends inside it, or if BCD has a digit above 9. */
  readonly raw: Value | undefined;
  readonly cutOff: boolean;
  /** In the unit of its line; `undefined` also if the list does not have the register of its power of ten. */
  readonly scaled: number | bigint | undefined;
  /** The same exactly, of a line with a scale. */
  readonly exactly?: Fraction | undefined;
  /** The device says that it has no such value. */
  readonly notImplemented?: true;
  /** The names of its bits that are 1, or the name of its value. */
  readonly names: readonly string[];
}

/** The lines of a profile that hold an address, with the value of theirs that begins at or before it. */
export function linesAt(
  profile: Profile,
  table: EntityTable,
  address: number,
): readonly { readonly register: Register; readonly index: number; readonly begins: boolean }[] {
  return linesNear(profile.registers, table, address).flatMap((register) => {
    const step = isTextType(register.type) ? register.count : stepOf(register, profile);
    const into = address - register.address;
    if (into >= valuesOf(register) * step) return [];
    return [{ register, index: Math.floor(into / step), begins: into % step === 0 }];
  });
}

/** The name of the value at an address; `undefined` if the profile has no line for it. */
export function nameAt(profile: Profile, table: EntityTable, address: number): string | undefined {
  const names = linesAt(profile, table, address).map(({ register, index }) => valueName(register, index));
  return names.length === 0 ? undefined : [...new Set(names)].join(', ');
}

/**
 * The values that begin in a list of registers (0 to 65535) or bits (0 or 1) read from `first` on, in their order. Where a
 * device counts each value as one address, the list holds as many registers as the values are long.
 */
export function namedValues(
  profile: Profile,
  table: EntityTable,
  first: number,
  list: readonly number[],
): readonly NamedValue[] {
  const found: NamedValue[] = [];
  const whole = countsValues(profile);
  for (let at = 0, address = first; at < list.length; address++) {
    const here = linesAt(profile, table, address).filter(({ begins }) => begins);
    let widest = 1;
    for (const { register, index } of here) {
      const value = valueAt(register, index, { at, list, address });
      found.push(value);
      if (whole) widest = Math.max(widest, value.size);
    }
    at += widest;
  }
  return found;
}

interface At {
  readonly at: number;
  readonly list: readonly number[];
  /** Of the item `at` of the list. */
  readonly address: number;
}

function valueAt(register: Register, index: number, { at, list, address }: At): NamedValue {
  const name = valueName(register, index);
  const bit = isBitTable(register.table);
  const size = bit ? 1 : sizeOf(register);
  const words = list.slice(at, at + size);
  const cutOff = words.length < size;
  const raw = cutOff ? undefined : bit ? words[0] : rawOf(words, register);
  const place = { register, name, address, at, size, raw, cutOff };
  if (raw === undefined) return { ...place, scaled: undefined, names: [] };
  if (saysNothing(raw, register)) return { ...place, scaled: undefined, names: [], notImplemented: true };
  const names = namesOf(raw, bit ? { ...register, type: 'u16' } : register);
  if (typeof raw === 'string') return { ...place, scaled: undefined, names };
  const exponent = exponentOf(register, { at, list, address });
  if (exponent === undefined) return { ...place, scaled: undefined, names };
  const exactly = isScaled(register) ? exactValue(raw, register, exponent) : undefined;
  return { ...place, scaled: inUnits(raw, register, exponent), ...(exactly && { exactly }), names };
}

/** The power of ten of a line; `undefined` if its register is not in the list, or holds none. */
function exponentOf({ scaleRegister }: Register, { at, list, address }: At): number | undefined {
  if (scaleRegister === undefined) return 0;
  return powerIn(list[at + scaleRegister.address - address]);
}

const sizeOf = ({ type, count }: Register): number => (isTextType(type) ? count : wordsOf(type));
