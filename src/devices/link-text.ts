import { readProfiles, writeProfiles } from './json.ts';
import { inOldMeaning } from './line-scale.ts';
import { conventions, entityTables, type NamedNumber, type Profile, plainRegister, type Register } from './profile.ts';

/**
 * A device as a short text for a link: JSON of `[version, name, convention, serial, traits, registers]`, with the unit behind them
 * where the line is not known. A register is a list of its address, name, table, type, unit, factor, offset, decimals, order, count, access, names and description; then the rare
 * ones: scale register, not implemented, mask, group and models. What is as in `plainRegister` is 0, or left out at the end. Its
 * id, source and notes are not in it. In version 1 a register held value × factor + offset.
 */
export function writeDevice({ name, convention, serial, unit, traits, registers }: Profile, version = VERSION): string {
  const line = serial && [serial.baud, serial.dataBits, serial.parity, serial.stopBits, serial.unit ?? -1];
  const rows = registers.map((register) => row(version === 1 ? { ...register, ...inOldMeaning(register) } : register));
  return JSON.stringify([
    version,
    name,
    conventions.indexOf(convention),
    line ?? 0,
    traits,
    rows,
    ...(unit === undefined ? [] : [unit]),
  ]);
}

const VERSION = 2;
/** The decimals of a register that shows as many as its values have, and what has no scale register. */
const ANY = -1;

function row(register: Register): readonly unknown[] {
  const { address, name, table, type, unit, decimals, order, count, access, names, description } = register;
  const { factor, offset } = register.exact ?? register;
  const cells = [
    address,
    name,
    entityTables.indexOf(table),
    type === plainRegister.type ? 0 : type,
    unit || 0,
    factor === plainRegister.factor ? 0 : factor,
    offset,
    decimals ?? ANY,
    order === plainRegister.order ? 0 : order,
    count === plainRegister.count ? 0 : count,
    access === plainRegister.access ? 0 : access,
    names.length === 0 ? 0 : names.map(({ number, name: called }) => [number, called]),
    description || 0,
    register.scaleRegister?.address ?? ANY,
    register.notImplemented ?? 0,
    register.mask ?? 0,
    register.group ?? 0,
    register.models ?? 0,
  ];
  const last = cells.findLastIndex((cell, at) => cell !== (at === DECIMALS || at === SCALE_REGISTER ? ANY : 0));
  return cells.slice(0, last + 1);
}

const DECIMALS = 7;
const SCALE_REGISTER = 13;

/** Reads what `writeDevice` of any version wrote, under an id; `undefined` for any other text, and if a register of it cannot be read. */
export function readDevice(text: string, id: string): Profile | undefined {
  const device = parsed(text);
  if (device === undefined) return undefined;
  const [version, name, convention, serial, traits, registers, ownUnit] = device;
  if ((version !== 1 && version !== VERSION) || !Array.isArray(registers) || !registers.every(Array.isArray))
    return undefined;
  const [baud, dataBits, parity, stopBits, unit] = Array.isArray(serial) ? serial : [];
  const loose = {
    id,
    version,
    name,
    source: '',
    convention: conventions[Number(convention)],
    ...(Array.isArray(serial) && {
      serial: { baud, dataBits, parity, stopBits, ...(unit !== ANY && { unit }) },
    }),
    ...(ownUnit !== undefined && { unit: ownUnit }),
    traits,
    notes: [],
    registers: registers.map(looseRegister),
  };
  // The rules of a file hold here too: what comes in a link is not trusted.
  const reading = readProfiles(writeProfiles([loose as unknown as Profile]));
  const [only] = reading.kind === 'profiles' ? reading.profiles : [];
  return only && only.faults.length === 0 ? only.profile : undefined;
}

function parsed(text: string): readonly unknown[] | undefined {
  try {
    const value: unknown = JSON.parse(text);
    return Array.isArray(value) ? value : undefined;
  } catch {
    return undefined;
  }
}

function looseRegister(cells: readonly unknown[]) {
  const [
    address,
    name,
    table,
    type,
    unit,
    factor,
    offset,
    decimals,
    order,
    count,
    access,
    names,
    description,
    ...rare
  ] = cells;
  const [scaleRegister, notImplemented, mask, group, models] = rare;
  return {
    address,
    name,
    table: entityTables[Number(table)],
    type: type || '',
    unit: unit || plainRegister.unit,
    factor: factor || plainRegister.factor,
    offset: offset || plainRegister.offset,
    ...(decimals !== undefined && decimals !== ANY && { decimals }),
    order: order || plainRegister.order,
    count: count || plainRegister.count,
    access: access || plainRegister.access,
    names: Array.isArray(names) ? names.map(namedNumber) : [],
    description: description || '',
    ...(scaleRegister !== undefined && scaleRegister !== ANY && { scaleRegister }),
    ...(notImplemented ? { notImplemented } : {}),
    ...(mask ? { mask } : {}),
    ...(group ? { group } : {}),
    ...(models ? { models } : {}),
  };
}

const namedNumber = (pair: unknown): Partial<NamedNumber> =>
  Array.isArray(pair) ? { number: pair[0] as number, name: pair[1] as string } : {};
