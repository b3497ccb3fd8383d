import type { EntityTable } from '../profile.ts';
import type { AddressCell } from './address-cell.ts';
import type { CellReaders } from './cell-readers.ts';
import type { Meaning } from './meaning.ts';
import type { SheetRow } from './sheet.ts';

/** The columns of each meaning. */
export type Places = ReadonlyMap<Meaning, readonly number[]>;

/** A row that belongs to the register above it. */
export interface MapPart {
  readonly line: number;
  readonly number?: number;
  readonly name: string;
  readonly bit?: number;
}

/** A row of a table as texts by their meaning. */
export class MapRow {
  /** Rows below it that say more of it. */
  readonly parts: MapPart[] = [];

  constructor(
    readonly source: SheetRow,
    private readonly places: Places,
    readonly address: AddressCell,
    /** Of the column of printed numbers, where the table has addresses too. */
    readonly number: AddressCell | undefined,
    readonly group: string,
    /** What a heading above, or the name of the sheet, says of the table. */
    readonly table: EntityTable | undefined,
    readonly models: readonly string[],
    /** Readers for the cells of its table. */
    readonly read: CellReaders,
  ) {}

  get line(): number {
    return this.source.line;
  }

  /** A quote in it has no partner. */
  get open(): boolean {
    return this.source.open === true;
  }

  /** The first column of a meaning. */
  text(meaning: Meaning): string {
    return textAt(this.source, this.places, meaning);
  }

  /** The filled columns of a meaning. */
  texts(meaning: Meaning): readonly string[] {
    const at = this.places.get(meaning);
    if (at === undefined) return NONE;
    return at.map((place) => this.source.cells[place]?.trim() ?? '').filter((cell) => cell !== '');
  }

  /** The address as it is written. */
  get printed(): string {
    return this.text('address') || this.text('number');
  }
}

const NONE: readonly string[] = Object.freeze([]);

/** The text of the first column of a meaning in a row; empty if there is none. */
export function textAt(row: SheetRow, places: Places, meaning: Meaning): string {
  const at = places.get(meaning)?.[0];
  return at === undefined ? '' : (row.cells[at]?.trim() ?? '');
}
