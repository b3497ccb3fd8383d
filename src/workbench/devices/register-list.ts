import {
  type FoundRegister,
  isBitTable,
  lineName,
  type Profile,
  printedNumber,
  type Register,
  stepOf,
  valueName,
} from '../../devices/index.ts';

/** The name of a line, or of the one value that was found. */
export const foundName = ({ register, index }: FoundRegister): string =>
  index === undefined ? lineName(register) : valueName(register, index);

/** The number that the manual prints, and the address as sent. */
export function foundNumber(
  profile: Profile,
  { register, index = 0 }: FoundRegister,
): [printed: string, address: number] {
  const address = register.address + index * stepOf(register, profile);
  return [printedNumber(profile.convention, register.table, address), address];
}

/** What the map can be sorted by; each has the text that decides, with its numbers compared as numbers. */
const sortKeys = {
  name: (_, found) => foundName(found),
  number: (profile, found) => foundNumber(profile, found)[0],
  type: (_, { register: { type, order, table } }) => (isBitTable(table) ? table : `${type} ${order} ${table}`),
  unit: (_, { register }) => register.unit,
  access: (_, { register }) => register.access,
} as const satisfies Readonly<Record<string, (profile: Profile, found: FoundRegister) => string>>;

export type RegisterSortKey = keyof typeof sortKeys;
export const registerSortKeys = Object.keys(sortKeys) as readonly RegisterSortKey[];

/** A column, and whether the largest comes first. */
export interface RegisterSort {
  readonly by: RegisterSortKey;
  readonly down: boolean;
}

const { compare } = new Intl.Collator('en', { numeric: true });

/** Registers in the order of a column, those that are blank there last; in their own order without one. */
export function sortedRegisters(
  profile: Profile,
  found: readonly FoundRegister[],
  sort: RegisterSort | undefined,
): readonly FoundRegister[] {
  if (sort === undefined) return found;
  const key = sortKeys[sort.by];
  const keyed = found.map((each) => ({ each, text: key(profile, each) }));
  const order = (one: string, other: string) => {
    if (one === '' || other === '') return Number(one === '') - Number(other === '');
    return sort.down ? compare(other, one) : compare(one, other);
  };
  return keyed.toSorted((one, other) => order(one.text, other.text)).map(({ each }) => each);
}

/** What a map is narrowed by; blank is all. */
export interface RegisterFilter {
  readonly model: string;
  readonly group: string;
}

/** The models and groups that the registers of a device name, in the order of the map. */
export function filtersOf({ registers }: Profile): Readonly<Record<keyof RegisterFilter, readonly string[]>> {
  return {
    model: [...new Set(registers.flatMap(({ models = [] }) => models))],
    group: [...new Set(registers.flatMap(({ group = '' }) => (group === '' ? [] : [group])))],
  };
}

/** Whether a register belongs to the model and the group. One that names no model belongs to all of them. */
export const isIn = ({ models, group = '' }: Register, filter: RegisterFilter): boolean =>
  (filter.model === '' || !models?.length || models.includes(filter.model)) &&
  (filter.group === '' || group === filter.group);
