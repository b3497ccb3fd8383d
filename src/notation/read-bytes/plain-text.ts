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

/** The text with plain characters for those that stand in for them, one for one, so that every offset holds. */
export const plainText = (text: string): string =>
  text.replace(/[\u0080-\uffff]/g, (character) => plainOf.get(character) ?? character);

/** Calls `line` with the place of each line and where its end, of 0 to 2 characters, is over. */
export function eachLine(plain: string, line: (start: number, end: number, after: number) => void): void {
  let start = 0;
  for (const { 0: end, index } of plain.matchAll(/\r\n|[\r\n]/g)) {
    line(start, index, index + end.length);
    start = index + end.length;
  }
  if (start < plain.length) line(start, plain.length, plain.length);
}
