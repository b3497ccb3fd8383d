import { dictionary, type FieldKind, hexDigits, inPairs, tableDigits } from '../../modbus/index.ts';
import type { Cause, Values, Whose } from './cause.ts';
import { checkAt, type Side } from './side.ts';

/** The bytes of one field in both frames, with their values. */
export interface Pair {
  readonly name: string;
  readonly kind: FieldKind;
  readonly mine: Half;
  readonly theirs: Half;
  /** Whether all bytes before the field are the same in both frames. */
  readonly sameBefore: boolean;
}

export interface Half {
  readonly side: Side;
  readonly from: number;
  readonly to: number;
  /** The bytes of the field; in ASCII those that its digits make. */
  readonly binary: Uint8Array;
}

type Rule = (pair: Pair) => Cause | undefined;
type NumberRule = (values: Values, pair: Pair) => Cause | undefined;

/** Why a field of both frames differs: the answer of the first rule that has one. */
export function likelyCause(pair: Pair): Cause {
  const rules: readonly Rule[] = pair.kind === 'checksum' ? [checksum, length] : [spelling, length, order, number];
  for (const rule of rules) {
    const cause = rule(pair);
    if (cause !== undefined) return cause;
  }
  return content(pair);
}

/** The 16-bit number or the byte that a field holds. */
export function numberOf(kind: FieldKind, binary: Uint8Array): number | undefined {
  const [first, second] = binary;
  if (LISTS.has(kind) || first === undefined || binary.length > 2) return undefined;
  return second === undefined ? first : first * 256 + second;
}

const LISTS: ReadonlySet<FieldKind> = new Set(['registers', 'bits', 'bytes', 'list', 'groups', 'checksum', 'rest']);

const checksum: Rule = ({ mine, theirs, sameBefore }) => {
  const own = checkAt(mine.side, mine.from, mine.to);
  const other = checkAt(theirs.side, theirs.from, theirs.to);
  if (other === undefined) return undefined;
  if (other.got === other.expected) {
    return own !== undefined && own.got !== own.expected
      ? { code: 'my-checksum-wrong', ...own }
      : { code: 'checksum-follows' };
  }
  if (other.algorithm === 'crc' && other.expected === swapped(other.got)) return { code: 'checksum-swapped', ...other };
  return { code: sameBefore ? 'checksum-alone-wrong' : 'checksum-wrong', ...other };
};

const swapped = (word: number) => ((word & 0xff) << 8) | (word >>> 8);

/** The same bytes, written with other characters. */
const spelling: Rule = ({ mine, theirs }) =>
  mine.binary.length > 0 && mine.side.reading.transport === 'ascii' && isSame(mine.binary, theirs.binary)
    ? { code: 'lower-case-digits' }
    : undefined;

const length: Rule = ({ kind, mine, theirs }) => {
  const more = theirs.binary.length - mine.binary.length;
  if (more === 0) return undefined;
  const whole = kind !== 'registers' || more % 2 === 0;
  if (LISTS.has(kind) && kind !== 'checksum' && whole) {
    return { code: 'length-differs', mine: mine.binary.length, theirs: theirs.binary.length };
  }
  return more < 0 ? { code: 'bytes-missing', bytes: -more } : { code: 'bytes-inserted', bytes: more };
};

/** The orders in which devices send the bytes of a value: the place of byte `at`. */
const ORDERS = [
  { code: 'bytes-swapped', group: 2, other: (at: number) => at ^ 1 },
  { code: 'words-swapped', group: 4, other: (at: number) => at ^ 2 },
  { code: 'order-reversed', group: 4, other: (at: number) => at ^ 3 },
] as const;

const order: Rule = ({ kind, mine: { binary: mine }, theirs: { binary: theirs } }) => {
  if (kind === 'bits' && theirs.every((byte, at) => byte === reversed(mine[at] as number))) {
    return { code: 'bits-reversed' };
  }
  if (!inPairs.has(kind)) return undefined;
  const found = ORDERS.find(
    ({ group, other }) =>
      mine.length % group === 0 && mine.length > 0 && theirs.every((byte, at) => byte === mine[other(at)]),
  );
  return found && { code: found.code };
};

function reversed(byte: number): number {
  let turned = 0;
  for (let bit = 0; bit < 8; bit++) turned |= ((byte >> bit) & 1) << (7 - bit);
  return turned;
}

const number: Rule = (pair) => {
  const mine = numberOf(pair.kind, pair.mine.binary);
  const theirs = numberOf(pair.kind, pair.theirs.binary);
  if (mine === undefined || theirs === undefined) return undefined;
  const values = { mine, theirs };
  const rules = [BY_NAME[pair.name], ...(BY_KIND[pair.kind] ?? [asHex])];
  for (const rule of rules) {
    const cause = rule?.(values, pair);
    if (cause !== undefined) return cause;
  }
  return { code: 'value-differs', ...values };
};

const asHex: NumberRule = ({ mine, theirs }) => {
  if (hexDigits(theirs, 1) === String(mine)) return { code: 'decimal-as-hex', mine, theirs, hex: 'theirs' };
  if (hexDigits(mine, 1) === String(theirs)) return { code: 'decimal-as-hex', mine, theirs, hex: 'mine' };
  return undefined;
};

/** First numbers of the tables less one: 10001, 30001 and 40001 are address 0 (PI ch. 2). */
const BASES = [tableDigits['discrete-input'], tableDigits['input-register'], tableDigits['holding-register']].map(
  (digit) => 10000 * Number(digit),
);

const entity: NumberRule = ({ mine, theirs }) => {
  const by = Math.abs(theirs - mine);
  // Some add 40000, some 40001.
  if (!BASES.some((base) => by === base || by === base + 1)) return undefined;
  const whose: Whose = theirs > mine ? 'theirs' : 'mine';
  return { code: 'entity-number', whose, number: Math.max(mine, theirs), address: Math.min(mine, theirs) };
};

const offByOne: NumberRule = (values) =>
  Math.abs(values.theirs - values.mine) === 1 ? { code: 'address-off-by-one', ...values } : undefined;

const doubled: NumberRule = ({ mine, theirs }, { mine: { side } }) => {
  const group = side.reading.description?.group;
  const whose: Whose = theirs > mine ? 'theirs' : 'mine';
  const [less, more] = theirs > mine ? [mine, theirs] : [theirs, mine];
  if (less === 0) return undefined;
  if (group === 'registers' && more === 2 * less) return { code: 'quantity-doubled', mine, theirs, whose };
  // Bits: the smaller number counts bytes.
  const counted: Whose = whose === 'theirs' ? 'mine' : 'theirs';
  return group === 'bits' && more > 8 && less === Math.ceil(more / 8)
    ? { code: 'quantity-of-bytes', mine, theirs, whose: counted }
    : undefined;
};

/** Function codes that are confused with each other: of two tables, and for one item or several. */
const MISTAKEN = [
  { code: 'other-table', pairs: ['1 2', '3 4', '1 3', '2 4'] },
  { code: 'single-or-multiple', pairs: ['5 15', '6 16'] },
] as const;

const functions: NumberRule = (values) => {
  const { mine, theirs } = values;
  const both = `${Math.min(mine, theirs)} ${Math.max(mine, theirs)}`;
  const found = MISTAKEN.find(({ pairs }) => pairs.some((pair) => pair === both));
  return found && { code: found.code, ...values };
};

const coil: NumberRule = ({ mine, theirs }) => {
  if (!isCoil(theirs)) return { code: 'coil-value-illegal', got: theirs };
  return isCoil(mine) ? { code: 'coil-opposite', theirs } : undefined;
};

const isCoil = (value: number) => value === 0xff00 || value === 0;

/** A count or length compared with what it counts in its own frame; if it is right there, what it counts differs. */
const counted: NumberRule = (values, { theirs: { side, from } }) => {
  for (const problem of side.reading.problems) {
    if (problem.span.from + side.start !== from || !('expected' in problem)) continue;
    const { got, expected } = problem;
    return { code: expected === 2 * got ? 'count-of-registers' : 'count-wrong', got, expected };
  }
  return { code: 'count-follows', ...values };
};

const always =
  (code: 'unit-differs' | 'address-differs' | 'quantity-differs' | 'function-differs'): NumberRule =>
  (values) => ({ code, ...values });

/** What may be wrong with a number, by the kind of its field, the most telling first. */
const BY_KIND: Partial<Record<FieldKind, readonly NumberRule[]>> = {
  unit: [asHex, always('unit-differs')],
  function: [functions, asHex, always('function-differs')],
  address: [offByOne, entity, asHex, always('address-differs')],
  quantity: [doubled, asHex, always('quantity-differs')],
  count: [counted],
  flag: [coil],
};

/** The same by the name of the field, if its kind does not tell. */
const BY_NAME: Readonly<Record<string, NumberRule | undefined>> = dictionary({
  transactionId: (values) => ({ code: 'transaction-differs', ...values }),
  protocolId: (values) => ({ code: 'protocol-differs', ...values }),
  length: counted,
});

/** How many items differ, of a list or of bytes whose order tells nothing. */
function content({ kind, mine: { binary: mine }, theirs: { binary: theirs } }: Pair): Cause {
  const each = kind === 'registers' ? 2 : 1;
  const of = Math.ceil(Math.max(mine.length, theirs.length) / each);
  const different = Array.from({ length: of }, (_, item) => item * each).filter((at) =>
    [...Array(each).keys()].some((byte) => mine[at + byte] !== theirs[at + byte]),
  ).length;
  return { code: 'content-differs', different, of };
}

const isSame = (a: Uint8Array, b: Uint8Array) => a.length === b.length && a.every((byte, at) => byte === b[at]);
