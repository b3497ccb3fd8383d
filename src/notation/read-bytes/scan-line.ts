import { dictionary } from '../../modbus/index.ts';
import { arrowAt, type ChunkWord, chunkWord } from './chunk-words.ts';
import { type Furniture, furnitureAt } from './furniture.ts';
import { Token } from './token.ts';

/** What takes the parts of a line, from left to right. All places are in the text. */
export interface Sink {
  number(token: Token): void;
  /** A word or a character that may be a misspelt byte. */
  oddity(start: number, end: number): void;
  leftOut(start: number, end: number): void;
  word(start: number, end: number): void;
  chunkWord(word: ChunkWord, start: number, end: number): void;
  /** What is no byte; whether the sink takes it for that. */
  furniture(start: number, end: number, kind: Furniture['kind']): boolean;
  /** A colon before a blank, or an equals sign: what stood before is a name. */
  label(): void;
  bracket(character: string): void;
  /** So many hexadecimal digits in parentheses, `(0x01)`. Whether they say the number before them again. */
  again(start: number, end: number, digits: number): boolean;
}

const OTHER = 0;
const BLANK = 1;
const DIGIT = 2;
const LETTER = 3;
const JOINT = 4;

const CLASS = (() => {
  const classes = new Uint8Array(128).fill(OTHER);
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

/** Says the parts of a line to a sink, in time linear in its length. */
export class LineScanner {
  readonly #line: string;
  /** Where the line begins in the text. */
  readonly #base: number;
  readonly #sink: Sink;
  #comma = false;
  #negative = false;

  constructor(line: string, base: number, sink: Sink) {
    this.#line = line;
    this.#base = base;
    this.#sink = sink;
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
    return CLASS[this.#line.charCodeAt(at)] ?? OTHER;
  }

  #number(start: number, end: number, from: number, to: number, base: Token['base']): number {
    const shift = this.#base;
    const token = new Token('number', shift + start, shift + end, shift + from, shift + to, base);
    const before = this.#line[start - 1];
    if (before === '[' && this.#line[end] === ']') token.bracket = '[';
    if (before === '<' && this.#line[end] === '>') token.bracket = '<';
    token.comma = this.#comma;
    token.negative = this.#negative;
    this.#comma = false;
    this.#negative = false;
    this.#sink.number(token);
    return end;
  }

  #alphanumeric(from: number): number {
    let to = from;
    while (this.#class(to) === DIGIT) to++;
    // Most of a log is pairs with blanks between, and without a word behind they can be nothing else.
    const pair = to === from + 2 && this.#class(to) === BLANK && this.#class(from - 1) === BLANK;
    if (pair && this.#class(to + 1) !== LETTER && !/[bc]/.test(this.#line[to + 1] ?? ''))
      return this.#number(from, to, from, to, 0);
    const furniture = this.#isJoined(from)
      ? undefined
      : this.#furniture(from, this.#isDecimal(from) ? 'digit' : 'letter');
    if (furniture !== undefined) return furniture;
    return to > from && this.#class(to) !== LETTER ? this.#digits(from, to) : this.#word(from, to);
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
    if (found === undefined) return undefined;
    return this.#sink.furniture(this.#base + at, this.#base + found.end, found.kind) ? found.end : undefined;
  }

  #digits(from: number, to: number): number {
    if (this.#line[to] !== '#') {
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
    this.#sink.furniture(this.#base + from, this.#base + to + 1, 'noise');
    return to + 1;
  }

  #word(from: number, digitsEnd: number): number {
    let to = digitsEnd;
    while (this.#class(to) === LETTER || this.#class(to) === DIGIT) to++;
    const text = this.#line.slice(from, to);
    for (const { form, prefix, base, after } of SAID) {
      const digits = after === undefined || after === this.#line[from - 1] ? form.exec(text)?.[1] : undefined;
      if (digits !== undefined) return this.#number(from, to, from + prefix, from + prefix + digits.length, base);
    }
    const known = chunkWord(text, this.#line, to);
    if (known !== undefined) this.#sink.chunkWord(known, this.#base + from, this.#base + to);
    else if (this.#line[to] === '#') this.#sink.furniture(this.#base + from, this.#base + to, 'noise');
    else if (to - from <= 2 || (to - from <= 4 && /^0x/i.test(text)))
      this.#sink.oddity(this.#base + from, this.#base + to);
    else this.#sink.word(this.#base + from, this.#base + to);
    return to;
  }

  #joint(at: number): number {
    const character = this.#line[at] as string;
    const next = this.#line[at + 1] ?? ' ';
    switch (character) {
      case ',':
        this.#comma = true;
        return at + 1;
      case ':':
        if (this.#class(at + 1) === BLANK && this.#class(at - 1) !== BLANK) this.#sink.label();
        return at + 1;
      case '.':
        return this.#dots(at);
      case '/':
        if (next === '/' && this.#line[at - 1] !== ':') return this.#line.length;
        return next === '*' ? this.#comment(at, '*/') : at + 1;
      case '#':
        return next === ' ' && this.#class(at - 1) === BLANK ? this.#line.length : at + 1;
      case '(':
        return next === '*' ? this.#comment(at, '*)') : this.#parenthesis(at);
      case '[':
        return this.#squareBracket(at);
      case '{':
      case ')':
      case ']':
      case '}':
        this.#sink.bracket(character);
        return at + 1;
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
    if (to > at + 2) this.#sink.leftOut(this.#base + at, this.#base + to);
    return to;
  }

  /** A comment without an end in this line takes the rest of it. */
  #comment(at: number, close: string): number {
    const end = this.#line.indexOf(close, at + 2);
    return end < 0 ? this.#line.length : end + close.length;
  }

  #parenthesis(at: number): number {
    const form = /\(0x([0-9a-f]{1,2})\)/iy;
    form.lastIndex = at;
    if (form.test(this.#line)) {
      const end = form.lastIndex;
      if (this.#sink.again(this.#base + at, this.#base + end, end - at - 4)) return end;
    }
    this.#sink.bracket('(');
    return at + 1;
  }

  #squareBracket(at: number): number {
    const furniture = this.#furniture(at, '[');
    if (furniture !== undefined) return furniture;
    // The size or the index of a variable: `frame[8]`, `ARRAY [0..7]`.
    const size = /\[ ?\d{0,6} ?(?:\.\. ?\d{1,6} ?)?\]/y;
    size.lastIndex = at;
    const named = /[a-z_]\w* ?$/i.exec(this.#line.slice(Math.max(0, at - 40), at))?.[0].trim();
    if (named !== undefined && size.test(this.#line) && chunkWord(named, `${named}:`, named.length) === undefined) {
      const isIndex = this.#class(at - 1) !== BLANK || /array/i.test(named);
      if (isIndex) return size.lastIndex;
    }
    this.#sink.bracket('[');
    return at + 1;
  }

  #arrowOrSign(at: number, character: string, next: string): number {
    const arrow = arrowAt(this.#line, at);
    if (arrow !== undefined) {
      this.#sink.chunkWord(arrow.word, this.#base + at, this.#base + arrow.end);
      return arrow.end;
    }
    if (character === '=') this.#sink.label();
    if (character === '-') this.#negative = /\d/.test(next) && /[\s,[({]/.test(this.#line[at - 1] ?? ' ');
    return at + 1;
  }

  #other(at: number): number {
    if (this.#line[at] === '\u2026') {
      this.#sink.leftOut(this.#base + at, this.#base + at + 1);
      return at + 1;
    }
    const furniture = this.#line[at] === '@' ? this.#furniture(at, '@') : undefined;
    if (furniture !== undefined) return furniture;
    let to = at + 1;
    while (to < this.#line.length && this.#class(to) === OTHER) to++;
    this.#sink.oddity(this.#base + at, this.#base + to);
    return to;
  }
}
