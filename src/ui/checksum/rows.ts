import { type Checksum, polynomialForms } from '../../modbus/index.ts';
import { formatHex } from '../../notation/index.ts';
import { hexDigits } from './own.ts';

/** One line of the table: an algorithm, its value if that is known, and what a search finds it by. */
export interface Row {
  readonly key: string;
  readonly checksum: Checksum;
  readonly name: string;
  readonly value: number | undefined;
  /** For `finder` of the reference: what is shown, the numbers, and their digits. */
  readonly cells: readonly string[];
  readonly codes: readonly number[];
  readonly also: string;
}

/** The bytes of a value, highest first. */
export function bytesOf(value: number, width: number): Uint8Array {
  const size = Math.ceil(width / 8);
  return Uint8Array.from({ length: size }, (_, at) => Math.floor(value / 2 ** (8 * (size - 1 - at))) & 0xff);
}

const numberOf = (bytes: Uint8Array) => bytes.reduce((number, byte) => number * 256 + byte, 0);

export function rowOf(checksum: Checksum, name: string, value: number | undefined): Row {
  const { width, aliases, check, crc } = checksum;
  const forms = crc ? Object.values(polynomialForms(crc)) : [];
  const swapped = value === undefined ? [] : [value, numberOf(bytesOf(value, width).toReversed())];
  const numbers = [...swapped, ...forms, ...(crc ? [crc.init, crc.xorout, crc.residue] : []), check];
  // People write digits without 0x when they search for a polynomial.
  const digits = numbers.map((number) => formatHex(number, hexDigits(width)).slice(2));
  return {
    key: checksum.name,
    checksum,
    name,
    value,
    cells: [name, ...aliases],
    codes: [...numbers, width],
    also: digits.join(' '),
  };
}

/** What the table can be sorted by; each has the number or text that decides. */
export const sortKeys = {
  name: ({ name }: Row) => name,
  value: ({ value }: Row) => value ?? -1,
  width: ({ checksum }: Row) => checksum.width,
  poly: ({ checksum }: Row) => checksum.crc?.poly ?? -1,
  reversed: ({ checksum: { crc } }: Row) => (crc ? polynomialForms(crc).reversed : -1),
  koopman: ({ checksum: { crc } }: Row) => (crc ? polynomialForms(crc).koopman : -1),
  init: ({ checksum }: Row) => checksum.crc?.init ?? -1,
  reflected: ({ checksum }: Row) => Number(checksum.crc?.refin ?? -1),
  xorout: ({ checksum }: Row) => checksum.crc?.xorout ?? -1,
  check: ({ checksum }: Row) => checksum.check,
  residue: ({ checksum }: Row) => checksum.crc?.residue ?? -1,
} as const;

export type SortKey = keyof typeof sortKeys;

/** A column, and whether the largest comes first. */
export interface Sort {
  readonly by: SortKey;
  readonly down: boolean;
}

export function sorted(rows: readonly Row[], sort: Sort | undefined): readonly Row[] {
  if (sort === undefined) return rows;
  const key = sortKeys[sort.by];
  const order = (one: Row, other: Row) => {
    const [a, b] = [key(one), key(other)];
    return a < b ? -1 : a > b ? 1 : 0;
  };
  return sort.down ? rows.toSorted((one, other) => order(other, one)) : rows.toSorted(order);
}

/** As it stands in the address: `value`, or `-value` for the largest first. */
export const sortText = (sort: Sort | undefined): string => (sort ? `${sort.down ? '-' : ''}${sort.by}` : '');

export function readSort(text: string | null): Sort | undefined {
  const [, minus, by = ''] = /^(-?)(.*)$/.exec(text ?? '') ?? [];
  return Object.hasOwn(sortKeys, by) ? { by: by as SortKey, down: minus === '-' } : undefined;
}
