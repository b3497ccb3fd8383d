import { labelOf } from './label-of.ts';
import type { Line } from './plain-text.ts';
import { COMPARED } from './sides.ts';
import type { ChunkLabel, TextRange } from './types.ts';

/** A string of bytes, or several that a program joins. */
export interface StringPiece extends TextRange {
  readonly parts: readonly StringPart[];
  readonly label: ChunkLabel;
  /** It goes on with the piece before. */
  readonly continued: boolean;
  /** Nothing else looks like this: in quotes, with a number as an escape or a `b` before. */
  readonly isSure: boolean;
  readonly line: Line;
}

/** What stands between the quotes, and how often it is repeated: `b'\x00' * 2`. */
export interface StringPart extends TextRange {
  readonly times: number;
  /** Where that is said, if it is said behind. */
  readonly repeat: TextRange | undefined;
}

interface Quoted extends StringPart {
  /** With its quotes, its `b` and how often it is repeated. */
  readonly outer: TextRange;
  readonly hasEscapes: boolean;
  readonly isBytes: boolean;
}

/** How much of a line before a string, in characters, is looked at. */
const MOST = 100;
/** The most repetitions that are read. */
const REPEATED = 256;

/** The first escape of a string without quotes: a number, or a name with nothing between it and the next. */
const BEGIN = /\\(?:x[0-9a-f]|u[0-9a-f{]|\d|[A-F][0-9A-F]|[abtnvfres](?=\\))/i;
/** The words between escapes of a text without quotes. */
const WORDS = /[)\]},;:]?\s(?:[A-Za-z]{2,20}[:=]?\s){1,6}(?=\\)/g;
const NUMERIC = /\\(?:x[0-9a-f]|u00|[0-7])/i;
/** Digits of hexadecimal in quotes say bytes by themselves. */
const HEX_DIGITS = /^\s*(?:[0-9a-f]{2}\s?)+$/i;
const HEX_LENGTH = 8;
const HEX_STRING = /b['"](?:[0-9a-f]{2}){4,}['"]/i;
/** What a program puts between strings that it joins. */
const JOINED = /^\s*(?:\+|\\)?\s*$/;
const COMMENT = /\s(?:#|\/\/).*$/;

/** Whether the text has escapes, or is a string of bytes as Python prints it. */
export const hasEscapes = (plain: string): boolean =>
  /\\x[0-9a-f]|\\u00[0-9a-f]{2}|\\[0-9A-F]{2}[^\\]{0,2}\\|\\[0-7]{1,3}\\/i.test(plain) ||
  /(?:^|[\s=(,[:>])b(?:'[^'\n]|"[^"\n])/.test(plain);

/** The strings of a text that hold bytes, in order. */
export function stringsOf(plain: string, lines: readonly Line[]): readonly StringPiece[] {
  if (!hasEscapes(plain)) return [];
  const pieces: StringPiece[] = [];
  // Where some strings are digits of hexadecimal, short ones are too.
  const digits = HEX_STRING.test(plain) ? 2 : HEX_LENGTH;
  const leads = new Set<string>();
  let endsOpen = false;
  for (const line of lines) {
    const text = plain.slice(line.start, line.end);
    const found = piecesOf(text, leads, digits);
    for (const [index, { start, end, parts, isSure, isQuoted }] of found.entries()) {
      const before = text.slice(index === 0 ? 0 : found[index - 1]?.end, start);
      const isFirst = index === 0 && JOINED.test(before);
      if (isSure && index === 0) leads.add(leadOf(text, start));
      pieces.push({
        start: line.start + start,
        end: line.start + end,
        parts: parts.map((part) => shifted(part, line.start)),
        // Without quotes, the words between escapes are those of one sentence.
        label: index > 0 && (!isQuoted || COMPARED.test(text.slice(0, start))) ? {} : labelOf(before),
        continued: isFirst && endsOpen,
        isSure,
        line,
      });
    }
    const last = found.at(-1);
    endsOpen = last?.isQuoted === true && JOINED.test(text.slice(last.end).replace(COMMENT, ''));
  }
  return pieces;
}

const leadOf = (text: string, end: number) => text.slice(Math.max(0, end - MOST), end).replace(/\d+/g, '0');

const shifted = ({ start, end, times, repeat }: StringPart, by: number): StringPart => ({
  start: start + by,
  end: end + by,
  times,
  repeat: repeat && { start: repeat.start + by, end: repeat.end + by },
});

type Found = TextRange & Pick<StringPiece, 'parts' | 'isSure'> & { readonly isQuoted: boolean };

/** The places in a line that hold bytes: its strings that have escapes, or else all from the first escape to the last. */
function piecesOf(line: string, leads: ReadonlySet<string>, digits: number): readonly Found[] {
  if (!line.includes('\\') && !/['"]/.test(line)) return [];
  const quoted = quotedIn(line, digits);
  const strings = quoted.filter(
    ({ hasEscapes: has, isBytes, outer }) => has || isBytes || leads.has(leadOf(line, outer.start)),
  );
  if (strings.length > 0) return joined(line, strings);
  const first = line.search(BEGIN);
  // What has another backslash before it is the path of a file.
  if (first < 0 || first > line.indexOf('\\')) return [];
  let start = first;
  while (start > 0 && /[^\s:=>(,[{<"']/.test(line[start - 1] as string)) start--;
  return unquoted(line, { start, end: endOf(line, start) });
}

/** Strings with nothing between them that parts them are one piece. */
function joined(line: string, strings: readonly Quoted[]): readonly Found[] {
  const pieces: (Found & { readonly parts: StringPart[] })[] = [];
  for (const string of strings) {
    const isSure = string.isBytes || NUMERIC.test(line.slice(string.start, string.end));
    const last = pieces.at(-1);
    if (last !== undefined && JOINED.test(line.slice(last.end, string.outer.start))) {
      last.parts.push(string);
      pieces[pieces.length - 1] = { ...last, end: string.outer.end, isSure: last.isSure || isSure };
    } else pieces.push({ ...string.outer, parts: [string], isSure, isQuoted: true });
  }
  return pieces;
}

/** A row of escapes without quotes, in parts where words stand between them. */
function unquoted(line: string, { start, end }: TextRange): readonly Found[] {
  const text = line.slice(start, end);
  const pieces: Found[] = [];
  let from = 0;
  const add = (to: number) => {
    const part = { start: start + from, end: start + to, times: 1, repeat: undefined };
    const isSure = (text.slice(from, to).match(/\\x[0-9a-f]{2}/gi) ?? []).length > 1;
    if (to > from) pieces.push({ start: part.start, end: part.end, parts: [part], isSure, isQuoted: false });
  };
  for (const { index, 0: words } of text.matchAll(WORDS)) {
    add(index);
    from = index + words.length;
  }
  // A bracket that was opened before is closed behind.
  const closed = /[)\]}]+$/.exec(text)?.[0] ?? '';
  add(text.length - (/[([{][^)\]}]*$/.test(line.slice(0, start)) ? closed.length : 0));
  return pieces;
}

/** How far a string without quotes goes: to the end of the line, but in a sentence only to the end of the word. */
function endOf(line: string, start: number): number {
  const last = line.lastIndexOf('\\') + 1;
  const isBehindName = /^$|[:=>]$/.test(line.slice(Math.max(0, start - MOST), start).trim());
  const rest = line.slice(last).trimEnd();
  const end = rest.search(isBehindName ? /["']|\s\(\d{1,6} bytes?\)/ : /[\s"']/);
  return last + (end < 0 ? rest.length : rest.slice(0, end).trimEnd().length);
}

function quotedIn(line: string, digits: number): readonly Quoted[] {
  const strings: Quoted[] = [];
  const unclosed = new Set<string>();
  for (let at = 0; at < line.length; at++) {
    const quote = line[at] as string;
    if ((quote !== '"' && quote !== "'") || unclosed.has(quote)) continue;
    const isBytes = /(?:^|\W)[bB]$/.test(line.slice(Math.max(0, at - 2), at));
    if (!isBytes && /\w/.test(line[at - 1] ?? ' ')) continue;
    let end = at + 1;
    let escapes = 0;
    while (end < line.length && line[end] !== quote) {
      if (line[end] === '\\') {
        escapes++;
        end++;
      }
      end++;
    }
    if (end >= line.length) {
      unclosed.add(quote);
      continue;
    }
    const isHex = end - at > digits && HEX_DIGITS.test(line.slice(at + 1, end));
    if (!isHex && end > at + 1) strings.push(withTimes(line, at, end, escapes > 0, isBytes));
    at = end;
  }
  return strings;
}

function withTimes(line: string, quote: number, close: number, has: boolean, isBytes: boolean): Quoted {
  const begin = isBytes ? quote - 1 : quote;
  const behind = /^\s*\*\s*(\d{1,4})/.exec(line.slice(close + 1, close + MOST));
  const before = behind === null ? /(\d{1,4})\s*\*\s*$/.exec(line.slice(Math.max(0, begin - MOST), begin)) : null;
  const said = behind ?? before;
  const times = said === null ? 1 : Math.min(REPEATED, Number(said[1]));
  const outer = {
    start: begin - (before?.[0].length ?? 0),
    end: close + 1 + (behind?.[0].length ?? 0),
  };
  const repeat = behind === null ? undefined : { start: close + 1, end: outer.end };
  return { start: quote + 1, end: close, times, repeat, outer, hasEscapes: has, isBytes };
}
