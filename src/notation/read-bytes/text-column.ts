import { dictionary, hexDigit } from '../../modbus/index.ts';

/** The longest line of a dump that has a column of characters. */
const LONGEST = 400;
/** Where some dumps have a blank in the middle of the column. */
const MIDDLE = 8;
const BLANK = 0x20;
const DELETE = 0x7f;

const GAP = /\s{2,}(?=\S)|\t(?=\S)|\s(?=[|>"'[({;/])/g;
/** What may stand around the column, and with nothing behind it before the column. */
const CLOSED: Readonly<Record<string, string>> = dictionary({
  '|': '|',
  '>': '<',
  '"': '"',
  "'": "'",
  '[': ']',
  '(': ')',
  '{': '}',
});
const BEFORE = /^[|;/#]\s?/;
/** Characters with blanks between. */
const SPACED = /^(?:\S )+\S?\s*$/;
/** What may stand for a byte that has no character. */
const STAND_IN = /[.·•?_□■▯\ufffd\s\u0080-\uffff]/;

/**
 * Where the column begins in which a dump shows its bytes as characters: `|....|`, or characters behind two blanks, for
 * each byte before them its own or one that stands for it. The line's length if it has no such column.
 */
export function textColumn(line: string): number {
  const { length } = line;
  if (length > LONGEST || !/\s[\s|>"'[(;/]|\t/.test(line)) return length;
  for (const { index, 0: gap } of line.matchAll(GAP)) {
    const bytes = bytesBefore(line, index);
    if (bytes.length === 0) continue;
    const at = index + gap.length;
    const opener = line[at];
    const close = CLOSED[opener ?? ''];
    const end = close === undefined ? -1 : line.lastIndexOf(close);
    if (end > at && line.slice(end + 1).trim() === '' && showsSome(bytes, line.slice(at + 1, end))) return index;
    const before = BEFORE.exec(line.slice(at, at + 2))?.[0];
    if (before !== undefined && showsSome(bytes, line.slice(at + before.length))) return index;
    // Blanks that begin the column cannot be told from those before it.
    for (let from = at; from > index && at - from < MIDDLE; from--) {
      if (showsSome(bytes, line.slice(from))) return index;
    }
  }
  return length;
}

/** The bytes of the row of hexadecimal pairs that ends at a place, and whether a token begins at each. */
interface Pair {
  readonly value: number;
  readonly begins: boolean;
}

function bytesBefore(line: string, end: number): readonly Pair[] {
  const pairs: Pair[] = [];
  let at = end;
  for (;;) {
    const high = hexDigit(line.charCodeAt(at - 2));
    const low = hexDigit(line.charCodeAt(at - 1));
    if (at < 2 || high < 0 || low < 0) break;
    at -= 2;
    const before = line.charCodeAt(at - 1);
    const isInside = at > 0 && hexDigit(before) >= 0;
    // A number with an odd number of digits is not a row of bytes.
    if (!isInside && at > 0 && /[^\s\-:|[(]/.test(line[at - 1] as string)) break;
    pairs.push({ value: 16 * high + low, begins: !isInside });
    while (at > 0 && /[\s-]/.test(line[at - 1] as string)) at--;
  }
  return pairs.reverse();
}

/** Whether a column shows these bytes, all of them or all behind an offset, which is one number. */
function showsSome(bytes: readonly Pair[], column: string): boolean {
  if (SPACED.test(column) && showsSome(bytes, column.replace(/(\S) /g, '$1'))) return true;
  const { length } = column.trimEnd();
  const first = bytes.findIndex(({ begins }) => begins);
  const second = bytes.findIndex(({ begins }, index) => begins && index > first);
  return [first, second].some((from) => {
    const count = bytes.length - from;
    // The column has a character for each; one more with a blank in the middle, fewer where blanks at its end are lost.
    if (from < 0 || count + 1 < length || count > column.length + MIDDLE) return false;
    return shows(bytes, from, column, -1) || (count > MIDDLE && shows(bytes, from, column, MIDDLE));
  });
}

/** Whether each character shows its byte; at `middle` one may be a blank that shows none. */
function shows(bytes: readonly Pair[], from: number, column: string, middle: number): boolean {
  const { length } = column.trimEnd();
  let at = 0;
  let own = 0;
  for (let index = from; index < bytes.length; index++) {
    if (index - from === middle) {
      if (at < length && column[at] !== ' ') return false;
      at++;
    }
    const { value } = bytes[index] as Pair;
    const code = at < length ? column.charCodeAt(at) : BLANK;
    if (code === value) own++;
    else if (code !== 0x2e) {
      const isShowable = value >= BLANK && value < DELETE;
      if (isShowable || !(at < length ? STAND_IN.test(column[at] as string) : value < BLANK || value >= DELETE))
        return false;
    }
    at++;
  }
  // Nothing but blanks may follow, and something must be shown.
  return at >= length && (own > 0 || length > 0) && column.trim() !== '';
}
