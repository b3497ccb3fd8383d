import {
  type RegisterMapReading,
  readMapsOf,
  readSheets,
  type SheetRow,
  type SheetsReading,
} from '../../devices/index.ts';

/** A file or a text that is to become a profile. */
export interface MapSource {
  readonly name: string;
  readonly content: Uint8Array | string;
}

/** What a person answered, by the code of the question; `column-2` is the meaning of the second column. */
export type MapAnswers = Readonly<Record<string, string>>;

/** The maps of a file, and the first rows of each of its tables. */
export interface ReadMaps {
  readonly readings: readonly RegisterMapReading[];
  readonly rows: readonly (readonly SheetRow[])[];
}

/** What a desk in a worker is told: a file, or answers, to which it says what they come to. */
export type MapTask = ({ readonly kind: 'open' } & MapSource) | { readonly kind: 'read'; readonly answers: MapAnswers };

/** Rows of a table that are shown beside what its columns are taken for. */
const SHOWN_ROWS = 7;

/** Reads a file with any answers; its tables, which no answer changes, are read once. */
export class MapDesk {
  readonly #source: MapSource;
  #sheets: SheetsReading | undefined;

  constructor(source: MapSource) {
    this.#source = source;
  }

  read(answers: MapAnswers): ReadMaps {
    const { name, content } = this.#source;
    this.#sheets ??= readSheets(content, name);
    return {
      readings: readMapsOf(this.#sheets, { name, answers }),
      rows: this.#sheets.sheets.map(({ rows }) => rows.slice(0, SHOWN_ROWS)),
    };
  }
}
