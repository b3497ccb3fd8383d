import { dictionary, parities } from '../modbus/index.ts';
import { readNumber, wholeNumber } from '../notation/index.ts';
import { cellsOf } from './cells.ts';
import { collect, type Line } from './collect.ts';
import { type Column, columns, type LineFault, type ProfileReading, rareColumns } from './fault.ts';
import { fromOldMeaning } from './line-scale.ts';
import { type Convention, conventions, type Profile, type SerialSettings } from './profile.ts';
import { traits } from './traits.ts';

/** One row of a table of texts, with the line it begins in, counted from 1. */
export interface TableRow {
  readonly line: number;
  readonly cells: readonly string[];
  /** A quote in it was never closed, so that it swallowed what follows. */
  readonly open?: boolean;
}

const HEADERS: Readonly<Record<string, Column>> = dictionary({
  ...Object.fromEntries([...columns, ...rareColumns].map((column) => [column.toLowerCase(), column])),
  number: 'number',
  'register number': 'number',
  'modbus number': 'number',
  parameter: 'name',
  tag: 'name',
  register: 'name',
  area: 'table',
  'data type': 'type',
  datatype: 'type',
  'byte order': 'order',
  quantity: 'count',
  units: 'unit',
  'r/w': 'access',
  bits: 'names',
  values: 'names',
  comment: 'description',
});

/** Addresses that are numbers of holding registers in five digits more likely than addresses. */
const LIKE_NUMBERS = { least: 40001, most: 49999 };

const plain = (text: string) =>
  text
    .trim()
    .toLowerCase()
    .replace(/[\s_]+/g, ' ');

/**
 * Reads a profile from rows of texts: settings in rows that begin with `#` (`#version`, `#name`, `#source`, `#convention`,
 * `#serial`, `#trait`, `#note`, `#id`), a row of headers, and a row for each register. `name` is the name of the profile if no
 * row names it. A table of version 1 has factors of the old meaning, which are converted.
 */
export function readTable(rows: readonly TableRow[], name: string): ProfileReading {
  const filled = rows.filter(({ cells }) => cells.some((cell) => cell.trim() !== ''));
  const isSetting = ({ cells }: TableRow) => cells[0]?.trim().startsWith('#') ?? false;
  const start = filled.findIndex((row) => !isSetting(row));
  const settings = readSettings(start < 0 ? filled : filled.slice(0, start), name);
  const header = start < 0 ? undefined : filled[start];
  const faults: LineFault[] = [...settings.faults];
  const heads = header?.cells.map((cell) => HEADERS[plain(cell)]) ?? [];
  const line = header?.line ?? 1;
  if (!heads.includes('name') || !(heads.includes('address') || heads.includes('number'))) {
    faults.push({ code: 'header-missing', line });
    return { profile: { ...settings.profile, registers: [] }, faults };
  }
  for (const [index, head] of heads.entries()) {
    const got = header?.cells[index]?.trim() ?? '';
    if (head === undefined) {
      if (got !== '') faults.push({ code: 'column-unknown', got, line });
    } else if (heads.indexOf(head) < index) faults.push({ code: 'column-twice', column: head, line });
  }
  const lines = filled.slice(start + 1).map((row) => lineOf(row, heads));
  const profile = { ...settings.profile, convention: settings.convention ?? guessConvention(lines) };
  const { registers, faults: wrong } = collect(lines, profile);
  const holding = registers.filter(({ table }) => table === 'holding-register');
  const likeNumbers =
    !heads.includes('number') &&
    holding.length > 0 &&
    holding.every(({ address }) => address >= LIKE_NUMBERS.least && address <= LIKE_NUMBERS.most);
  if (likeNumbers) faults.push({ code: 'addresses-like-numbers', line });
  const own = settings.version === 1 ? registers.map(fromOldMeaning) : registers;
  return { profile: { ...profile, registers: own }, faults: [...faults, ...wrong] };
}

/** The versions of our table: in the first, a register held value × factor + offset. */
export const TABLE_VERSIONS = [1, 2];

/** `writeTable` of version 1 named none, but wrote these two always; a table of others has seldom both. */
const isFirst = (said: ReadonlySet<string>): boolean => said.has('#id') && said.has('#convention');

function lineOf({ line, cells, open }: TableRow, heads: readonly (Column | undefined)[]): Line {
  if (open) return { line, cells: { code: 'quote-open' } };
  const more = cells.slice(heads.length).some((cell) => cell.trim() !== '');
  if (more) return { line, cells: { code: 'too-many-cells', got: cells.length, most: heads.length } };
  const named: Partial<Record<Column, string>> = {};
  for (const [index, head] of heads.entries()) {
    if (head !== undefined && heads.indexOf(head) === index) named[head] = cells[index] ?? '';
  }
  return { line, cells: named };
}

/** The convention that a column of numbers follows if no row names it: it has as many digits as all the numbers. */
function guessConvention(lines: readonly Line[]): Convention {
  const numbers = lines.flatMap(({ cells }) => ('code' in cells || !cells.number ? [] : [cells.number.trim()]));
  if (numbers.length === 0) return 'zero-based';
  if (numbers.every((number) => /^[0134]\d{4}$/.test(number))) return 'five-digit';
  return numbers.every((number) => /^[0134]\d{5}$/.test(number)) ? 'six-digit' : 'one-based';
}

interface Settings extends ProfileReading {
  /** The convention, if a row names it. */
  readonly convention: Convention | undefined;
  readonly version: number;
}

function readSettings(rows: readonly TableRow[], name: string): Settings {
  let profile: Profile = { id: '', name, source: '', convention: 'zero-based', traits: [], registers: [], notes: [] };
  const faults: LineFault[] = [];
  let version: number | undefined;
  for (const { line, cells } of rows) {
    const [setting = '', ...rest] = cells.map((cell) => cell.trim());
    const [value = ''] = rest;
    if (setting.toLowerCase() === '#version' && TABLE_VERSIONS.includes(Number(value))) {
      version = Number(value);
      continue;
    }
    const read = settingReaders[setting.slice(1).toLowerCase()]?.(value, rest, profile);
    if (read === undefined) faults.push({ code: 'setting-unreadable', setting, got: rest.join(' ').trim(), line });
    else profile = { ...profile, ...read };
  }
  const said = new Set(rows.map(({ cells }) => cells[0]?.trim().toLowerCase() ?? ''));
  const convention = said.has('#convention') ? profile.convention : undefined;
  return { profile, faults, convention, version: version ?? (isFirst(said) ? 1 : 2) };
}

type SettingReader = (value: string, values: readonly string[], profile: Profile) => Partial<Profile> | undefined;

const settingReaders: Readonly<Record<string, SettingReader>> = dictionary({
  id: (id) => ({ id }),
  name: (name) => (name === '' ? undefined : { name }),
  source: (source) => ({ source }),
  convention: (value) => {
    const convention = conventions.find((each) => each === value.toLowerCase());
    return convention && { convention };
  },
  serial: (_value, values) => {
    const serial = readSerial(values);
    return serial && { serial };
  },
  unit: (value) => {
    const unit = readUnit(value);
    return unit === undefined ? undefined : { unit };
  },
  trait: (value, _values, { traits: before }) => {
    const trait = traits.find((each) => each === value.toLowerCase());
    return trait && { traits: [...before, trait] };
  },
  note: (value, _values, { notes }) => ({ notes: [...notes, value] }),
});

/** A unit identifier as a text; `undefined` for any other. */
export const readUnit = wholeNumber(0, 255);

/** Settings of the serial line as texts: baud, data bits, parity, stop bits, and the unit if it is known. */
export function readSerial(texts: readonly string[]): SerialSettings | undefined {
  const [baud, dataBits, stopBits] = [texts[0], texts[1], texts[3]].map((text) => readNumber(text ?? ''));
  const parity = parities.find((each) => each === texts[2]?.toLowerCase());
  const unitText = texts[4] ?? '';
  const unit = readUnit(unitText);
  const legal =
    baud !== undefined &&
    Number.isInteger(baud) &&
    baud > 0 &&
    (dataBits === 7 || dataBits === 8) &&
    parity !== undefined &&
    (stopBits === 1 || stopBits === 2) &&
    (unitText === '' || unit !== undefined);
  return legal ? { baud, dataBits, parity, stopBits, ...(unit === undefined ? {} : { unit }) } : undefined;
}

/** The rows that `readTable` reads back as this profile. */
export function writeTable(profile: Profile): string[][] {
  const { id, name, source, convention, serial, unit, registers, notes } = profile;
  const lines = registers.map(cellsOf);
  const used = [...columns, ...rareColumns.filter((column) => lines.some((cells) => cells[column] !== ''))];
  return [
    ['#version', String(TABLE_VERSIONS.at(-1))],
    ['#id', id],
    ['#name', name],
    ['#source', source],
    ['#convention', convention],
    ...(serial ? [['#serial', ...serialTexts(serial)]] : []),
    ...(unit === undefined ? [] : [['#unit', String(unit)]]),
    ...profile.traits.map((trait) => ['#trait', trait]),
    ...notes.map((note) => ['#note', note]),
    used,
    ...lines.map((cells) => used.map((column) => cells[column])),
  ];
}

const serialTexts = ({ baud, dataBits, parity, stopBits, unit }: SerialSettings): string[] =>
  [baud, dataBits, parity, stopBits, unit ?? ''].map(String);
