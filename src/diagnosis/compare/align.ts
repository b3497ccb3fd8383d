/** One place of two rows of bytes laid one above the other; a byte that the other side lacks stands over a gap, −1. */
export interface Column {
  /** Index into the first row, or −1. */
  readonly mine: number;
  /** Index into the second row, or −1. */
  readonly theirs: number;
}

/**
 * What a column is worth. A different byte in the same field is cheap, so that swapped bytes stay above each other; a
 * gap is dear to open and cheap to go on with, so that what is missing or added stays in one piece.
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
type State = typeof BOTH | typeof MINE | typeof THEIRS;
const STATES: readonly State[] = [BOTH, MINE, THEIRS];

/**
 * Lays two rows of bytes one above the other so that as much as possible is equal (Gotoh's alignment with gaps). Each
 * byte of either stands in exactly one column, in order. Time and memory are the product of the lengths: cap them first.
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
  let above = firstRow(came, width);
  for (let i = 1; i <= mine.length; i++) {
    const row = new Int32Array(3 * width).fill(IMPOSSIBLE);
    for (let j = 0; j < width; j++) {
      const cell = 3 * (i * width + j);
      const put = (state: State, from: Int32Array, at: number, step: readonly number[]) => {
        const before = bestOf(from, 3 * at, step);
        came[cell + state] = before;
        row[3 * j + state] = (from[3 * at + before] as number) + (step[before] as number);
      };
      put(MINE, above, j, STEP_MINE);
      if (j === 0) continue;
      put(BOTH, above, j - 1, worthOf(mine[i - 1] === theirs[j - 1], sameField(i - 1, j - 1)));
      put(THEIRS, row, j - 1, STEP_THEIRS);
    }
    above = row;
  }
  return walkBack(came, width, mine.length, theirs.length, above);
}

/** What it adds to come from each state. */
const STEP_MINE = [OPEN, EXTEND, OPEN];
const STEP_THEIRS = [OPEN, OPEN, EXTEND];
const STEP_BOTH = [EQUAL, EQUAL + SAME_FIELD, DIFFERENT, DIFFERENT_IN_FIELD].map((worth) => [worth, worth, worth]);
const worthOf = (equal: boolean, same: boolean) => STEP_BOTH[(equal ? 0 : 2) + (same ? 1 : 0)] as readonly number[];

function firstRow(came: Uint8Array, width: number): Int32Array {
  const row = new Int32Array(3 * width).fill(IMPOSSIBLE);
  row[BOTH] = 0;
  for (let j = 1; j < width; j++) {
    row[3 * j + THEIRS] = OPEN + (j - 1) * EXTEND;
    came[3 * j + THEIRS] = j === 1 ? BOTH : THEIRS;
  }
  return row;
}

function bestOf(scores: Int32Array, at: number, step: readonly number[]): State {
  let best: State = BOTH;
  for (const state of STATES) {
    if (
      (scores[at + state] as number) + (step[state] as number) >
      (scores[at + best] as number) + (step[best] as number)
    )
      best = state;
  }
  return best;
}

function walkBack(came: Uint8Array, width: number, rows: number, columns: number, last: Int32Array): Column[] {
  const found: Column[] = [];
  let i = rows;
  let j = columns;
  let state = bestOf(last, 3 * j, [0, 0, 0]);
  while (i > 0 || j > 0) {
    const before = came[3 * (i * width + j) + state] as State;
    if (state !== THEIRS) i--;
    if (state !== MINE) j--;
    found.push({ mine: state === THEIRS ? -1 : i, theirs: state === MINE ? -1 : j });
    state = before;
  }
  return found.reverse();
}
