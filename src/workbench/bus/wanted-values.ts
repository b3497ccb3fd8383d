import type { Wanted } from '../../bus/index.ts';
import { addressesOf, isBitTable, type Profile, type Register, stepOf, wordsOf } from '../../devices/index.ts';
import { isTextType } from '../../modbus/index.ts';

/** One value of a line, by its index. */
export interface LineValue {
  readonly register: Register;
  readonly index: number;
}

/** What is read for some values. */
export interface WantedValues {
  /** First that of each value, in their order; then the scale registers that they need, each once. */
  readonly wanted: readonly Wanted[];
  /** Of each value, the place of its scale register in `wanted`; `undefined` if it has none. */
  readonly powers: readonly (number | undefined)[];
}

/** What is read of a device for values of its lines. A text is read whole. */
export function wantedValues(profile: Profile, values: readonly LineValue[], unit: number): WantedValues {
  const wanted = values.map(({ register, index }) => wantedOf(profile, register, index, unit));
  const known = new Map<string, number>();
  const powers = values.map(({ register: { table, scaleRegister } }) => {
    if (scaleRegister === undefined) return undefined;
    const { address } = scaleRegister;
    const key = `${table} ${address}`;
    const place = known.get(key) ?? wanted.push({ unit, table, address, size: 1 }) - 1;
    known.set(key, place);
    return place;
  });
  return { wanted, powers };
}

function wantedOf(profile: Profile, register: Register, index: number, unit: number): Wanted {
  const { table, type, address } = register;
  const step = stepOf(register, profile);
  const size = isTextType(type) ? addressesOf(register, profile) : step;
  const width = isBitTable(table) || isTextType(type) ? 1 : wordsOf(type) / step;
  return { unit, table, address: address + index * step, size, width };
}
