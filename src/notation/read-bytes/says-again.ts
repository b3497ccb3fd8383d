import { type Item, isNumber, Token } from './items.ts';

/** The most blanks between a number and what says it again. */
const MOST_BLANKS = 8;

const HEXADECIMAL = /\(0x([0-9a-f]{1,2})\)/iy;
const SHOWN = /\((\^?[^\s()]|[A-Z]{2,3}\d?|DEL)\)/y;

const CONTROLS =
  'NUL SOH STX ETX EOT ENQ ACK BEL BS HT LF VT FF CR SO SI DLE DC1 DC2 DC3 DC4 NAK SYN ETB CAN EM SUB ESC FS GS RS US'.split(
    ' ',
  );

/** A parenthesis that says again the number before it: where it ends, and the one number that both are. */
interface Again {
  readonly end: number;
  /** The number before it is to be left out. */
  readonly replaces: boolean;
  /** Absent if the number before it stays as it is. */
  readonly token: Token | undefined;
}

/** What the parenthesis at `at` says again, as in `255 (0xFF)`, `'A' (0x41)` and `0x73 (s)`; `undefined` if it does not. */
export function saysAgain(line: string, at: number, items: readonly Item[], base: number): Again | undefined {
  const before = items.at(-1);
  const last = isNumber(before) ? before : undefined;
  let first = at;
  while (at - first < MOST_BLANKS && /[ \t]/.test(line[first - 1] ?? '')) first--;
  HEXADECIMAL.lastIndex = at;
  const digits = HEXADECIMAL.exec(line)?.[1];
  if (digits === undefined) {
    SHOWN.lastIndex = at;
    const shown = SHOWN.exec(line)?.[1];
    const isShown =
      shown !== undefined && last !== undefined && last.end === base + first && shows(line, last, shown, base);
    return isShown ? { end: SHOWN.lastIndex, replaces: false, token: undefined } : undefined;
  }
  const end = HEXADECIMAL.lastIndex;
  const value = Number.parseInt(digits, 16);
  const isQuoted = /['"]/.test(line[first - 1] ?? '');
  const isBefore = last !== undefined && last.end >= base + (isQuoted ? first - 2 : first);
  let start: number;
  if (isQuoted && first >= 3 && line.charCodeAt(first - 2) === value) start = base + first - 3;
  else if (isBefore && says(line, last, value, base)) start = last.start;
  else return undefined;
  const token = new Token('number', start, base + end, base + end - 1 - digits.length, base + end - 1, 16);
  if (isBefore) token.comma = last.comma;
  // What is quoted may have been taken for a word.
  const replaces = isBefore || (isQuoted && before !== undefined && before.end > start);
  return { end, replaces, token };
}

function says(line: string, { start, end, from, to, base: said }: Token, value: number, base: number): boolean {
  const digits = line.slice(from - base, to - base);
  if (said === 2) return Number.parseInt(digits, 2) === value;
  if (end - start > 4) return false;
  return Number.parseInt(digits, 16) === value || (said === 0 && Number.parseInt(digits, 10) === value);
}

/** Whether a parenthesis shows the character of a byte: itself, a dot, `^A`, or its name. */
function shows(line: string, token: Token, shown: string, base: number): boolean {
  const digits = line.slice(token.from - base, token.to - base);
  if (digits.length > 3 || (token.base === 0 && digits.length === 3 && !/^\d+$/.test(digits))) return false;
  const values = [Number.parseInt(digits, 16), ...(token.base === 0 ? [Number.parseInt(digits, 10)] : [])];
  return values.some((value) => {
    if (shown === '.' || shown === String.fromCharCode(value)) return true;
    if (shown.length === 2 && shown[0] === '^') return (shown.charCodeAt(1) ^ 0x40) === value;
    return CONTROLS[value] === shown || (value === 0x7f && shown === 'DEL');
  });
}
