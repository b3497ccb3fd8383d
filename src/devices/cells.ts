import { dictionary, type Fraction, fraction, tableDigits } from '../modbus/index.ts';
import { readNumber, readOrderName, readTypeName } from '../notation/index.ts';
import { byteOrders, valueTypes, wordsOf } from './codec.ts';
import { type CellFault, type Cells, type Column, columns, rareColumns, type WrittenColumn } from './fault.ts';
import { ratioText, readRatio, scaleOf, withScale } from './line-scale.ts';
import {
  accesses,
  type Convention,
  type EntityTable,
  entityTables,
  isBitTable,
  isReadOnly,
  type NamedNumber,
  plainRegister,
  type Register,
} from './profile.ts';
import { countsValues, type Trait } from './traits.ts';

/** What decides how the cells of a line are read. */
export interface CellContext {
  readonly convention: Convention;
  readonly traits: readonly Trait[];
}

export type RegisterReading =
  | { readonly kind: 'register'; readonly register: Register }
  | { readonly kind: 'faults'; readonly faults: readonly CellFault[] };

const TABLE_NAMES: Readonly<Record<string, EntityTable>> = dictionary({
  ...Object.fromEntries(entityTables.map((table) => [table, table])),
  co: 'coil',
  '0x': 'coil',
  '0': 'coil',
  discrete: 'discrete-input',
  di: 'discrete-input',
  '1x': 'discrete-input',
  '1': 'discrete-input',
  input: 'input-register',
  ir: 'input-register',
  '3x': 'input-register',
  '3': 'input-register',
  holding: 'holding-register',
  hr: 'holding-register',
  '4x': 'holding-register',
  '4': 'holding-register',
});

const ACCESS_NAMES: Readonly<Record<string, Register['access']>> = dictionary({
  ...Object.fromEntries(accesses.map((access) => [access, access])),
  ro: 'r',
  read: 'r',
  wo: 'w',
  write: 'w',
  'r/w': 'rw',
  'read/write': 'rw',
});

const MOST_ADDRESS = 0xffff;

/** Names of bits or values as a cell has them: `0=run; 1=general enable`. A `;` or `\` in a name has a `\` before it. */
export const writeNames = (names: readonly NamedNumber[]): string =>
  names.map(({ number, name }) => `${number}=${name.replace(/[\\;]/g, '\\$&')}`).join('; ');

function readNames(text: string): readonly NamedNumber[] | undefined {
  const names: NamedNumber[] = [];
  for (const [part] of text.matchAll(/(?:\\[\s\S]|[^;\\])+/g)) {
    if (part.trim() === '') continue;
    const [, left = '', right = ''] = /^([^=:]*)[=:]([\s\S]*)$/.exec(part) ?? [];
    const number = readNumber(left);
    const name = right.replace(/\\([\s\S])/g, '$1').trim();
    if (number === undefined || !Number.isInteger(number) || name === '') return undefined;
    names.push({ number, name });
  }
  return names;
}

/** Reads one line. If it is not a register, everything that is wrong with it. */
export function readCells(cells: Cells, context: CellContext): RegisterReading {
  const faults: CellFault[] = [];
  const textOf = (column: Column) => cells[column]?.trim() ?? '';
  const has = (column: Column) => textOf(column) !== '';
  const need = (column: Column): string => {
    const text = textOf(column);
    if (text === '') faults.push({ code: 'cell-missing', column });
    return text;
  };
  const oneOf = <T extends string>(
    column: Column,
    usual: T,
    known: readonly T[],
    others?: (got: string) => T | undefined,
  ): T => {
    const got = textOf(column);
    const plain = got.toLowerCase();
    const found = known.find((each) => each.toLowerCase() === plain) ?? others?.(got);
    if (got === '' || found !== undefined) return found ?? usual;
    faults.push({ code: 'cell-unknown', column, got, known });
    return usual;
  };
  const numeric = <T>(column: Column, usual: T, read: (text: string) => T | undefined): T => {
    const got = textOf(column);
    const value = got === '' ? usual : read(got);
    if (value === undefined) faults.push({ code: 'cell-not-a-number', column, got });
    return value ?? usual;
  };
  const ratio = (column: Column, usual: number): Fraction => numeric(column, fraction(usual), readRatio);
  const whole = (column: Column, usual: number, least: number, most: number): number => {
    const value = numeric(column, usual, readNumber);
    if (value >= least && value <= most && Number.isInteger(value)) return value;
    faults.push({ code: 'cell-out-of-range', column, got: value, least, most });
    return usual;
  };

  const name = need('name');
  const place = textOf('number') === '' ? undefined : readPrinted(textOf('number'), context.convention);
  if (place?.kind === 'faults') faults.push(...place.faults);
  const printed = place?.kind === 'place' ? place : undefined;
  const table = tableOf(textOf('table'), printed?.table);
  if (table === undefined)
    faults.push(
      textOf('table') === ''
        ? { code: 'cell-missing', column: 'table' }
        : { code: 'cell-unknown', column: 'table', got: textOf('table'), known: entityTables },
    );
  if (table !== undefined && printed?.table !== undefined && printed.table !== table)
    faults.push({ code: 'number-of-other-table', got: textOf('number'), table: printed.table });
  // Whoever wrote a column of numbers misses the number, not the address.
  if (!place && textOf('address') === '') need('number' in cells ? 'number' : 'address');
  const sent = textOf('address') === '' ? undefined : whole('address', 0, 0, MOST_ADDRESS);
  const address = printed?.address ?? sent ?? 0;
  if (sent !== undefined && sent !== address)
    faults.push({ code: 'address-contradicts-number', number: textOf('number'), expected: address, got: sent });

  const bitTable = table !== undefined && isBitTable(table);
  const named = readTypeName(textOf('type'));
  const type = oneOf('type', bitTable ? 'bits' : plainRegister.type, valueTypes, () => named?.type);
  if (table !== undefined && bitTable && type !== 'bits') faults.push({ code: 'type-not-for-table', got: type, table });
  const readOnly = table !== undefined && isReadOnly(table);
  const access = oneOf(
    'access',
    readOnly ? 'r' : plainRegister.access,
    accesses,
    (got) => ACCESS_NAMES[got.toLowerCase()],
  );
  if (readOnly && access !== 'r') faults.push({ code: 'table-read-only', table });
  const count = whole('count', named?.count ?? plainRegister.count, 1, MOST_ADDRESS + 1);
  const step = bitTable || countsValues(context) ? 1 : wordsOf(type);
  if (address + count * step > MOST_ADDRESS + 1)
    faults.push({ code: 'over-the-end', address, last: address + count * step - 1 });
  const scale = { factor: ratio('factor', plainRegister.factor), offset: ratio('offset', plainRegister.offset) };
  if (scale.factor.numerator === 0n) faults.push({ code: 'factor-zero' });
  const names = readNames(textOf('names'));
  const rare = (): Partial<Register> => ({
    ...(has('scaleRegister') && { scaleRegister: { address: whole('scaleRegister', 0, 0, MOST_ADDRESS) } }),
    ...(has('notImplemented') && { notImplemented: textOf('notImplemented') }),
    ...(has('mask') && { mask: whole('mask', 1, 1, Number.MAX_SAFE_INTEGER) }),
    ...(has('group') && { group: textOf('group') }),
    ...(has('models') && { models: readModels(textOf('models')) }),
  });
  if (names === undefined) faults.push({ code: 'names-unreadable', got: textOf('names') });
  const register = {
    name,
    table: table ?? 'holding-register',
    address,
    type,
    order: oneOf('order', named?.order ?? plainRegister.order, byteOrders, readOrderName),
    count,
    ...withScale(scale),
    unit: textOf('unit'),
    ...(textOf('decimals') === '' ? {} : { decimals: whole('decimals', 0, 0, 10) }),
    access,
    names: names ?? [],
    description: textOf('description'),
    ...rare(),
  };
  return faults.length > 0 ? { kind: 'faults', faults } : { kind: 'register', register };
}

const tableOf = (text: string, printed: EntityTable | undefined): EntityTable | undefined =>
  text === ''
    ? printed
    : TABLE_NAMES[
        text
          .toLowerCase()
          .replace(/[\s_]+/g, '-')
          .replace(/s$/, '')
      ];

type Place =
  | { readonly kind: 'place'; readonly address: number; readonly table: EntityTable | undefined }
  | { readonly kind: 'faults'; readonly faults: readonly CellFault[] };

/** An address as the manual prints it: the table's digit, if it has one, and the number counted from one. */
function readPrinted(text: string, convention: Convention): Place {
  const fault = (one: CellFault): Place => ({ kind: 'faults', faults: [one] });
  const withTable = (convention === 'five-digit' && /^\d{5}$/.test(text)) || /^\d{6}$/.test(text);
  const table = withTable ? entityTables.find((each) => tableDigits[each] === text[0]) : undefined;
  const number = table === undefined ? readNumber(text) : Number(text.slice(1));
  if (number === undefined) return fault({ code: 'cell-not-a-number', column: 'number', got: text });
  const first = convention === 'zero-based' && table === undefined ? 0 : 1;
  if (!Number.isInteger(number) || number < first || number > MOST_ADDRESS + first)
    return fault({
      code: 'cell-out-of-range',
      column: 'number',
      got: number,
      least: first,
      most: MOST_ADDRESS + first,
    });
  return { kind: 'place', address: number - first, table };
}

/** Names of models as a cell has them: `X1, X2`. */
const readModels = (text: string): readonly string[] =>
  text
    .split(',')
    .map((model) => model.trim())
    .filter((model) => model !== '');

type TextOf = (register: Register) => string;

const ownTexts: Readonly<Partial<Record<WrittenColumn, TextOf>>> = {
  names: ({ names }) => writeNames(names),
  factor: (register) => ratioText(scaleOf(register).factor),
  offset: (register) => ratioText(scaleOf(register).offset),
  scaleRegister: ({ scaleRegister }) => String(scaleRegister?.address ?? ''),
  models: ({ models }) => (models ?? []).join(', '),
};

/** The texts of a register, one for each column that is written. */
export function cellsOf(register: Register): Record<WrittenColumn, string> {
  const entries = [...columns, ...rareColumns].map((column) => [
    column,
    ownTexts[column]?.(register) ?? String(register[column] ?? ''),
  ]);
  return Object.fromEntries(entries) as Record<WrittenColumn, string>;
}
