import { hexDigit } from '../../modbus/index.ts';

/** The longest line of a dump that has a column of characters. */
const LONGEST = 400;
const BLANK = 0x20;
const DOT = 0x2e;

const GAP = /\s{2,}(?=\S)|\t(?=\S)/g;

/**
 * Where the column begins in which a dump shows its bytes as characters: `|....|`, or characters behind two blanks, for
 * each byte before them its own or a dot. The line's length where there is none.
 */
export function textColumn(line: string): number {
  const { length } = line;
  if (length > LONGEST) return length;
  const bar = /[|<]\s*$/.test(line.slice(-8)) ? /(?<=\s)(?:\|.{1,64}\||>.{1,64}<)\s*$/.exec(line) : null;
  if (bar !== null && shows(line, bar.index, line.slice(bar.index + 1, bar.index + bar[0].trimEnd().length - 1))) {
    return bar.index;
  }
  const last = line.trimEnd().charCodeAt(line.trimEnd().length - 1);
  for (const { index: gap } of line.matchAll(GAP)) {
    const before = 16 * hexDigit(line.charCodeAt(gap - 2)) + hexDigit(line.charCodeAt(gap - 1));
    // Most gaps are between bytes, and known by the last byte and the last character.
    if (before !== last && last !== DOT && before !== BLANK) continue;
    const column = line.slice(gap).trimStart();
    if (2 * column.length <= gap && shows(line, gap, column)) return gap;
  }
  return length;
}

/** Whether the bytes before a place are those that a column shows. Blanks at the end of the column may be lost. */
function shows(line: string, end: number, column: string): boolean {
  const trimmed = column.trimEnd();
  return showsAll(line, end, column, false) || (trimmed !== '' && showsAll(line, end, trimmed, true));
}

/** Compares from the last character back, so that most of what is no column is known at once. */
function showsAll(line: string, end: number, column: string, areLost: boolean): boolean {
  let at = end;
  let shown = column.length;
  while (shown > 0) {
    while (/[\s-]/.test(line[at - 1] ?? '')) at--;
    const high = hexDigit(line.charCodeAt(at - 2));
    const low = hexDigit(line.charCodeAt(at - 1));
    if (high < 0 || low < 0) return false;
    const value = 16 * high + low;
    at -= 2;
    if (areLost && shown === column.length && value === BLANK) continue;
    shown--;
    const character = column.charCodeAt(shown);
    if (character !== value && character !== DOT) return false;
  }
  return hexDigit(line.charCodeAt(at - 1)) < 0;
}
