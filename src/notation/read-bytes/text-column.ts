import { hexDigit } from '../../modbus/index.ts';

/** The longest line of a dump that has a column of characters. */
const LONGEST = 400;
/** The most blanks at the end of a line that may have been lost. */
const LOST = 16;

/**
 * Where the column begins in which a dump shows its bytes as characters: `|....|`, or characters behind two blanks, as
 * many as there are bytes before, each the byte's own or a dot. The line's length where there is none.
 */
export function textColumn(line: string): number {
  const { length } = line;
  if (length > LONGEST || length < 4) return length;
  const values: number[] = [];
  // Values of the first number, which is the offset if it is long.
  let offset = 0;
  let high = -1;
  for (let at = 0; at < length; at++) {
    const character = line[at] as string;
    const digit = hexDigit(line.charCodeAt(at));
    if (digit >= 0) {
      if (high >= 0) values.push(16 * high + digit);
      high = high >= 0 ? -1 : digit;
      continue;
    }
    if (offset === 0 && values.length > 0) {
      const isLong = values.length > 1 || (high >= 0 && values.length > 0);
      offset = isLong ? values.length : -1;
      if (isLong) high = -1;
    }
    if (high >= 0) return length;
    if (/[|>]/.test(character)) return bars(line, at, values, offset);
    if (!/[\s:-]/.test(character)) return length;
    if (character === '\t' || (character === ' ' && line[at + 1] === ' ')) {
      let rest = at;
      while (/\s/.test(line[rest] ?? '')) rest++;
      if (shows(line, rest, length, values, offset)) return at;
      at = rest - 1;
    }
  }
  return length;
}

function bars(line: string, at: number, values: readonly number[], offset: number): number {
  const close = line.trimEnd().length - 1;
  const isClosed = close > at && line[close] === (line[at] === '|' ? '|' : '<') && /\s/.test(line[at - 1] ?? '');
  return isClosed && shows(line, at + 1, close, values, offset) ? at : line.length;
}

const shows = (line: string, from: number, to: number, values: readonly number[], offset: number): boolean =>
  showsAll(line, from, to, values, 0) || (offset > 0 && showsAll(line, from, to, values, offset));

function showsAll(line: string, from: number, to: number, values: readonly number[], skip: number): boolean {
  const shown = to - from;
  const count = values.length - skip;
  if (shown <= 0 || shown > count || count - shown > LOST) return false;
  for (let i = 0; i < count; i++) {
    const value = values[skip + i] as number;
    const character = line.charCodeAt(from + i);
    if (i >= shown ? value !== 0x20 : character !== value && character !== 0x2e) return false;
  }
  return true;
}
