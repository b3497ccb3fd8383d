import { numberText } from '../loose.ts';
import type { Meaning } from '../meaning.ts';
import type { Sheet, SheetRow } from '../sheet.ts';

/** The header cells of a named format, in their order, and what they mean. */
const COLUMNS = {
  name: ['name', 'name'],
  address: ['address', 'address'],
  table: ['table', 'table'],
  functionCode: ['function code', 'function'],
  type: ['type', 'type'],
  order: ['word order', 'order'],
  registers: ['count of registers', 'words'],
  count: ['count', 'count'],
  factor: ['factor', 'factor'],
  divisor: ['divisor', 'divisor'],
  offset: ['offset', 'offset'],
  scaleRegister: ['scale factor register', 'scale-register'],
  decimals: ['decimals', 'decimals'],
  unit: ['unit', 'unit'],
  access: ['access', 'access'],
  names: ['names', 'names'],
  bit: ['bit', 'bit'],
  mask: ['mask', 'mask'],
  notImplemented: ['not implemented', 'not-implemented'],
  range: ['range', 'range'],
  group: ['group', 'group'],
  model: ['model', 'model'],
  description: ['description', 'description'],
} as const satisfies Readonly<Record<string, readonly [string, Meaning]>>;

/** What a header cell of a named format means; there is nothing to guess. */
export const namedMeanings: ReadonlyMap<string, Meaning> = new Map(Object.values(COLUMNS));

type NamedColumn = keyof typeof COLUMNS;

/** A register of a named format, as texts; a number is written out, and what is not there is left away. */
export type NamedRow = Readonly<Partial<Record<NamedColumn, string | number | undefined>>>;

export interface NamedTable {
  readonly name?: string;
  readonly facts?: Sheet['facts'];
  readonly rows: readonly NamedRow[];
}

/** A format that is known by name. It reads a value of JSON, YAML or TOML, and answers `undefined` if that is of another format. */
export interface NamedFormat {
  readonly format: string;
  readonly read: (value: unknown) => readonly NamedTable[] | undefined;
}

export const readHolding = 'holding-register';
export const readInput = 'input-register';

/** The table that a function code reads or writes. */
export function tableOfFunction(code: number | undefined): string | undefined {
  if (code === 1 || code === 5 || code === 15) return 'coil';
  if (code === 2) return 'discrete-input';
  if (code === 4) return readInput;
  return code === 3 || code === 6 || code === 16 ? readHolding : undefined;
}

/** The sheets of the tables of a named format, without columns that are empty. */
export function namedSheets(format: string, tables: readonly NamedTable[]): readonly Sheet[] {
  let item = 0;
  return tables.flatMap(({ name, facts, rows }): Sheet[] => {
    if (rows.length === 0) return [];
    const columns = (Object.keys(COLUMNS) as NamedColumn[]).filter((column) =>
      rows.some((row) => cellOf(row, column) !== ''),
    );
    const header: SheetRow = { line: 0, cells: columns.map((column) => COLUMNS[column][0]) };
    return [
      {
        ...(name === undefined ? {} : { name }),
        kind: 'named',
        format,
        rows: [header, ...rows.map((row) => ({ line: ++item, cells: columns.map((column) => cellOf(row, column)) }))],
        headed: true,
        ...(facts && Object.keys(facts).length > 0 ? { facts } : {}),
      },
    ];
  });
}

function cellOf(row: NamedRow, column: NamedColumn): string {
  const cell = row[column];
  return typeof cell === 'number' ? numberText(cell) : (cell?.trim() ?? '');
}
