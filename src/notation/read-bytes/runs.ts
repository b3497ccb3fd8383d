import type { Token } from './items.ts';

/** Numbers in a row, with nothing between them but what separates numbers. */
export interface Run {
  readonly tokens: readonly Token[];
  readonly inParentheses: boolean;
  /** A colon behind it says that it names what follows. */
  readonly isName: boolean;
  /** A colon or an equals sign before it says that it is named: `CRC=C5CD`. */
  readonly isNamed: boolean;
  /** The word before it, in small letters. */
  readonly name: string;
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
const LONGEST_WORD = 7;

/** Names of what a program had received before. */
export const OLD = /^(?:old|old_data|extra|previous|prev)$/;
/** Names of a checksum. */
export const CHECKSUM = /^(?:crc|lrc|checksum|chk)/;
/** Names of what is a quantity or an address rather than bytes, where one number follows. */
const QUANTITY =
  /^(?:reg|addr|start|offset|count|qty|quant|size|len|length|no|num|unit|slave|server|dev|id$|func|fc$|code|type|timeout|port|chan|index|retr|attempt|baud|line$|row$|step|trans|tid|exception|error|level|pid|thread|version|coil|channel|stat|send_count|total|crc|lrc|checksum|calculated|computed)/;

/** Whether digits are an English word too. */
export const isEnglish = (plain: string, { from, to, base }: Token): boolean =>
  base === 0 &&
  to - from <= LONGEST_WORD &&
  !isDecimalAt(plain, from) &&
  ENGLISH.has(plain.slice(from, to).toLowerCase());

const isDecimalAt = (plain: string, at: number) => plain.charCodeAt(at) <= 0x39;

/** Whether a number is a word in small letters that would not even be whole bytes, such as `add`. */
export function isProse(plain: string, token: Token): boolean {
  const { from, to } = token;
  if ((to - from) % 2 === 0 || !isEnglish(plain, token)) return false;
  const digits = plain.slice(from, to);
  return digits === digits.toLowerCase();
}

/** Whether the name before a run says that it is a checksum. */
export const isChecksum = ({ name }: Run): boolean => CHECKSUM.test(name);

/** Whether a run is one number that its name makes a quantity. */
export const isQuantity = ({ tokens, name }: Run): boolean => tokens.length === 1 && QUANTITY.test(name);

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

/** Whether a row begins with how many follow, in a cell of its own: `8, 01 03 00 00 00 0A C5 CD`. */
function isCounted(plain: string, row: readonly Token[]): boolean {
  const [first, second, third] = row;
  if (first === undefined || second === undefined || third === undefined || first.base !== 0) return false;
  if (first.to - first.from > 3 || Number(plain.slice(first.from, first.to)) !== bytesOf(row.slice(1))) return false;
  return /[,;|\t]|\s{2}/.test(plain.slice(first.end, second.start)) && plain.slice(second.end, third.start) === ' ';
}

const bytesOf = (row: readonly Token[]): number => row.reduce((sum, { from, to }) => sum + ((to - from + 1) >> 1), 0);

const isOdd = ({ from, to }: Token) => (to - from) % 2 !== 0;

/** The run that a row of numbers is. */
export function run(
  plain: string,
  row: readonly Token[],
  said: Pick<Run, 'inParentheses' | 'isName' | 'isNamed' | 'name'>,
): Run {
  const isFirstCount = isCounted(plain, row);
  if (isFirstCount && row[0] !== undefined) row[0].isCount = true;
  const tokens = isFirstCount || isAddress(row) ? row.slice(1) : row;
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
  return { tokens, ...said, style, bytes };
}

/** Whether a row is not a list of bytes: a number with a base that is wider than one, beside narrow ones: `3 0x139A 1`. */
export const isMixed = ({ tokens, style }: Run): boolean =>
  style === 'said' &&
  tokens.some(({ base, from, to }) => base === 16 && to - from > 2) &&
  tokens.some((token) => token.base === 0 && isOdd(token));

const WORTH = { said: 8, pairs: 2, narrow: 1 } as const;

const worth = (one: Run) =>
  isMixed(one) || (isQuantity(one) && one.style === 'said') ? 1 : WORTH[one.style] * one.bytes;

/** Most bytes of one field of a frame that is written field by field. */
const FIELD = 4;

const isBetter = (one: Run, other: Run): boolean =>
  one.isName === other.isName ? worth(one) > worth(other) : other.isName;

/** Whether two runs may be parts of one list, with words between. */
function belong(one: Run, other: Run, alone: boolean): boolean {
  const isBeside = alone || one.inParentheses === other.inParentheses;
  if (other.isName || one.style !== other.style || !isBeside || isMixed(other)) return false;
  // Field by field: `unit=01 function=03 address=0000`.
  if (one.style === 'pairs' && one.isNamed && other.isNamed) {
    return isChecksum(other) || (one.bytes <= FIELD && other.bytes <= FIELD);
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
  if (runs.length <= 1) return runs;
  const now = runs.filter(({ name }) => !OLD.test(name));
  if (now.length > 0 && now.length < runs.length) return chooseRuns(now, alone);
  let best: Run | undefined;
  for (const candidate of runs) if (best === undefined || !isBetter(best, candidate)) best = candidate;
  if (best === undefined) return [];
  const chosen = best;
  return runs.filter((candidate) => candidate === chosen || belong(chosen, candidate, alone));
}
