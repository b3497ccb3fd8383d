import { dictionary } from '../../modbus/index.ts';
import type { Output } from './output.ts';
import type { StringPart, StringPiece } from './strings.ts';

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
/** `\1`, `\197`, as in Lua. */
const DECIMAL = /\\(1\d\d|2[0-4]\d|25[0-5]|\d{1,2})/y;
/** `\0` and nothing else, as in Rust. */
const ZERO = /\\(0)/y;

/** Escapes with something between all of them, which then is not a byte. */
const SEPARATED = /^(?:\\x[0-9a-f]{2}[\s,;]+){2,}\\x[0-9a-f]{2}[\s,;]*$/i;

/** How the escapes of a text that are numbers without an `x` are read. */
export function numbersOf(plain: string): RegExp {
  const escapes = plain.replaceAll('\\\\', '  ');
  const hasHexadecimal = /\\x[0-9a-f]/i.test(plain);
  if (hasHexadecimal && /\\0(?![0-7]{2})/.test(escapes) && !/\\[1-7]/.test(escapes)) return ZERO;
  // A number of one digit alone, and one with an 8 or a 9 in it, are together neither pairs nor octal.
  if (/\\\d(?![\dA-Fa-f])/.test(escapes) && /\\(?:\d{0,2}[89]|[4-9]\d\d)/.test(escapes) && !/\\\d?[A-Fx]/.test(escapes))
    return DECIMAL;
  // Pairs always have two digits.
  const isOctal =
    /\\[0-7](?![0-9A-Fa-f])/.test(escapes) ||
    !/\\[0-9a-f]{2}/i.test(plain.replace(/\\[0-3][0-7]{2}|\\x[0-9a-f]{2}/gi, ''));
  return isOctal || hasHexadecimal ? OCTAL : PAIR;
}

/** Reads a piece: what stands between two escapes is a byte for each character. */
export function readString(plain: string, { parts }: StringPiece, numbers: RegExp, out: Output): void {
  for (const part of parts) {
    readPart(plain, part, numbers, out);
    const { times, repeat = { start: part.end - 1, end: part.end } } = part;
    // The bytes of a repetition stand where it is said, or at the end, so that places stay in order.
    const bytes = times > 1 ? valuesOf(plain, part, numbers) : [];
    for (let n = 1; n < times; n++) for (const value of bytes) out.byte(value, repeat.start, repeat.end);
  }
}

function valuesOf(plain: string, { start, end }: StringPart, numbers: RegExp): readonly number[] {
  const values: number[] = [];
  for (let at = start; at < end; ) {
    const { value, length } =
      plain[at] === '\\' ? escapeAt(plain, at, numbers) : { value: plain.charCodeAt(at), length: 1 };
    if (value !== undefined && value <= 0xff) values.push(value);
    at += length;
  }
  return values;
}

function readPart(plain: string, { start, end }: StringPart, numbers: RegExp, out: Output): void {
  const isList = SEPARATED.test(plain.slice(start, end));
  let at = start;
  while (at < end) {
    if (plain[at] !== '\\') {
      if (!isList) readCharacter(plain, at, out);
      at++;
      continue;
    }
    const { value, length } = escapeAt(plain, at, numbers);
    const place = { start: at, end: Math.min(at + length, end) };
    if (value === undefined) out.problems.push({ code: 'escape-unknown', ...place });
    else if (value > 0xff) out.problems.push({ code: 'value-over-255', ...place, got: value });
    else out.byte(value, place.start, place.end);
    at += length;
  }
}

function readCharacter(plain: string, at: number, out: Output): void {
  const value = plain.charCodeAt(at);
  if (value <= 0xff) out.byte(value, at, at + 1);
  else out.problems.push({ code: 'character-unknown', start: at, end: at + 1 });
}

function escapeAt(
  plain: string,
  at: number,
  numbers: RegExp,
): { readonly value: number | undefined; readonly length: number } {
  HEXADECIMAL.lastIndex = at;
  const hex = HEXADECIMAL.exec(plain);
  if (hex !== null) {
    return { value: Number.parseInt(hex[1] ?? hex[2] ?? hex[3] ?? '', 16), length: hex[0].length };
  }
  for (const form of numbers === PAIR ? [PAIR, OCTAL] : [numbers]) {
    form.lastIndex = at;
    const found = form.exec(plain);
    if (found !== null)
      return {
        value: Number.parseInt(found[1] ?? '', form === PAIR ? 16 : form === DECIMAL ? 10 : 8),
        length: found[0].length,
      };
  }
  return { value: NAMED[plain[at + 1] ?? ''], length: 2 };
}
