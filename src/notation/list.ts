import { readNumber } from './number.ts';

/** One word of a list as typed, with its place in the text. */
interface Word {
  readonly text: string;
  readonly from: number;
  readonly to: number;
}

/** The items of a list, or the first word that is not one. */
export type ListReading<T> =
  | { readonly kind: 'list'; readonly items: readonly T[] }
  | { readonly kind: 'wrong'; readonly word: Word; readonly index: number };

const wordsOf = (text: string, pattern: RegExp): Word[] =>
  Array.from(text.matchAll(pattern), ({ 0: word, index }) => ({ text: word, from: index, to: index + word.length }));

function readWords<T>(words: readonly Word[], read: (text: string) => T | undefined): ListReading<T> {
  const items: T[] = [];
  for (const word of words) {
    const item = read(word.text);
    if (item === undefined) return { kind: 'wrong', word, index: items.length };
    items.push(item);
  }
  return { kind: 'list', items };
}

/** Numbers separated by blanks, commas, semicolons or line ends: `1, 0x2 3h`. A column of a spreadsheet is one too. */
export const readNumbers = (text: string): ListReading<number> => readWords(wordsOf(text, /[^\s,;]+/g), readNumber);

const FLAGS: ReadonlyMap<string, 0 | 1> = new Map(
  Object.entries({ 0: 0, 1: 1, on: 1, off: 0, true: 1, false: 0 } as const),
);

/** Bits, the lowest address first: `1011`, `1 0 1 1`, `on, off`. */
export const readBits = (text: string): ListReading<0 | 1> =>
  readWords(wordsOf(text, /[01](?![a-z])|[^\s,;01]+|[01][^\s,;]+/gi), (word) => FLAGS.get(word.toLowerCase()));
