import { dictionary } from '../../modbus/index.ts';
import { textColumn } from './text-column.ts';

/** A shorter line has no column of characters. */
const SHORTEST = 5;
/** Characters that word processors, browsers and forums put in place of plain ones. */
const STAND_INS: readonly (readonly [plain: string, written: string])[] = [
  [' ', '\u00a0\u1680\u2000-\u200d\u202f\u205f\u2060\u3000\ufeff'],
  ["'", '\u2018-\u201b\u2032\u00b4'],
  ['"', '\u201c-\u201f\u2033'],
  ['-', '\u2010-\u2015\u2212'],
  ['\n', '\u0085\u2028\u2029'],
  ['<', '\u2039'],
  ['>', '\u203a'],
  [',', '\u3001'],
  ['x', '\u00d7'],
];

/** Of a full-width character and the plain one, how far their codes are apart. */
const FULL_WIDTH = 0xfee0;

const plainOf: ReadonlyMap<string, string> = new Map([
  ...STAND_INS.flatMap(([plain, written]) => charactersOf(written).map((character) => [character, plain] as const)),
  ...charactersOf('\uff01-\uff5e').map((wide) => [wide, String.fromCharCode(wide.charCodeAt(0) - FULL_WIDTH)] as const),
]);

/** The characters of a list such as `ax-z`. */
function charactersOf(list: string): string[] {
  return [...list.matchAll(/(.)(?:-(.))?/gs)].flatMap(([, first = '', last = first]) => {
    const from = first.charCodeAt(0);
    return Array.from({ length: last.charCodeAt(0) - from + 1 }, (_, i) => String.fromCharCode(from + i));
  });
}

/** What a terminal takes for a colour, with the sign before it that stands for ESC, or without: `ESC[0m`, `[1;33m`. */
const COLOUR =
  /(?:[^\P{Cc}\s]|\u241b|\^\[|\\x1b|\\u001b|\\033|\\e)\[[\d;?]{0,12}[A-Za-z]|\[\d{1,3}(?:;\d{1,3}){0,4}m/gu;
/** Tags of HTML that set letters in bold or italics, and those of forums. */
const MARKUP =
  /<\/?(?:b|i|u|s|em|strong|del|code|pre|kbd|samp|br|tt|p|div|span|font|li|td|tr|th|a)(?:\s[^<>\n]{0,80})?\/?>/gi;
const FORUM = /\[\/?(?:b|i|u|s|code|quote|color|size|font|pre)(?:=[^\]\n]{0,40})?\]/gi;
/** Characters of HTML that stand as their names. */
const NAMED = /&(lt|gt|amp|nbsp|quot|apos|#39);/gi;
const CHARACTERS: Readonly<Record<string, string>> = dictionary({
  lt: '<',
  gt: '>',
  amp: '&',
  nbsp: ' ',
  quot: '"',
  apos: "'",
  '#39': "'",
});
/** Underscores around bytes, which Markdown takes for bold or italics. */
const UNDERSCORES =
  /(?<![A-Za-z0-9_\\'"])_{1,3}(?=[0-9a-fA-F]{2}(?![A-Za-z0-9_]))|(?<=(?<![A-Za-z0-9_\\])[0-9a-fA-F]{2})_{1,3}(?![A-Za-z0-9_\\'"])/g;

const blanks = (found: string) => ' '.repeat(found.length);
/** The character that a name stands for, and blanks as long as the rest. */
const named = (found: string, name: string) => (CHARACTERS[name.toLowerCase()] ?? ' ').padEnd(found.length);

/**
 * The text with plain characters for those that stand in for them, and blanks for colours and marks of letters, one for one,
 * so that every offset holds.
 */
export function plainText(text: string): string {
  let plain = /[\u0080-\uffff]/.test(text)
    ? text.replace(/[\u0080-\uffff]/g, (character) => plainOf.get(character) ?? character)
    : text;
  if (plain.includes('[')) plain = plain.replace(COLOUR, blanks);
  if (plain.includes('<')) plain = plain.replace(MARKUP, blanks);
  if (plain.includes('[/')) plain = plain.replace(FORUM, blanks);
  if (plain.includes('&')) plain = plain.replace(NAMED, named);
  if (plain.includes('_')) plain = plain.replace(UNDERSCORES, blanks);
  return plain;
}

/** A line of the text, `[start, end)` without its column of characters; its end, of 0 to 2 characters, is over at `after`. */
export interface Line {
  readonly start: number;
  readonly end: number;
  readonly after: number;
  /** It had such a column. */
  readonly hasColumn: boolean;
}

const LF = 0x0a;
const CR = 0x0d;

/**
 * Where a character stands next behind places that are asked for in their order, or −1. It is looked for again only behind the last
 * one found: from each line of a text to a character that stands nowhere in it, time would grow with the square of its length.
 */
function nextPlaces(text: string, character: string): (from: number) => number {
  let at = text.indexOf(character);
  return (from) => {
    if (at >= 0 && at < from) at = text.indexOf(character, from);
    return at;
  };
}

/** The lines of a text; `text` is as it was given, `plain` what `plainText` made of it. */
export function linesOf(text: string, plain: string): readonly Line[] {
  const lines: Line[] = [];
  let start = 0;
  const { length } = plain;
  const [feed, back] = [nextPlaces(plain, '\n'), nextPlaces(plain, '\r')];
  while (start < length) {
    const fed = feed(start);
    const returned = back(start);
    let end = fed < 0 ? length : fed;
    if (returned >= 0 && returned < end) end = returned;
    const code = plain.charCodeAt(end);
    const after = end === length ? end : end + (code === CR && plain.charCodeAt(end + 1) === LF ? 2 : 1);
    const width = end - start < SHORTEST ? end - start : textColumn(text.slice(start, end));
    lines.push({ start, end: start + width, after, hasColumn: start + width < end });
    start = after;
  }
  return lines;
}
