/** One place of two aligned rows of bytes; a byte that the other row lacks is aligned with a gap, −1. */
export interface Column {
  /** Index into the first row, or −1. */
  readonly mine: number;
  /** Index into the second row, or −1. */
  readonly theirs: number;
}

/**
 * The scores of columns. A different byte in the same field costs little, so that swapped bytes stay aligned; opening a gap
 * costs much and extending it little, so that missing or added bytes stay in one piece.
 */
const EQUAL = 3;
const SAME_FIELD = 1;
const DIFFERENT = -3;
const DIFFERENT_IN_FIELD = -1;
const OPEN = -4;
const EXTEND = -1;
const IMPOSSIBLE = -1e6;

/** How a column came about: both bytes, only the first row's, only the second's. */
const BOTH = 0;
const MINE = 1;
const THEIRS = 2;

/**
 * Aligns two rows of bytes so that as many as possible are equal (Gotoh's alignment with gaps). Each byte of either is in
 * exactly one column, in order. Time and memory are the product of the lengths: cap them first.
 * `sameField` says whether two bytes stand in the same field.
 */
export function align(
  mine: Uint8Array,
  theirs: Uint8Array,
  sameField: (mine: number, theirs: number) => boolean,
): Column[] {
  const width = theirs.length + 1;
  // For each cell and each way to end there, the way the column before it ended.
  const came = new Uint8Array(3 * width * (mine.length + 1));
  let above: Int32Array = firstRow(came, width);
  let row: Int32Array = new Int32Array(3 * width);
  for (let i = 1; i <= mine.length; i++) {
    row.fill(IMPOSSIBLE);
    for (let j = 0; j < width; j++) {
      const to = 3 * j;
      const cell = 3 * i * width + to;
      came[cell + MINE] = extend(above, to, row, to + MINE, EXTEND, OPEN);
      if (j === 0) continue;
      const worth = worthOf(mine[i - 1] === theirs[j - 1], sameField(i - 1, j - 1));
      came[cell + BOTH] = best(above, to - 3, worth, worth, worth);
      row[to + BOTH] = worth + (above[to - 3 + (came[cell + BOTH] as number)] as number);
      came[cell + THEIRS] = extend(row, to - 3, row, to + THEIRS, OPEN, EXTEND);
    }
    [above, row] = [row, above];
  }
  return walkBack(came, width, mine.length, theirs.length, lastState(above));
}

function worthOf(equal: boolean, same: boolean): number {
  if (equal) return same ? EQUAL + SAME_FIELD : EQUAL;
  return same ? DIFFERENT_IN_FIELD : DIFFERENT;
}

/** The best state of a cell to come from, given what each adds. */
function best(scores: Int32Array, at: number, both: number, mine: number, theirs: number): number {
  const fromBoth = (scores[at] as number) + both;
  const fromMine = (scores[at + MINE] as number) + mine;
  const fromTheirs = (scores[at + THEIRS] as number) + theirs;
  if (fromBoth >= fromMine) return fromBoth >= fromTheirs ? BOTH : THEIRS;
  return fromMine >= fromTheirs ? MINE : THEIRS;
}

/** Opens or extends a gap: writes its score, and returns how the column before it ended. */
function extend(from: Int32Array, at: number, row: Int32Array, to: number, mine: number, theirs: number): number {
  const state = best(from, at, OPEN, mine, theirs);
  const step = state === BOTH ? OPEN : state === MINE ? mine : theirs;
  row[to] = (from[at + state] as number) + step;
  return state;
}

function firstRow(came: Uint8Array, width: number): Int32Array {
  const row = new Int32Array(3 * width).fill(IMPOSSIBLE);
  row[BOTH] = 0;
  for (let j = 1; j < width; j++) came[3 * j + THEIRS] = extend(row, 3 * j - 3, row, 3 * j + THEIRS, OPEN, EXTEND);
  return row;
}

/** How the last column ends. A gap that may be here or earlier is put here, because most bytes are lost at the end. */
function lastState(row: Int32Array): number {
  const [both = 0, mine = 0, theirs = 0] = row.subarray(-3);
  if (mine >= both && mine >= theirs) return MINE;
  return theirs >= both ? THEIRS : BOTH;
}

function walkBack(came: Uint8Array, width: number, rows: number, columns: number, last: number): Column[] {
  const found: Column[] = [];
  let i = rows;
  let j = columns;
  let state = last;
  while (i > 0 || j > 0) {
    const before = came[3 * (i * width + j) + state] as number;
    if (state !== THEIRS) i--;
    if (state !== MINE) j--;
    found.push({ mine: state === THEIRS ? -1 : i, theirs: state === MINE ? -1 : j });
    state = before;
  }
  return found.reverse();
}
