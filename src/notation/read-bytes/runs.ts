import type { Token } from './token.ts';

/** Numbers in a row, with nothing between them but what separates numbers. */
export interface Run {
  readonly tokens: readonly Token[];
  readonly inParentheses: boolean;
  /** A colon behind it says that it names what follows. */
  readonly isName: boolean;
  /** A colon or an equals sign before it says that it is named: `CRC=C5CD`. */
  readonly isNamed: boolean;
  /** And that name is the checksum's. */
  readonly isChecksum: boolean;
  /** How the numbers are written: with a base, as pairs of digits or several pairs together, or otherwise. */
  readonly style: 'said' | 'pairs' | 'narrow';
  /** Bytes it holds if its digits are hexadecimal. */
  readonly bytes: number;
}

/** English words of the letters a to f alone, which are words rather than bytes beside other words. */
const ENGLISH = new Set(
  'a ad add added ace aced bad bade be bead bed bee beef cab cafe cede dab dad dead deaf decade deed deface ebb face faced facade fad fade faded fed fee feed'.split(
    ' ',
  ),
);

/** Whether digits are an English word too. */
export const isEnglish = (digits: string): boolean => ENGLISH.has(digits.toLowerCase());

/** Whether a number is a word in small letters that would not even be whole bytes, such as `add`. */
export function isProse(plain: string, { from, to, base }: Token): boolean {
  if (base !== 0 || to - from > 7 || (to - from) % 2 === 0) return false;
  const digits = plain.slice(from, to);
  return isEnglish(digits) && digits === digits.toLowerCase();
}

/** A row of numbers without the words before and behind it, where the numbers are pairs of digits. */
export function withoutProse(plain: string, row: readonly Token[]): readonly Token[] {
  const isWord = (token: Token | undefined) => token !== undefined && isProse(plain, token);
  const from = isWord(row[0]) ? 1 : 0;
  const to = row.length - (row.length > 1 && isWord(row.at(-1)) ? 1 : 0);
  if (to - from === row.length) return row;
  const inner = row.slice(from, to);
  return inner.length > 0 && !inner.some(isOdd) ? inner : row;
}

/** Whether a row of numbers begins with where they were in memory: `0x3FFB890C   01 03`. */
const isAddress = ([first, second]: readonly Token[]): boolean =>
  first !== undefined && first.base === 16 && first.to - first.from >= 6 && second?.base === 0;

const isOdd = ({ from, to }: Token) => (to - from) % 2 !== 0;

export function run(
  row: readonly Token[],
  { inParentheses, isName, isNamed, isChecksum }: Pick<Run, 'inParentheses' | 'isName' | 'isNamed' | 'isChecksum'>,
): Run {
  const tokens = isAddress(row) ? row.slice(1) : row;
  let bytes = 0;
  let narrow = 0;
  let based = 0;
  for (const token of tokens) {
    if (token.kind !== 'number') continue;
    bytes += (token.to - token.from + 1) >> 1;
    if (token.base !== 0) based++;
    else if (isOdd(token)) narrow++;
  }
  const style = based > 0 ? 'said' : narrow > 0 ? 'narrow' : 'pairs';
  return { tokens, inParentheses, isName, isNamed, isChecksum, style, bytes };
}

const WORTH = { said: 8, pairs: 2, narrow: 1 } as const;

const worth = ({ style, bytes }: Run) => WORTH[style] * bytes;

/** Most bytes of one field of a frame that is written field by field. */
const FIELD = 4;

const isBetter = (one: Run, other: Run): boolean =>
  one.isName === other.isName ? worth(one) > worth(other) : other.isName;

/** Whether two runs may be parts of one list, with words between. */
function belong(one: Run, other: Run, alone: boolean): boolean {
  const isBeside = alone || one.inParentheses === other.inParentheses;
  if (other.isName || one.style !== other.style || !isBeside) return false;
  // Field by field: `unit=01 function=03 address=0000`.
  if (one.style === 'pairs' && one.isNamed && other.isNamed) {
    return other.isChecksum || (one.bytes <= FIELD && other.bytes <= FIELD);
  }
  const bracket = one.tokens[0]?.bracket;
  return (
    one.style === 'said' ||
    (one.style === 'pairs' && (other.bytes > 1 || (bracket !== '' && bracket === other.tokens[0]?.bracket)))
  );
}

/**
 * The runs of a part of a line that are most likely its bytes: the worthiest, and others that look the same. `alone` says
 * that it has no words.
 */
export function chooseRuns(runs: readonly Run[], alone: boolean): readonly Run[] {
  let best: Run | undefined;
  for (const candidate of runs) if (best === undefined || !isBetter(best, candidate)) best = candidate;
  if (best === undefined) return [];
  const chosen = best;
  return runs.filter((candidate) => candidate === chosen || belong(chosen, candidate, alone));
}
