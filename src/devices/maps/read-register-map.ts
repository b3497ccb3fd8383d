import type { Profile } from '../profile.ts';
import { readSerial } from '../table.ts';
import { traits } from '../traits.ts';
import type { MapFault, MapNotice, MapQuestion } from './codes.ts';
import type { MapColumn } from './meaning.ts';
import { OWN_FORMAT } from './named/index.ts';
import { readOwnTable } from './own-table.ts';
import { readMap } from './read-map.ts';
import { readSheets } from './read-sheets.ts';
import type { SheetsReading } from './sheet.ts';

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

/** The maps of a file: of our own file of several profiles one for each, of every other file one. */
export function readMapsOf(read: SheetsReading, options: RegisterMapOptions = {}): readonly RegisterMapReading[] {
  const { sheets } = read;
  if (sheets.length < 2 || sheets.some(({ format }) => format !== OWN_FORMAT)) return [readMapOf(read, options)];
  return sheets.map((sheet, at) =>
    readMapOf({ ...read, sheets: [sheet], problems: at === 0 ? read.problems : [] }, options),
  );
}

/** What `readRegisterMap` answers, of the tables of a file that was read before: other answers need no other reading. */
export function readMapOf({ sheets, problems }: SheetsReading, options: RegisterMapOptions = {}): RegisterMapReading {
  const { name = '', answers = {} } = options;
  const unread = problems.map(
    ({ code, ...data }): MapFault => ({
      ...data,
      code: code === 'empty' ? 'no-table' : code === 'too-many-cells' ? 'too-large' : code,
      rows: [],
    }),
  );
  const [sheet] = sheets;
  const ours = sheet && sheets.length === 1 ? readOwnTable(sheet, name) : undefined;
  if (ours) return { ...ours, questions: [], faults: [...unread, ...ours.faults] };
  const { registers, columns, questions, faults, notices, about } = readMap(sheets, answers, name);
  const own = traits.filter((trait) => about.traits.includes(trait));
  const serial = about.serial && readSerial(about.serial);
  const profile: Profile = {
    id: about.facts.id ?? '',
    name:
      about.facts.name || about.facts.device || name.replace(/^.*[\\/]/, '').replace(/\.\w{1,5}$/, '') || about.title,
    source: about.facts.source ?? name,
    convention: about.convention,
    ...(serial ? { serial } : {}),
    traits: own,
    registers,
    notes: about.notes,
  };
  const told = [...unread, ...faults];
  const silent: readonly MapFault[] = registers.length + told.length === 0 ? [{ code: 'no-registers', rows: [] }] : [];
  return { profile, columns, questions, faults: [...told, ...silent], notices };
}
