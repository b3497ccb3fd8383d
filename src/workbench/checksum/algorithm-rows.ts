import { type Checksum, demandWhole, polynomialForms } from '../../modbus/index.ts';
import type { Searchable } from '../reference/search.ts';
import { registerHex } from './register-text.ts';

/** One line of the table: an algorithm, its value if that is known, and what a search finds it by: names, numbers, digits. */
export interface AlgorithmRow extends Searchable {
  readonly key: string;
  readonly checksum: Checksum;
  readonly name: string;
  readonly value: number | undefined;
}

/** The bytes of a value, highest first. */
export function valueBytes(value: number, width: number): Uint8Array {
  demandWhole('width', width, 1, 32);
  const size = Math.ceil(width / 8);
  return Uint8Array.from({ length: size }, (_, at) => Math.floor(value / 2 ** (8 * (size - 1 - at))) & 0xff);
}

const numberOf = (bytes: Uint8Array) => bytes.reduce((number, byte) => number * 256 + byte, 0);

export function algorithmRow(checksum: Checksum, name: string, value: number | undefined): AlgorithmRow {
  const { width, aliases, check, crc } = checksum;
  const forms = crc ? Object.values(polynomialForms(crc)) : [];
  const swapped = value === undefined ? [] : [value, numberOf(valueBytes(value, width).toReversed())];
  const numbers = [...swapped, ...forms, ...(crc ? [crc.init, crc.xorout, crc.residue] : []), check];
  // People write digits without 0x when they search for a polynomial.
  const digits = numbers.map((number) => registerHex(width, number).slice(2));
  return {
    key: checksum.name,
    checksum,
    name,
    value,
    text: [name, ...aliases, ...digits].join(' '),
    codes: [...numbers, width],
  };
}

/** What the table can be sortedRows by; each has the number or text that decides. */
export const sortKeys = {
  name: ({ name }: AlgorithmRow) => name,
  value: ({ value }: AlgorithmRow) => value ?? -1,
  width: ({ checksum }: AlgorithmRow) => checksum.width,
  poly: ({ checksum }: AlgorithmRow) => checksum.crc?.poly ?? -1,
  reversed: ({ checksum: { crc } }: AlgorithmRow) => (crc ? polynomialForms(crc).reversed : -1),
  koopman: ({ checksum: { crc } }: AlgorithmRow) => (crc ? polynomialForms(crc).koopman : -1),
  init: ({ checksum }: AlgorithmRow) => checksum.crc?.init ?? -1,
  reflected: ({ checksum }: AlgorithmRow) => Number(checksum.crc?.refin ?? -1),
  xorout: ({ checksum }: AlgorithmRow) => checksum.crc?.xorout ?? -1,
  check: ({ checksum }: AlgorithmRow) => checksum.check,
  residue: ({ checksum }: AlgorithmRow) => checksum.crc?.residue ?? -1,
} as const;

export type SortKey = keyof typeof sortKeys;

/** A column, and whether the largest comes first. */
export interface Sort {
  readonly by: SortKey;
  readonly down: boolean;
}

export function sortedRows(rows: readonly AlgorithmRow[], sort: Sort | undefined): readonly AlgorithmRow[] {
  if (sort === undefined) return rows;
  const key = sortKeys[sort.by];
  const order = (one: AlgorithmRow, other: AlgorithmRow) => {
    const [a, b] = [key(one), key(other)];
    return a < b ? -1 : a > b ? 1 : 0;
  };
  return sort.down ? rows.toSorted((one, other) => order(other, one)) : rows.toSorted(order);
}

/** As the address has it: `value`, or `-value` for the largest first. */
export const sortText = (sort: Sort | undefined): string => (sort ? `${sort.down ? '-' : ''}${sort.by}` : '');

export function readSort(text: string | undefined): Sort | undefined {
  const [, minus, by = ''] = /^(-?)(.*)$/.exec(text ?? '') ?? [];
  return Object.hasOwn(sortKeys, by) ? { by: by as SortKey, down: minus === '-' } : undefined;
}
