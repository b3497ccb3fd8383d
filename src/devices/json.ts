import { type JsonFault, readJson } from '../notation/index.ts';
import { writeNames } from './cells.ts';
import { collect, type Line } from './collect.ts';
import { type Cells, type Column, columns, type LineFault, type ProfileReading, rareColumns } from './fault.ts';
import { fromOldMeaning } from './line-scale.ts';
import { conventions, type NamedNumber, type Profile, type Register } from './profile.ts';
import { readSerial, readUnit } from './table.ts';
import { traits } from './traits.ts';

/** Why a text is not a list of profiles. */
export type DeviceFileFault =
  | JsonFault
  | { readonly code: 'not-profiles' }
  | { readonly code: 'newer-version'; readonly version: number };

export type ProfilesReading =
  | { readonly kind: 'profiles'; readonly profiles: readonly ProfileReading[] }
  | { readonly kind: 'unreadable'; readonly fault: DeviceFileFault };

const FORMAT = 'framewright-devices';
/** The version of profiles that is written. In version 1 a register held value × factor + offset. */
export const PROFILE_VERSION = 2;

type Loose = Readonly<Record<string, unknown>>;

const isObject = (value: unknown): value is Loose =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

/** The text of a file of profiles; `version` is another only of what an other page wrote. */
export const writeProfiles = (profiles: readonly Profile[], version: unknown = PROFILE_VERSION): string =>
  JSON.stringify({ format: FORMAT, version, profiles: profiles.map(written) }, null, 2);

/** What is not a profile is written as it is. */
const written = (profile: Profile): unknown =>
  Array.isArray(profile?.registers) ? { ...profile, registers: profile.registers.map(writtenRegister) } : profile;

/** A register with its factor and offset as texts where a number does not hold them. */
function writtenRegister(register: Register): unknown {
  const { exact, ...line } = Object(register) as Register;
  return exact ? { ...line, ...exact } : register;
}

/**
 * Reads what `writeProfiles` of any version wrote, and what is like it. Registers are told by their number in the list, from 1. A
 * profile may have a version of its own.
 */
export function readProfiles(text: string): ProfilesReading {
  const json = readJson(text);
  if (json.kind === 'unreadable') return json;
  const { value } = json;
  const { format, version, profiles } = isObject(value) ? value : {};
  if (format !== FORMAT || typeof version !== 'number') return { kind: 'unreadable', fault: { code: 'not-profiles' } };
  if (version > PROFILE_VERSION) return { kind: 'unreadable', fault: { code: 'newer-version', version } };
  if (!Array.isArray(profiles) || !profiles.every(isObject))
    return { kind: 'unreadable', fault: { code: 'not-profiles' } };
  return { kind: 'profiles', profiles: profiles.map((profile) => readProfile(profile, version)) };
}

const textOf = (value: unknown) =>
  typeof value === 'string' ? value.trim() : typeof value === 'number' ? String(value) : '';

function readProfile(raw: Loose, version: number): ProfileReading {
  const faults: LineFault[] = [];
  const wrong = (setting: string, got: unknown) =>
    faults.push({ code: 'setting-unreadable', setting, got: JSON.stringify(got) ?? '', line: 0 });
  const listOf = (setting: string): readonly unknown[] => {
    const value = raw[setting] ?? [];
    if (Array.isArray(value)) return value;
    wrong(setting, value);
    return [];
  };
  const convention = conventions.find((each) => each === raw['convention']);
  if (convention === undefined) wrong('convention', raw['convention']);
  if (textOf(raw['name']) === '') wrong('name', raw['name']);
  const serial = raw['serial'] === undefined ? undefined : serialOf(raw['serial']);
  if (raw['serial'] !== undefined && serial === undefined) wrong('serial', raw['serial']);
  const unit = readUnit(textOf(raw['unit']));
  if (raw['unit'] !== undefined && unit === undefined) wrong('unit', raw['unit']);
  const own = listOf('traits').filter((got) => {
    const known = traits.some((each) => each === got);
    if (!known) wrong('trait', got);
    return known;
  }) as Profile['traits'];
  const settings = {
    id: textOf(raw['id']),
    name: textOf(raw['name']),
    source: textOf(raw['source']),
    convention: convention ?? 'zero-based',
    ...(serial ? { serial } : {}),
    ...(unit === undefined ? {} : { unit }),
    traits: own,
    notes: listOf('notes').map(textOf),
    ...answersOf(raw['answers']),
  };
  const lines = listOf('registers').map(
    (register, index): Line => ({
      line: index + 1,
      cells: isObject(register) ? looseCells(register) : { code: 'not-a-row' },
    }),
  );
  const { registers, faults: badRows } = collect(lines, settings);
  const isOld = (raw['version'] ?? version) === 1;
  const today = isOld ? registers.map(fromOldMeaning) : registers;
  return { profile: { ...settings, registers: today }, faults: [...faults, ...badRows] };
}

function answersOf(raw: unknown): Pick<Profile, 'answers'> {
  if (!isObject(raw)) return {};
  return { answers: Object.fromEntries(Object.entries(raw).map(([code, answer]) => [code, textOf(answer)])) };
}

function serialOf(raw: unknown) {
  const { baud, dataBits, parity, stopBits, unit } = isObject(raw) ? raw : {};
  return readSerial([baud, dataBits, parity, stopBits, unit].map(textOf));
}

/** The values of a register as texts, so that a file of either kind is read by the same rules. */
function looseCells(register: Loose): Cells {
  const cells: Partial<Record<Column, string>> = {};
  for (const column of [...columns, ...rareColumns]) cells[column] = looseText(column, register[column]);
  return cells;
}

function looseText(column: Column, value: unknown): string {
  if (column === 'names' && Array.isArray(value)) return namesText(value);
  if (column === 'models' && Array.isArray(value)) return value.map(textOf).join(', ');
  if (column === 'scaleRegister' && isObject(value)) return textOf(value['address']);
  return textOf(value);
}

const namesText = (list: readonly unknown[]): string => (list.every(isNamed) ? writeNames(list) : JSON.stringify(list));

const isNamed = (value: unknown): value is NamedNumber =>
  isObject(value) && typeof value['number'] === 'number' && typeof value['name'] === 'string';
