import { readNumber } from '../../notation/index.ts';
import { type Entry, textOf } from './entry.tsx';

/** A number of at most so many digits is a code or a value, and must stand alone; a longer one is part of a frame. */
const MOST_DIGITS = 5;

type Finds = (entry: Entry) => boolean;

/** What a search finds: the entries that have each of its words. */
export function finder(search: string): Finds {
  const words = search.toLowerCase().split(/[\s,;]+/);
  const tests = words.filter((word) => word !== '').map(wordFinder);
  return (entry) => tests.every((test) => test(entry));
}

function wordFinder(word: string): Finds {
  // People write FC16 and fc03.
  const bare = word.replace(/^fc(?=[0-9a-f])/, '');
  const number = readNumber(bare);
  const alone = number !== undefined && bare.length <= MOST_DIGITS;
  const pattern = new RegExp(alone ? `(?<!\\w)(?<!\\w\\.)${escaped(bare)}(?![-.]?\\w)` : escaped(bare));
  return (entry) => (number !== undefined && hasCode(entry, number)) || pattern.test(haystack(entry));
}

const escaped = (text: string) => text.replace(/[.*+?^${}()|[\]\\]/g, '\\$&');

const hasCode = ({ codes }: Entry, number: number) =>
  codes.some((code) => (typeof code === 'number' ? code === number : code[0] <= number && number <= code[1]));

const haystacks = new WeakMap<Entry, string>();

function haystack(entry: Entry): string {
  const known = haystacks.get(entry);
  if (known !== undefined) return known;
  const text = [...entry.cells.map(textOf), entry.also ?? ''].join(' ').toLowerCase();
  haystacks.set(entry, text);
  return text;
}
