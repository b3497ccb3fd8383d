import { dictionary } from '../../modbus/index.ts';
import { labelOf } from './labels.ts';
import type { Output } from './output.ts';
import { eachLine } from './plain-text.ts';
import type { TextRange } from './types.ts';

/** How much of a line before a string, in characters, is looked at. */
const MOST = 100;

const NAMED: Readonly<Record<string, number>> = dictionary({
  a: 7,
  b: 8,
  t: 9,
  n: 10,
  v: 11,
  f: 12,
  r: 13,
  e: 27,
  s: 32,
  '\\': 92,
  "'": 39,
  '"': 34,
  '`': 96,
  '?': 63,
});

/** `\x01`, `\u0001`. */
const HEXADECIMAL = /\\(?:x([0-9a-f]{1,2})|u([0-9a-f]{4})|u\{([0-9a-f]{1,6})\})/iy;
/** `\01`, as LabVIEW writes bytes; there, small letters are names. */
const PAIR = /\\([0-9][0-9a-fA-F]|[A-F][0-9A-F])/y;
/** `\001`, as in C. */
const OCTAL = /\\([0-3][0-7]{2}|[0-7]{1,2})/y;

/** Escapes with something between all of them, which then is no byte. */
const SEPARATED = /^(?:\\x[0-9a-f]{2}[\s,;]+){2,}\\x[0-9a-f]{2}[\s,;]*$/i;

/** The first escape of a string without quotes: a number, or a name with nothing between it and the next. */
const BEGIN = /\\(?:x[0-9a-f]|u[0-9a-f{]|\d|[A-F][0-9A-F]|[abtnvfres](?=\\))/i;

/** Whether the text has escapes, or is a string of bytes as Python prints it. */
export const hasEscapes = (plain: string): boolean =>
  /\\x[0-9a-f]|\\u00[0-9a-f]{2}|\\[0-9A-F]{2}[^\\]{0,2}\\|\\[0-7]{1,3}\\/i.test(plain) ||
  /(?:^|[\s=(,[:>])b(?:'[^'\n]|"[^"\n])/.test(plain);

/** Reads strings with escapes, in quotes or not: what stands between two escapes is a byte for each character. */
export function readEscapes(plain: string, out: Output): void {
  const isOctal = !/\\[0-9a-f]{2}/i.test(plain.replace(/\\[0-3][0-7]{2}|\\x[0-9a-f]{2}/gi, ''));
  const numbers = isOctal || /\\x[0-9a-f]/i.test(plain) ? OCTAL : PAIR;
  let continues = false;
  eachLine(plain, (start, end) => {
    const line = plain.slice(start, end);
    const pieces = piecesOf(line);
    const [first] = pieces;
    if (first === undefined) return;
    const from = out.length;
    for (const piece of pieces) readPiece(line, piece, start, numbers, out);
    // A string that begins its line goes on with the string that ended the line before, as in C and Python.
    if (
      continues &&
      line
        .slice(0, first.start)
        .replace(/b?["']$/, '')
        .trim() === ''
    )
      out.extendChunk(from);
    else out.chunk(from, labelOf(line.slice(0, first.start)));
    continues = /["']\s*\\?\s*$/.test(line.slice(-20));
  });
}

/** The places in a line that hold bytes: its strings that have escapes, or else all from the first escape to the last. */
function piecesOf(line: string): readonly TextRange[] {
  if (!line.includes('\\') && !/b['"]/.test(line)) return [];
  const strings = stringsOf(line);
  if (strings.length > 0) return strings;
  const first = line.search(BEGIN);
  // What has another backslash before it is the path of a file.
  if (first < 0 || first > line.indexOf('\\')) return [];
  let start = first;
  while (start > 0 && /[^\s:=>(,[{<"']/.test(line[start - 1] as string)) start--;
  return [{ start, end: endOf(line, start) }];
}

/** How far a string without quotes goes: to the end of the line, but in a sentence only to the end of the word. */
function endOf(line: string, start: number): number {
  const last = line.lastIndexOf('\\') + 1;
  const isBehindName = /^$|[:=>]$/.test(line.slice(Math.max(0, start - MOST), start).trim());
  const rest = line.slice(last).trimEnd();
  const end = rest.search(isBehindName ? /["']|\s\(\d{1,6} bytes?\)/ : /[\s"']/);
  return last + (end < 0 ? rest.length : rest.slice(0, end).trimEnd().length);
}

function stringsOf(line: string): readonly TextRange[] {
  const strings: TextRange[] = [];
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
    if (escapes > 0 || isBytes) strings.push({ start: at + 1, end });
    at = end;
  }
  return strings;
}

function readPiece(line: string, { start, end }: TextRange, base: number, numbers: RegExp, out: Output): void {
  const isList = SEPARATED.test(line.slice(start, end));
  let at = start;
  while (at < end) {
    if (line[at] !== '\\') {
      if (!isList) readCharacter(line, at, base, out);
      at++;
      continue;
    }
    const { value, length } = escapeAt(line, at, numbers);
    const place = { start: base + at, end: Math.min(base + at + length, base + end) };
    if (value === undefined) out.problems.push({ code: 'escape-unknown', ...place });
    else if (value > 0xff) out.problems.push({ code: 'value-over-255', ...place, got: value });
    else out.byte(value, place.start, place.end);
    at += length;
  }
}

function readCharacter(line: string, at: number, base: number, out: Output): void {
  const value = line.charCodeAt(at);
  if (value <= 0xff) out.byte(value, base + at, base + at + 1);
  else out.problems.push({ code: 'character-unknown', start: base + at, end: base + at + 1 });
}

function escapeAt(
  line: string,
  at: number,
  numbers: RegExp,
): { readonly value: number | undefined; readonly length: number } {
  HEXADECIMAL.lastIndex = at;
  const hex = HEXADECIMAL.exec(line);
  if (hex !== null) {
    return { value: Number.parseInt(hex[1] ?? hex[2] ?? hex[3] ?? '', 16), length: hex[0].length };
  }
  for (const form of numbers === PAIR ? [PAIR, OCTAL] : [OCTAL]) {
    form.lastIndex = at;
    const found = form.exec(line);
    if (found !== null)
      return { value: Number.parseInt(found[1] ?? '', form === PAIR ? 16 : 8), length: found[0].length };
  }
  return { value: NAMED[line[at + 1] ?? ''], length: 2 };
}
