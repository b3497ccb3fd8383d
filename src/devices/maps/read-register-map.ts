import type { Profile } from '../profile.ts';
import { readSerial, readUnit } from '../table.ts';
import { traits } from '../traits.ts';
import type { MapFault, MapNotice, MapQuestion } from './codes.ts';
import type { MapColumn } from './meaning.ts';
import { OWN_FORMAT } from './named/index.ts';
import { readOwnTable } from './own-table.ts';
import { readMap } from './read-map.ts';
import { readSheets } from './read-sheets.ts';
import type { Sheet, SheetsReading } from './sheet.ts';

export interface RegisterMapOptions {
  /** The name of the file. */
  readonly name?: string;
  /** Answers by the code of their question; `column-2` is the meaning of the second column. */
  readonly answers?: Readonly<Record<string, string>>;
}

export interface RegisterMapReading {
  readonly profile: Profile;
  readonly columns: readonly MapColumn[];
  readonly questions: readonly MapQuestion[];
  /** Rows that are not imported. */
  readonly faults: readonly MapFault[];
  /** Rows that are imported with a doubt, and what was left alone. */
  readonly notices: readonly MapNotice[];
}

/**
 * Reads a register map of any maker, from a file of any form: a profile whose values are raw × factor + offset, what each column was
 * taken for, what only a person can say, and what is wrong or doubtful, by rows. Never throws.
 */
export function readRegisterMap(source: Uint8Array | string, options: RegisterMapOptions = {}): RegisterMapReading {
  return readMapOf(readSheets(source, options.name), options);
}

/** The maps of a file: of our own file of several profiles, and of a file of several devices, one for each; of every other file one. */
export function readMapsOf(read: SheetsReading, options: RegisterMapOptions = {}): readonly RegisterMapReading[] {
  const { sheets } = read;
  const isOurs = sheets.every(({ format }) => format === OWN_FORMAT);
  if (sheets.length < 2 || !(isOurs || areDevices(sheets))) return [readMapOf(read, options)];
  const each = isOurs ? sheets : sheets.map((sheet, at) => named(sheet, sheets.slice(0, at)));
  return each.map((sheet, at) =>
    readMapOf({ ...read, sheets: [sheet], problems: at === 0 ? read.problems : [] }, options),
  );
}

/** Whether each table is that of a device of its own. */
function areDevices(sheets: readonly Sheet[]): boolean {
  const keys = sheets.map(({ kind, facts }) =>
    kind === 'named' && facts?.unit ? `${facts.device ?? ''}\t${facts.unit}` : undefined,
  );
  return !keys.includes(undefined) && new Set(keys).size === sheets.length;
}

/** A table whose device has the name of one before it, with its unit behind the name. */
function named(sheet: Sheet, before: readonly Sheet[]): Sheet {
  const { device, unit } = sheet.facts ?? {};
  const isTaken = device !== undefined && before.some(({ facts }) => facts?.device === device);
  return isTaken ? { ...sheet, facts: { ...sheet.facts, device: `${device} (${unit})` } } : sheet;
}

/** What `readRegisterMap` answers, of the tables of a file that was read before: other answers need no other reading. */
export function readMapOf({ sheets, problems }: SheetsReading, options: RegisterMapOptions = {}): RegisterMapReading {
  const { name = '', answers = {} } = options;
  const unread = problems.map((problem): MapFault => {
    const { code, ...data } = problem;
    return {
      ...data,
      code: code === 'empty' ? 'no-table' : code === 'too-many-cells' ? 'too-large' : code,
      rows: problem.code === 'own-table' ? [problem.line] : [],
    };
  });
  const [sheet] = sheets;
  const ours = sheet && sheets.length === 1 ? readOwnTable(sheet, name) : undefined;
  if (ours) return { ...ours, questions: [], faults: [...unread, ...ours.faults] };
  const { registers, columns, questions, faults, notices, about } = readMap(sheets, answers, name);
  const own = traits.filter((trait) => about.traits.includes(trait));
  const unit = readUnit(about.facts.unit ?? '');
  const line = readSerial(about.serial ?? about.facts.line?.split(',') ?? []);
  const serial = line && { ...(unit === undefined ? {} : { unit }), ...line };
  const profile: Profile = {
    id: about.facts.id ?? '',
    name:
      about.facts.name || about.facts.device || name.replace(/^.*[\\/]/, '').replace(/\.\w{1,5}$/, '') || about.title,
    source: about.facts.source ?? name,
    convention: about.convention,
    ...(serial ? { serial } : unit === undefined ? {} : { unit }),
    traits: own,
    registers,
    notes: about.notes,
  };
  const told = [...unread, ...faults];
  const silent: readonly MapFault[] = registers.length + told.length === 0 ? [{ code: 'no-registers', rows: [] }] : [];
  return { profile, columns, questions, faults: [...told, ...silent], notices };
}
