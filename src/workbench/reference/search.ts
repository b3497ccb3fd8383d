import { readNumber } from '../../notation/index.ts';

/** What a search looks through. */
export interface Searchable {
  /** All of its text. */
  readonly text: string;
  /** The codes it is found by, decimal or hexadecimal: one, or from one to another. */
  readonly codes: readonly (number | readonly [number, number])[];
}

/** The most digits of a code or a value, which must stand alone; a longer number is part of a frame. */
const MOST_DIGITS = 5;

type Finds = (found: Searchable) => boolean;

/** Longest search, in characters: a longer text is neither a name nor a code, and only its beginning is searched for. */
const LONGEST = 200;

/** What a search finds: what has each of its words. */
export function finder(search: string): Finds {
  const words = search
    .slice(0, LONGEST)
    .toLowerCase()
    .split(/[\s,;]+/);
  const tests = words.filter((word) => word !== '').map(wordFinder);
  return (found) => tests.every((test) => test(found));
}

function wordFinder(word: string): Finds {
  // People write FC16 and fc03.
  const bare = word.replace(/^fc(?=[0-9a-f])/, '');
  const number = readNumber(bare);
  const alone = number !== undefined && bare.length <= MOST_DIGITS;
  const pattern = new RegExp(alone ? `(?<!\\w)(?<!\\w\\.)${escaped(bare)}(?![-.]?\\w)` : escaped(bare), 'i');
  return ({ text, codes }) => (number !== undefined && hasCode(codes, number)) || pattern.test(text);
}

const escaped = (text: string) => text.replace(/[.*+?^${}()|[\]\\]/g, '\\$&');

const hasCode = (codes: Searchable['codes'], number: number) =>
  codes.some((code) => (typeof code === 'number' ? code === number : code[0] <= number && number <= code[1]));
