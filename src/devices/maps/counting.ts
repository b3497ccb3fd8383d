import { type EntityTable, isBitTable } from '../profile.ts';
import type { AddressCell } from './address-cell.ts';
import { digitTables } from './cell-words.ts';

/** How numbers become addresses. `five-digit-zero`: 40000 is the first, as some makers count. */
export const countings = ['zero', 'one', 'five-digit', 'six-digit', 'five-digit-zero'] as const;
export type Counting = (typeof countings)[number];

/** A number of the file with the table that its row names. */
export interface CountedCell {
  readonly cell: AddressCell;
  readonly table?: EntityTable | undefined;
  /** The printed number beside it, if the row has both. */
  readonly number?: AddressCell | undefined;
}

export interface CountingChoice {
  readonly counting: Counting;
  /** What else it may be; empty if it is proved. */
  readonly options: readonly Counting[];
  /** Plain addresses that look like numbers with the digit of a table, or the other way round. */
  readonly likeNumbers: boolean;
  /** A second column of numbers proves it. */
  readonly pair?: true;
  /** Nothing proves it, but runs of addresses begin at round numbers. */
  readonly rounded?: true;
}

/** The digits of a number that may have the digit of a table in front. */
const SHAPES = { 5: /^[0134]\d{4}$/, 6: /^[0134]\d{5}$/ } as const;

export const digitsOf = ({ number, digits }: AddressCell): string => digits ?? String(number);
/** The table whose digit stands in front of five or six digits. */
export const digitTable = (cell: AddressCell): EntityTable | undefined => {
  const text = digitsOf(cell);
  return cell.digits !== undefined && (SHAPES[5].test(text) || SHAPES[6].test(text))
    ? digitTables.get(text[0] as string)
    : undefined;
};

const LIKELY_FIRST = 1000;
const LAST = 0xffff;

/** How the numbers of a file count, by evidence. `printed` says that the header calls them numbers, not addresses. */
export function countingOf(cells: readonly CountedCell[], printed: boolean): CountingChoice {
  const lettered = cells.filter(({ cell }) => cell.counted === 'mostly-one');
  const plain = cells.filter(({ cell }) => cell.counted === undefined);
  const proved = (counting: Counting): CountingChoice => ({ counting, options: [], likeNumbers: false });
  if (lettered.length > plain.length)
    return lettered.some(({ cell }) => cell.number === 0)
      ? proved('zero')
      : { counting: 'one', options: ['one', 'zero'], likeNumbers: false };
  if (plain.length === 0) return proved('zero');
  const pair = pairOf(plain);
  if (pair) return { ...proved(pair), pair: true };
  const shaped = plain.filter(({ cell, table }) => {
    const own = digitTable(cell);
    return own !== undefined && (table === undefined || table === own);
  });
  const zeroUsed = plain.some(({ cell }) => cell.number === 0);
  const like =
    shaped.length >= Math.max(1, plain.length * (printed ? 0.5 : 0.7)) &&
    !(zeroUsed && shaped.length < plain.length - 1);
  if (!like) {
    const some = shaped.some(({ cell }) => digitsOf(cell)[0] !== '1');
    if (zeroUsed) return { ...proved('zero'), likeNumbers: some };
    // Hexadecimal digits are those that are sent, if they do not begin with the first one.
    const isHex = plain.every(({ cell }) => cell.digits === undefined) && !plain.some(({ cell }) => cell.number === 1);
    if (!printed && (isHex || beginsRound(plain))) return { ...proved('zero'), rounded: true };
    return { counting: printed ? 'one' : 'zero', options: ['zero', 'one'], likeNumbers: some };
  }
  // No address is above 65535.
  const tooLarge = plain.some(({ cell }) => cell.number > LAST);
  const six = shaped.filter(({ cell }) => digitsOf(cell).length === 6).length > shaped.length / 2;
  const own: Counting = six ? 'six-digit' : 'five-digit';
  const offsets = shaped.map(({ cell }) => Number(digitsOf(cell).slice(1)));
  const first = offsets.reduce((least, offset) => Math.min(least, offset), Number.MAX_SAFE_INTEGER);
  const base = six ? own : 'five-digit-zero';
  if (first === 0 && !six) {
    // Numbers of a few hundred registers count from 40000; plain addresses are far apart.
    const far = !printed && offsets.some((offset) => offset >= LIKELY_FIRST);
    return { counting: far ? 'zero' : base, options: [base, 'zero'], likeNumbers: true };
  }
  if ((printed && first > 0 && first < LIKELY_FIRST) || (six && tooLarge && first > 0)) return proved(own);
  return {
    counting: first < LIKELY_FIRST ? own : printed ? own : 'zero',
    options: [own, 'zero', ...(six ? [] : (['five-digit-zero'] as const))],
    likeNumbers: true,
  };
}

const LEAST_RUNS = 4;
const MOST_GAP = 4;

/** Whether most runs of addresses begin at a multiple of ten, and hardly any one behind it. */
function beginsRound(cells: readonly CountedCell[]): boolean {
  const numbers = [...new Set(cells.map(({ cell }) => cell.number))].sort((a, b) => a - b);
  const starts = numbers.filter((number, at) => at === 0 || number - (numbers[at - 1] ?? 0) > MOST_GAP);
  const ending = (digit: number) => starts.filter((number) => number % 10 === digit).length;
  return starts.length >= LEAST_RUNS && ending(0) > starts.length / 2 && ending(1) * 4 < ending(0);
}

/** The counting that a second column of numbers proves: one is the other and 1, or the digit of a table in front of it. */
function pairOf(cells: readonly CountedCell[]): Counting | undefined {
  const pairs = cells.flatMap(({ cell, number }) =>
    number === undefined ? [] : [{ address: cell.number, number: number.number }],
  );
  if (pairs.length < Math.max(1, cells.length / 2)) return undefined;
  const share = (test: (pair: { address: number; number: number }) => boolean) =>
    pairs.filter(test).length / pairs.length;
  const PROOF = 0.9;
  if (share(({ address, number }) => number === address + 1) >= PROOF) return 'zero';
  if (share(({ address, number }) => number === address - 1) >= PROOF) return 'one';
  const behind = (number: number) => Number(String(number).slice(1));
  if (share(({ address, number }) => number > 9999 && behind(number) === address + 1) >= PROOF) return 'zero';
  if (share(({ address, number }) => number > 9999 && behind(number) === address) >= PROOF) return 'one';
  if (share(({ address, number }) => address > 9999 && behind(address) === number + 1) >= PROOF)
    return String(pairs[0]?.address).length === 6 ? 'six-digit' : 'five-digit';
  if (share(({ address, number }) => address > 9999 && behind(address) === number) >= PROOF) return 'five-digit-zero';
  return undefined;
}

export type Place =
  | { readonly kind: 'place'; readonly address: number; readonly table?: EntityTable | undefined; readonly odd?: true }
  | { readonly kind: 'odd' }
  | { readonly kind: 'outside' };

/** The address, from 0, that a number stands for. `strict` says that a person, or the file, has named the counting. */
export function placeOf(cell: AddressCell, counting: Counting, table: EntityTable | undefined, strict: boolean): Place {
  const placed = (address: number, own?: EntityTable, odd?: boolean): Place =>
    address < 0 || address > LAST
      ? { kind: 'outside' }
      : { kind: 'place', address, ...(own ? { table: own } : {}), ...(odd ? { odd: true } : {}) };
  if (cell.counted) {
    const fromOne = cell.counted === 'one' || (cell.counted === 'mostly-one' && counting !== 'zero');
    return placed(cell.number - (fromOne ? 1 : 0), cell.table);
  }
  if (counting === 'zero') return placed(cell.number);
  if (counting === 'one') return placed(cell.number - 1);
  const text = digitsOf(cell);
  const own = digitTable(cell);
  // A hexadecimal number among such numbers is what is sent.
  if (cell.digits === undefined) return placed(cell.number, undefined, true);
  if (own !== undefined) {
    const usual = counting === 'six-digit' ? 6 : 5;
    return placed(
      Number(text.slice(1)) - (counting === 'five-digit-zero' ? 0 : 1),
      own,
      text.length !== usual || (table !== undefined && own !== table),
    );
  }
  // A spreadsheet drops the zeros in front of the numbers of coils.
  if (text.length < 5 && cell.number > 0 && (table === 'coil' || (table === undefined && !strict)))
    return placed(cell.number - 1, table ?? 'coil', table === undefined);
  if (text.length < 5 && table !== undefined && !isBitTable(table) && !strict) return placed(cell.number, table, true);
  return { kind: 'odd' };
}
