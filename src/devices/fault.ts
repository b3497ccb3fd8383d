import type { EntityTable, Profile } from './profile.ts';

/** The columns of a device's table, in the order they are written. */
export const columns = [
  'name',
  'table',
  'address',
  'type',
  'order',
  'count',
  'factor',
  'offset',
  'unit',
  'decimals',
  'access',
  'names',
  'description',
] as const;

/** Columns that are written only where a line has something in them. */
export const rareColumns = ['scaleRegister', 'notImplemented', 'mask', 'group', 'models'] as const;

/** A column that is written. */
export type WrittenColumn = (typeof columns)[number] | (typeof rareColumns)[number];

/** A column that is read: `number` may stand in for `address`, as the manual prints it. */
export type Column = WrittenColumn | 'number';

/** One line of a table as texts; what is absent or blank has its usual value. */
export type Cells = Readonly<Partial<Record<Column, string>>>;

/** Why a line is not a register. */
export type CellFault =
  | { readonly code: 'cell-missing'; readonly column: Column }
  | { readonly code: 'cell-unknown'; readonly column: Column; readonly got: string; readonly known: readonly string[] }
  | { readonly code: 'cell-not-a-number'; readonly column: Column; readonly got: string }
  | {
      readonly code: 'cell-out-of-range';
      readonly column: Column;
      readonly got: number;
      readonly least: number;
      readonly most: number;
    }
  | { readonly code: 'factor-zero' }
  | { readonly code: 'over-the-end'; readonly address: number; readonly last: number }
  | { readonly code: 'number-of-other-table'; readonly got: string; readonly table: EntityTable }
  | {
      readonly code: 'address-contradicts-number';
      readonly number: string;
      readonly expected: number;
      readonly got: number;
    }
  | { readonly code: 'names-unreadable'; readonly got: string }
  | { readonly code: 'type-not-for-table'; readonly got: string; readonly table: EntityTable }
  | { readonly code: 'table-read-only'; readonly table: EntityTable };

/** What is wrong with a line, or with the whole. Those of `notices` cost no register. */
export type TableFault =
  | CellFault
  | { readonly code: 'not-a-row' }
  | { readonly code: 'name-twice'; readonly name: string; readonly first: number }
  | { readonly code: 'too-many-cells'; readonly got: number; readonly most: number }
  | { readonly code: 'quote-open' }
  | { readonly code: 'header-missing' }
  | { readonly code: 'column-unknown'; readonly got: string }
  | { readonly code: 'column-twice'; readonly column: Column }
  | { readonly code: 'setting-unreadable'; readonly setting: string; readonly got: string }
  | { readonly code: 'addresses-like-numbers' };

export const notices: ReadonlySet<TableFault['code']> = new Set([
  'column-unknown',
  'column-twice',
  'setting-unreadable',
  'addresses-like-numbers',
]);

/** A fault with its line, counted from 1: of the text, or of the list of registers. */
export type LineFault = TableFault & { readonly line: number };

/** A profile with what of it could not be read. */
export interface ProfileReading {
  readonly profile: Profile;
  readonly faults: readonly LineFault[];
}
