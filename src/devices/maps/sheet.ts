import type { TableFault } from '../fault.ts';
import type { DeviceFileFault } from '../json.ts';

/** What one file may hold, so that a few bytes of it do not stand for any number of cells. */
export interface SheetLimits {
  /** Unpacked bytes, and characters of a workbook. */
  readonly bytes: number;
  /** Cells, empty ones included. */
  readonly cells: number;
  /** Values of YAML, its aliases written out. */
  readonly nodes: number;
}
export const usualLimits: SheetLimits = { bytes: 200_000_000, cells: 4_000_000, nodes: 500_000 };

/** What a file says for all its rows. */
export const factCodes = [
  'table',
  'counting',
  'order',
  'addressBase',
  'device',
  'source',
  'unit',
  'line',
  'relative',
] as const;

/**
 * `table` is a name of a table (`holding-register`); `counting` is `zero` or `one`; `order` the file's own word for the order of bytes and
 * words; `addressBase` a whole number that is added to every address; `unit` the unit identifier, and `line` baud, data bits, parity and stop bits with commas between;
 * `relative` is `true` if addresses count from a start that the file does not say.
 */
export type FactCode = (typeof factCodes)[number];

export interface SheetRow {
  /** From 1, as the file counts: a line, a row of the worksheet, or an item, through all lists of the file; 0 is a header made from keys. */
  readonly line: number;
  readonly cells: readonly string[];
  /** A quote in this row has no partner; the cells are what stands between the delimiters. */
  readonly open?: true;
  /** Columns, from 0, whose text is that of a merged cell that begins in a row above. */
  readonly merged?: readonly number[];
}

/** One table found in a file, whatever form the file has. */
export interface Sheet {
  /** Of the worksheet, the key of the list, the heading above the table. */
  readonly name?: string;
  readonly kind: 'delimited' | 'markdown' | 'html' | 'workbook' | 'objects' | 'named';
  /** A named format: `sunspec`, `home-assistant`, … */
  readonly format?: string;
  readonly rows: readonly SheetRow[];
  /** The first row is certainly the header, because it was made from keys. */
  readonly headed?: true;
  readonly facts?: Readonly<Partial<Record<FactCode, string>>>;
}

/** Why a file, or a part of it, gave no table. `most` is in bytes, cells or levels. */
export type SheetProblem =
  | { readonly code: 'empty' }
  /** The bytes are no text and no known container; `format` is what they are, if that is known (`pdf`, `xls`). */
  | { readonly code: 'not-a-table'; readonly format?: string }
  | { readonly code: 'too-large'; readonly most: number }
  | { readonly code: 'too-many-cells'; readonly most: number }
  /** A container (`xlsx`, `gzip`) or a text (`json`, `yaml`, `toml`) is damaged; `detail` is what its reader says. */
  | { readonly code: 'unreadable'; readonly format: string; readonly detail: string; readonly line?: number }
  /** Our own file cannot be read, or a register or setting in it; `line` is its number in the list. */
  | { readonly code: 'own-file'; readonly fault: DeviceFileFault }
  | { readonly code: 'own-table'; readonly fault: TableFault; readonly line: number };

export interface SheetsReading {
  readonly sheets: readonly Sheet[];
  /** `utf-8`, `utf-16le`, `utf-16be`, `windows-1252`, or `''` where the source is text or not text at all. */
  readonly encoding: string;
  readonly problems: readonly SheetProblem[];
  /** `csv`, `tsv`, `markdown`, `html`, `xlsx`, `json`, `yaml`, `toml`, or a named format; `''` if nothing was found. */
  readonly format: string;
}
