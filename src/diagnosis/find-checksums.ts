import { type Checksum, checksums } from '../modbus/index.ts';
import { inBothOrders, partsOf } from './checksum-match.ts';
import { TEXTS_TRIED, textOf } from './hypotheses/checksum/text.ts';

/** A checksum that has the claimed value. */
export interface ChecksumMatch {
  /** Its name among `checksums`. */
  readonly algorithm: string;
  /** The start value, if it is not the algorithm's own. */
  readonly start?: number;
  /** Whether the claimed bytes begin with the lowest byte of the value. */
  readonly lowFirst: boolean;
  /** The bytes `[from, to)` it was calculated over. */
  readonly from: number;
  readonly to: number;
  /** It was calculated over these characters, which spell the bytes, instead of over the bytes. */
  readonly text?: string;
  /** Where the value stands in the bytes, if it was not given apart. */
  readonly at?: number;
  /** How many such matches chance alone would give on average, over everything that was tried. */
  readonly chance: number;
}

/** Longer inputs are not searched. */
export const MOST_SEARCHED = 65_536;

const MODBUS = checksums.find(({ name }) => name === 'CRC-16/MODBUS') as Checksum;
/** The most likely first. */
const FIRST = ['CRC-16/MODBUS', 'LRC'];

interface Candidate {
  readonly of: Checksum;
  readonly start?: number;
}

const named: readonly Candidate[] = checksums
  .toSorted((one, other) => rank(one.name) - rank(other.name))
  .map((of) => ({ of }));
/** Start values that are set by mistake, FFFF being right; from 0000 it is CRC-16/ARC. */
const started: readonly Candidate[] = [0x00ff, 0xff00].map((start) => ({
  of: { ...MODBUS, start },
  start,
}));

function rank(name: string): number {
  const at = FIRST.indexOf(name);
  return at < 0 ? FIRST.length : at;
}

/** Bytes that may stand at the end as a checksum, the surest first. */
const WIDTHS = [4, 2, 1] as const;

/**
 * Finds the checksums that have the value `claimed`: one, two or four bytes in either order, or the last bytes if it is
 * absent. It tries all named checksums, and usual wrong start values, over all bytes and over all but a few at either end,
 * and CRC-16/MODBUS over the bytes written as text. What leaves out least comes first. It finds nothing in more than
 * `MOST_SEARCHED` bytes.
 */
export function findChecksums(bytes: Uint8Array, claimed?: Uint8Array): ChecksumMatch[] {
  if (bytes.length > MOST_SEARCHED) return [];
  if (claimed) return search(bytes, bytes.length, claimed);
  const found: ChecksumMatch[] = [];
  for (const width of WIDTHS) {
    const at = bytes.length - width;
    if (at < 1) continue;
    const matches = search(bytes, at, bytes.subarray(at)).map((match) => ({ ...match, at }));
    // Beside a certain match, one of fewer bytes is chance.
    if (matches.some(({ from, to, text }) => from === 0 && to === at && text === undefined)) return matches;
    found.push(...matches);
  }
  return found;
}

function search(bytes: Uint8Array, end: number, claimed: Uint8Array): ChecksumMatch[] {
  const width = 8 * claimed.length;
  const candidates = [...named, ...started].filter(({ of }) => of.width === width);
  // One byte is right by chance too often for many tries.
  const parts = partsOf(end, claimed.length === 1 ? 1 : undefined);
  const { highFirst, lowFirst } = inBothOrders(claimed);
  const orders = claimed.length === 1 ? 1 : 2;
  const texts = width === MODBUS.width ? TEXTS_TRIED : 0;
  const chance = (candidates.length * parts.length * orders + texts) / 2 ** width;
  const found = candidates.flatMap(({ of, start }) => {
    // A checksum that begins with zero is the same without zeros in front: the part that leaves out least is meant.
    const all = valuesOver(of, bytes, parts).filter(({ value }) => value === lowFirst || value === highFirst);
    const best = all.toSorted((one, other) => other.to - other.from - (one.to - one.from))[0];
    if (best === undefined) return [];
    const { from, to, value } = best;
    return [
      { algorithm: of.name, ...(start !== undefined && { start }), from, to, lowFirst: value === lowFirst, chance },
    ];
  });
  const text = texts > 0 && end > 0 ? textOf(bytes.subarray(0, end), lowFirst) : undefined;
  const ofText = text && {
    algorithm: MODBUS.name,
    from: 0,
    to: end,
    text: text.text,
    lowFirst: !text.swapped,
    chance,
  };
  return [...found.toSorted((one, other) => other.to - other.from - (one.to - one.from)), ...(ofText ? [ofText] : [])];
}

/** The values over all parts; those that begin at the same place are calculated in one pass. */
function valuesOver(of: Checksum, bytes: Uint8Array, parts: ReturnType<typeof partsOf>) {
  let from = -1;
  let to = -1;
  let state = of.start;
  // Of those that begin at the same place the shortest comes first.
  return parts
    .toSorted((one, other) => one.from - other.from || one.to - other.to)
    .map((part) => {
      if (part.from !== from) [from, to, state] = [part.from, part.from, of.start];
      state = of.add(state, bytes, to, part.to);
      to = part.to;
      return { ...part, value: of.value(state) };
    });
}
