import { dictionary } from '../../modbus/index.ts';
import { furnitureAt } from './furniture.ts';
import { type Item, isNumber, type Mark, Token } from './items.ts';
import { saysAgain } from './says-again.ts';
import { arrowAt, chunkWord, usbTransfer } from './sides.ts';

const OTHER = 0;
const BLANK = 1;
const DIGIT = 2;
const LETTER = 3;
const JOINT = 4;

const ASCII = 128;
/** From here on characters are words by themselves. */
const CHINESE = 0x2e80;
const CLASS = (() => {
  const classes = new Uint8Array(ASCII).fill(OTHER);
  const put = (characters: string, value: number) => {
    for (const character of characters) classes[character.charCodeAt(0)] = value;
  };
  put(' \t\v\f\0', BLANK);
  put('0123456789abcdefABCDEF', DIGIT);
  put('ghijklmnopqrstuvwxyzGHIJKLMNOPQRSTUVWXYZ_', LETTER);
  put(',;|+\'"`%\\&$-.:/#<>=[](){}', JOINT);
  return classes;
})();

/** The forms of a number that say their base in one run of letters and digits, and what must stand before it. */
const SAID: readonly { readonly form: RegExp; readonly prefix: number; readonly base: 2 | 16; after?: string }[] = [
  { form: /^0x([0-9a-f]+)(?:u|ul|u8|uy)?$/i, prefix: 2, base: 16 },
  { form: /^x([0-9a-f]{1,2})$/i, prefix: 1, base: 16 },
  { form: /^h([0-9a-f]{1,2})$/i, prefix: 1, base: 16, after: '&' },
  { form: /^([0-9][0-9a-f]?|[a-f][0-9]|0[0-9a-f]{2}|[a-f]{2})h$/i, prefix: 0, base: 16 },
];

/** The same where a `#` divides it: `16#06`. */
const BASES: Readonly<Record<string, 2 | 16>> = dictionary({ '16': 16, '2': 2 });

const BRACED = /^\{[0-9a-f]{2}\}$/i;
const BRACE = 4;
const COUNTED = /by|ba|ch|bp|feb|apr|aug|dec/iy;
/** The most characters a word may have to be an oddity. */
const ODDITY = 2;
const LETTER_BEYOND = /\p{L}|\p{M}/u;

/** The items of a line that begins at `base` of the text, from left to right, in time linear in its length. */
export function scanLine(line: string, base: number, isComment = false): readonly Item[] {
  const scanner = new LineScanner(line, base, isComment);
  scanner.scan();
  return scanner.items;
}

class LineScanner {
  readonly items: Item[] = [];
  readonly #line: string;
  /** Where the line begins in the text. */
  readonly #base: number;
  /** All of it is a comment, in which no other begins. */
  readonly #isComment: boolean;
  #comma = false;
  #parted = false;
  #negative = false;

  constructor(line: string, base: number, isComment: boolean) {
    this.#isComment = isComment;
    this.#line = line;
    this.#base = base;
  }

  scan(): void {
    const { length } = this.#line;
    let at = 0;
    while (at < length) {
      const kind = this.#class(at);
      if (kind === BLANK) at++;
      else if (kind === DIGIT || kind === LETTER) at = this.#alphanumeric(at);
      else if (kind === JOINT) at = this.#joint(at);
      else at = this.#other(at);
    }
  }

  /** Beyond the line all is blank. */
  #class(at: number): number {
    if (at < 0 || at >= this.#line.length) return BLANK;
    const code = this.#line.charCodeAt(at);
    if (code < ASCII) return CLASS[code] as number;
    return LETTER_BEYOND.test(this.#line[at] as string) ? LETTER : OTHER;
  }

  #mark(kind: Mark['kind'], start: number, end: number, says?: Mark['says']): number {
    const place = { kind, start: this.#base + start, end: this.#base + end };
    this.items.push(says === undefined ? place : { ...place, says });
    return end;
  }

  #number(start: number, end: number, from: number, to: number, base: Token['base']): number {
    const shift = this.#base;
    const token = new Token('number', shift + start, shift + end, shift + from, shift + to, base);
    const before = this.#line[start - 1];
    if (before === '[' && this.#line[end] === ']') token.bracket = '[';
    if (before === '<' && this.#line[end] === '>') token.bracket = '<';
    token.comma = this.#comma;
    token.parted = this.#parted;
    token.negative = this.#negative;
    this.#comma = false;
    this.#parted = false;
    this.#negative = false;
    this.items.push(token);
    return end;
  }

  #alphanumeric(from: number): number {
    const transfer = from === 0 ? usbTransfer(this.#line) : undefined;
    if (transfer !== undefined) return this.#mark('side', 0, transfer.end, transfer.word);
    let to = from;
    while (this.#class(to) === DIGIT) to++;
    // Most of a log is pairs with blanks between, and without a word behind they can be nothing else.
    const pair = to === from + 2 && this.#class(to) === BLANK && this.#class(from - 1) === BLANK;
    if (pair && this.#class(to + 1) !== LETTER && !this.#isCountedOrDated(to + 1))
      return this.#number(from, to, from, to, 0);
    const furniture = this.#isJoined(from)
      ? undefined
      : this.#furniture(from, this.#isDecimal(from) ? 'digit' : 'letter');
    if (furniture !== undefined) return furniture;
    return to > from && this.#class(to) !== LETTER ? this.#digits(from, to) : this.#word(from, to);
  }

  /** Whether a word begins here that makes a count or a date of the number before it, as in `12 bytes` and `12 Aug`. */
  #isCountedOrDated(at: number): boolean {
    COUNTED.lastIndex = at;
    return COUNTED.test(this.#line);
  }

  /** Whether digits go on here after a joint, as in `F7:03`. */
  #isJoined(at: number): boolean {
    return this.#class(at - 1) === JOINT && this.#class(at - 2) === DIGIT && /[.:-]/.test(this.#line[at - 1] ?? '');
  }

  #isDecimal(at: number): boolean {
    const code = this.#line.charCodeAt(at);
    return code >= 0x30 && code <= 0x39;
  }

  #furniture(at: number, first: Parameters<typeof furnitureAt>[2]): number | undefined {
    const found = furnitureAt(this.#line, at, first);
    return found === undefined ? undefined : this.#mark(found.kind, at, found.end);
  }

  #digits(from: number, to: number): number {
    // The `b` of a string of Python.
    if (to === from + 1 && /[bB]/.test(this.#line[from] ?? '') && /['"]/.test(this.#line[to] ?? '')) return to;
    if (this.#line[to] !== '#' || this.#line[from - 1] === '$') {
      if (to - from === 10 && /^0b[01]{8}$/.test(this.#line.slice(from, to))) {
        return this.#number(from, to, from + 2, to, 2);
      }
      const dollar = this.#line[from - 1] === '$';
      return this.#number(dollar ? from - 1 : from, to, from, to, dollar ? 16 : 0);
    }
    let end = to + 1;
    while (this.#class(end) === DIGIT) end++;
    const base = to - from <= 2 && end > to + 1 ? BASES[this.#line.slice(from, to)] : undefined;
    if (base !== undefined) return this.#number(from, end, to + 1, end, base);
    return this.#mark('noise', from, to + 1);
  }

  #word(from: number, digitsEnd: number): number {
    let to = digitsEnd;
    while (this.#class(to) === LETTER || this.#class(to) === DIGIT) to++;
    const text = this.#line.slice(from, to);
    for (const { form, prefix, base, after } of SAID) {
      const digits = after === undefined || after === this.#line[from - 1] ? form.exec(text)?.[1] : undefined;
      if (digits !== undefined) return this.#number(from, to, from + prefix, from + prefix + digits.length, base);
    }
    const known = chunkWord(text, this.#line, from, to);
    if (known !== undefined) return this.#mark('side', from, to, known);
    if (this.#line[to] === '#') return this.#mark('noise', from, to);
    const isOdd =
      (to - from <= ODDITY && this.#line.charCodeAt(from) < CHINESE) || (to - from <= 2 * ODDITY && /^0x/i.test(text));
    return this.#mark(isOdd ? 'oddity' : 'word', from, to);
  }

  #joint(at: number): number {
    const character = this.#line[at] as string;
    const next = this.#line[at + 1] ?? ' ';
    switch (character) {
      case ',':
        this.#comma = true;
        this.#parted = true;
        return at + 1;
      case ';':
      case '|':
        this.#parted = true;
        return at + 1;
      case ':':
        if (this.#class(at + 1) === BLANK && this.#class(at - 1) !== BLANK) this.#mark('label', at, at + 1);
        return at + 1;
      case '.':
        return this.#dots(at);
      case '/':
        if (next === '/' && this.#line[at - 1] !== ':') return this.#comment(at, 2);
        if (next === '*') return this.#comment(at, 2, '*/');
        this.#parted = true;
        return at + 1;
      case '#':
        return next === ' ' && this.#class(at - 1) === BLANK ? this.#comment(at, 1) : at + 1;
      case '(':
        return next === '*' ? this.#comment(at, 2, '*)') : this.#parenthesis(at);
      case '[':
        return this.#squareBracket(at);
      case '{':
        // Each byte by itself, as `{11}{03}`.
        return BRACED.test(this.#line.slice(at, at + BRACE)) ? at + 1 : this.#mark('open', at, at + 1);
      case '}':
        if (BRACED.test(this.#line.slice(Math.max(0, at + 1 - BRACE), at + 1))) return at + 1;
        return this.#mark('close', at, at + 1);
      case ')':
      case ']':
        return this.#mark('close', at, at + 1);
      case '<':
      case '>':
      case '=':
      case '-':
        return this.#arrowOrSign(at, character, next);
      default:
        return at + 1;
    }
  }

  #dots(at: number): number {
    let to = at + 1;
    while (this.#line[to] === '.') to++;
    if (to > at + 2 && isNumber(this.items.at(-1)))
      this.items.push(new Token('left-out', this.#base + at, this.#base + to, this.#base + at, this.#base + to, 0));
    return to;
  }

  /** A comment without an end in this line takes the rest of it. One that begins the line is a line like any other. */
  #comment(at: number, mark: number, close = ''): number {
    if (this.items.length === 0 || this.#isComment) return at + mark;
    const closed = close === '' ? -1 : this.#line.indexOf(close, at + mark);
    const end = closed < 0 ? this.#line.length : closed;
    this.#mark('comment', at + mark, end);
    return Math.min(this.#line.length, end + close.length);
  }

  #parenthesis(at: number): number {
    if (this.#class(at + 1) === DIGIT) {
      const tag = this.#furniture(at, '(');
      if (tag !== undefined) return tag;
    }
    const again = saysAgain(this.#line, at, this.items, this.#base);
    if (again === undefined) return this.#mark('open', at, at + 1);
    if (again.replaces) this.items.pop();
    if (again.token !== undefined) this.items.push(again.token);
    return again.end;
  }

  #squareBracket(at: number): number {
    const furniture = this.#furniture(at, '[');
    if (furniture !== undefined) return furniture;
    // The size or the index of a variable: `frame[8]`, `ARRAY [0..7]`.
    const size = /\[ ?\d{0,6} ?(?:\.\. ?\d{1,6} ?)?\]/y;
    size.lastIndex = at;
    const named = /[a-z_]\w* ?$/i.exec(this.#line.slice(Math.max(0, at - 40), at))?.[0].trim();
    if (named !== undefined && size.test(this.#line) && chunkWord(named, `${named}:`, 0, named.length) === undefined) {
      const isIndex = this.#class(at - 1) !== BLANK || /array/i.test(named);
      if (isIndex) return size.lastIndex;
    }
    return this.#mark('open', at, at + 1);
  }

  #arrowOrSign(at: number, character: string, next: string): number {
    const arrow = arrowAt(this.#line, at);
    if (arrow !== undefined) return this.#mark('side', at, arrow.end, arrow.word);
    if (character === '-' && next === '-' && this.#class(at + 2) === BLANK && this.#class(at - 1) === BLANK) {
      return this.#comment(at, 2);
    }
    if (character === '=') this.#mark('label', at, at + 1);
    if (character === '-') this.#negative = /\d/.test(next) && /[\s,[({]/.test(this.#line[at - 1] ?? ' ');
    return at + 1;
  }

  #other(at: number): number {
    if (this.#line[at] === '\u2026') {
      if (isNumber(this.items.at(-1)))
        this.items.push(
          new Token('left-out', this.#base + at, this.#base + at + 1, this.#base + at, this.#base + at + 1, 0),
        );
      return at + 1;
    }
    const arrow = this.#line.charCodeAt(at) < ASCII ? undefined : arrowAt(this.#line, at);
    if (arrow !== undefined) return this.#mark('side', at, arrow.end, arrow.word);
    const furniture = this.#line[at] === '@' ? this.#furniture(at, '@') : undefined;
    if (furniture !== undefined) return furniture;
    let to = at + 1;
    while (to < this.#line.length && this.#class(to) === OTHER && arrowAt(this.#line, to) === undefined) to++;
    // Markdown's marks of bold and struck letters.
    if (/^[*~]+$/.test(this.#line.slice(at, to))) return to;
    return this.#mark('oddity', at, to);
  }
}
