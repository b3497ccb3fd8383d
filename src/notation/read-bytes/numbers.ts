import { hexDigit } from '../../modbus/index.ts';
import type { Token } from './items.ts';
import { Output } from './output.ts';
import type { TextProblem } from './types.ts';

/** Reads the numbers of a section in one base. */
export type NumberReader = (text: string, tokens: readonly Token[], out: Output) => void;

/** The bytes that a reader makes of numbers. */
export function bytesIn(plain: string, tokens: readonly Token[], read: NumberReader): Uint8Array {
  const out = new Output();
  read(plain, tokens, out);
  return out.bytes;
}

const LARGEST = 0xff;
const DIGITS: Readonly<Record<2 | 10 | 16, RegExp>> = { 2: /^[01]+$/, 10: /^\d+$/, 16: /^[0-9a-f]+$/i };

/** Numbers that say no base are hexadecimal, alone or in unbroken runs of pairs. */
export const readHex: NumberReader = (text, tokens, out) => {
  const bare = tokens.filter(({ kind, base }) => kind === 'number' && base === 0);
  const isMixed = bare.length < tokens.length && tokens.some(({ base }) => base === 16);
  // Beside 0x0A a 10 is decimal, as in a program; beside 0x01 a 03 goes on with the hexadecimal.
  if (isMixed && !bare.some((token) => isHexShaped(text, token))) {
    readDecimal(text, tokens, out);
    return;
  }
  // Programs that leave out the zero in front do so everywhere.
  const isPadded = bare.some(({ from, to }) => to - from > 1 && text[from] === '0');
  for (const token of tokens) {
    if (token.kind !== 'number' || token.base !== 0) readSaid(text, token, out);
    else readPairs(text, token, isPadded && token.bracket === '', out);
  }
};

/** The value of one or two hexadecimal digits. */
const pairAt = (text: string, from: number, to: number): number =>
  to - from === 1
    ? hexDigit(text.charCodeAt(from))
    : 16 * hexDigit(text.charCodeAt(from)) + hexDigit(text.charCodeAt(from + 1));

/** Whether digits cannot be a decimal number as a program writes it: they have a letter, or a zero in front. */
const isHexShaped = (text: string, { from, to }: Token): boolean =>
  (to - from > 1 && text[from] === '0') || !DIGITS[10].test(text.slice(from, to));

function readPairs(text: string, { start, end, from, to }: Token, isPadded: boolean, out: Output): void {
  const digits = to - from;
  if (digits <= 2) {
    if (digits === 1 && isPadded) out.problems.push({ code: 'nibble-missing', start, end });
    out.byte(pairAt(text, from, to), start, end);
    return;
  }
  for (let at = from; at + 1 < to; at += 2) out.byte(pairAt(text, at, at + 2), at, at + 2);
  if (digits % 2 !== 0) out.problems.push({ code: 'odd-digits', start: to - 1, end: to, digits });
}

/** A number with a base, or what is not a number. One of several bytes has the high one first. */
function readSaid(text: string, { kind, start, end, from, to, base, value }: Token, out: Output): void {
  if (value !== undefined) {
    out.byte(value, start, end);
    return;
  }
  if (kind !== 'number' || base === 0) {
    out.problems.push({ code: kind === 'left-out' ? 'left-out' : 'not-a-byte', start, end });
    return;
  }
  const digits = to - from;
  if (base === 2) readValue(Number.parseInt(text.slice(from, to), 2), { start, end }, out);
  else if (digits <= 2) out.byte(pairAt(text, from, to), start, end);
  else if (digits % 2 === 0) {
    for (let at = from; at < to; at += 2) out.byte(pairAt(text, at, at + 2), at, at + 2);
  } else readValue(Number.parseInt(text.slice(from, to), 16), { start, end }, out);
}

function readValue(value: number, { start, end }: { start: number; end: number }, out: Output): void {
  if (value <= LARGEST) out.byte(value, start, end);
  else out.problems.push({ code: 'value-over-255', start, end, got: value });
}

/** Numbers that say no base are decimal; −128 to −1 are the bytes 128 to 255, as some programs print them. */
export const readDecimal: NumberReader = (text, tokens, out) => {
  for (const token of tokens) {
    const { start, end, from, to, negative } = token;
    const digits = text.slice(from, to);
    if (token.kind !== 'number' || token.base !== 0) readSaid(text, token, out);
    else if (!DIGITS[10].test(digits)) out.problems.push(notOfBase(token, 10));
    else {
      const value = Number(digits);
      if (negative && value > 0 && value <= 128) out.byte(256 - value, start - 1, end);
      else readValue(value, { start, end }, out);
    }
  }
};

/** Numbers that say no base are binary, eight digits a byte. */
export const readBinary: NumberReader = (text, tokens, out) => {
  for (const token of tokens) {
    const { from, to } = token;
    if (token.kind !== 'number' || token.base !== 0) readSaid(text, token, out);
    else if (!DIGITS[2].test(text.slice(from, to))) out.problems.push(notOfBase(token, 2));
    else {
      for (let at = from; at + 8 <= to; at += 8) out.byte(Number.parseInt(text.slice(at, at + 8), 2), at, at + 8);
      if ((to - from) % 8 !== 0) {
        out.problems.push({ code: 'odd-digits', start: to - ((to - from) % 8), end: to, digits: to - from });
      }
    }
  }
};

/** Numbers of four digits are words with the low byte in front, as a dump by words prints them. */
export const readSwapped: NumberReader = (text, tokens, out) => {
  for (const token of tokens) {
    const { kind, base, from, to } = token;
    if (kind !== 'number' || base !== 0 || to - from !== 4) readHex(text, [token], out);
    else {
      // Both have the place of the word, so that places stay in order.
      out.byte(pairAt(text, from + 2, to), from, to);
      out.byte(pairAt(text, from, from + 2), from, to);
    }
  }
};

const notOfBase = ({ start, end }: Token, base: 2 | 10 | 16): TextProblem => ({
  code: 'not-of-base',
  start,
  end,
  base,
});

/** What the shape alone of the numbers says. */
export function likelyBase(text: string, tokens: readonly Token[]): 2 | 10 | 16 {
  const bare = tokens.filter(({ kind, base }) => kind === 'number' && base === 0);
  if (bare.length < tokens.length && tokens.some(({ base }) => base !== 0)) return 16;
  const digits = bare.map(({ from, to }) => text.slice(from, to));
  if (digits.length > 1 && digits.every((run) => run.length === 8 && DIGITS[2].test(run))) return 2;
  if (!digits.every((run) => run.length <= 3 && DIGITS[10].test(run))) return 16;
  // Programs print 5 for a byte of 5 in decimal, but 05 in hexadecimal.
  const isPlain = digits.every((run) => run === '0' || !run.startsWith('0'));
  if (!isPlain && digits.every((run) => run.length <= 2)) return 16;
  const isList = isPlain && bare.some(({ comma, negative }) => comma || negative);
  return isList || digits.some((run) => run.length !== 2) ? 10 : 16;
}
