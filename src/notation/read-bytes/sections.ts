import { type Certainty, certaintyOf } from './certainty.ts';
import type { ChunkWord } from './chunk-words.ts';
import type { Furniture } from './furniture.ts';
import { eachLine } from './plain-text.ts';
import { chooseRuns, isEnglish, type Run, run, withoutProse } from './runs.ts';
import { LineScanner, type Sink } from './scan-line.ts';
import { textColumn } from './text-column.ts';
import { Token } from './token.ts';
import type { ChunkLabel } from './types.ts';

/** A line of the text, or the part of it that one direction word governs, with the numbers that may be its bytes. */
export interface Section {
  readonly label: ChunkLabel;
  readonly tokens: readonly Token[];
  /** The first number of the line, where the line begins with it: perhaps an offset. */
  readonly first: Token | undefined;
  readonly certainty: Certainty;
  /** Nothing but numbers and what is known around them stands there. */
  readonly alone: boolean;
  /** A bracket that an earlier line opened holds it. */
  readonly continued: boolean;
}

const NO_LABEL: ChunkLabel = Object.freeze({});
/** The most characters an oddity may have and still be a misspelt byte. */
const ODDITY = 4;
const LONGEST_NAME = 16;
/** Names of a checksum, and of what counts bytes. */
const CHECKSUM = /^(?:crc|lrc|checksum|chk)/i;
const COUNT = /^(?:len|length|size|no|num)$/i;
/** Characters of a time of day without fractions. */
const CLOCK = 8;
/** The most blanks between a number and what says it again. */
const MOST_BLANKS = 8;

/** Takes the parts of all lines and makes sections of them. */
class SectionReader implements Sink {
  readonly sections: Section[] = [];
  readonly #plain: string;
  #runs: Run[] = [];
  #tokens: Token[] = [];
  /** Between the numbers, not yet known to be one of them. */
  #oddity: Token | undefined;
  #parentheses = 0;
  #brackets = 0;
  #continued = false;
  #words = 0;
  #lineEnd = 0;
  /** Something but brackets has stood in the line. */
  #begun = false;
  #first: Token | undefined;
  #wordEnd = -1;
  #direct = false;
  #isNamed = false;
  /** The latest word. */
  #name = '';
  /** How far the latest line with a label is indented; the lines below that are indented more go on with it. */
  #indent = Number.POSITIVE_INFINITY;
  /** The line before was such a one, or has the label itself. */
  #hangs = false;
  #hanging = false;
  #label: ChunkLabel = NO_LABEL;
  /** Of a line that has a label and no bytes, which may be those of the next. */
  #inherited: ChunkLabel = NO_LABEL;

  constructor(plain: string) {
    this.#plain = plain;
  }

  read(line: string, base: number): void {
    this.#begun = false;
    this.#lineEnd = base + line.length;
    this.#parentheses = 0;
    this.#isNamed = false;
    this.#hanging = this.#hangs && line.length - line.trimStart().length > this.#indent;
    const depth = this.#brackets;
    this.#continued = depth > 0;
    this.#first = undefined;
    this.#label = NO_LABEL;
    this.#direct = false;
    this.#words = 0;
    this.#wordEnd = -1;
    const before = this.sections.length;
    const end = textColumn(line);
    new LineScanner(end < line.length ? line.slice(0, end) : line, base, this).scan();
    this.#endSection();
    // A bracket that a sentence leaves open holds nothing.
    if (this.#words > 0 || this.#label !== NO_LABEL) this.#brackets = Math.max(0, this.#brackets - depth);
    const indent = line.length - line.trimStart().length;
    if (indent === line.length) this.#indent = Number.POSITIVE_INFINITY;
    else this.#goOn(indent, this.sections.length > before);
  }

  /** Prepares for the next line, by what was found in this one. */
  #goOn(indent: number, hasBytes: boolean): void {
    this.#inherited = hasBytes ? NO_LABEL : this.#label;
    const isLabelled = this.#label.direction !== undefined || this.#label.time !== undefined;
    if (isLabelled || indent <= this.#indent) this.#indent = isLabelled ? indent : Number.POSITIVE_INFINITY;
    this.#hangs = hasBytes && this.#indent < Number.POSITIVE_INFINITY;
  }

  number(token: Token): void {
    if (this.#oddity !== undefined) {
      this.#tokens.push(this.#oddity);
      this.#oddity = undefined;
    }
    const prose =
      this.#tokens.length === 0 && token.base === 0 && this.#isAfterWord(token.start) && this.#isEnglish(token);
    if (prose) {
      this.word(token.start, token.end);
      return;
    }
    if (this.#isNamed && COUNT.test(this.#name) && token.base === 0 && token.to - token.from <= 3) {
      this.furniture(token.start, token.end, 'noise');
      this.#isNamed = false;
      return;
    }
    if (!this.#begun) this.#first = token;
    this.#begun = true;
    this.#tokens.push(token);
  }

  oddity(start: number, end: number): void {
    const isByte = this.#tokens.length > 0 || /\d/.test(this.#plain.slice(start, Math.min(end, start + ODDITY)));
    if (this.#oddity !== undefined || end - start > ODDITY || !isByte) {
      this.word(start, end);
      return;
    }
    this.#oddity = new Token('not-a-byte', start, end, start, end, 0);
  }

  leftOut(start: number, end: number): void {
    if (this.#tokens.length > 0 && this.#oddity === undefined)
      this.#oddity = new Token('left-out', start, end, start, end, 0);
  }

  word(start: number, end: number): void {
    this.#begun = true;
    this.#endRun(start);
    this.#isNamed = false;
    this.#name = this.#plain.slice(start, Math.min(end, start + LONGEST_NAME));
    this.#words++;
    this.#wordEnd = end;
    this.#direct = false;
  }

  chunkWord({ direction, transport }: ChunkWord, start: number, end: number): void {
    this.#begun = true;
    this.#endRun(start);
    if (direction !== undefined) {
      if (this.#runs.every(({ isName }) => isName)) this.#runs = [];
      else this.#endSection(this.#label.direction !== undefined);
      this.#direct = true;
      this.#label = { ...this.#label, direction };
    }
    if (transport !== undefined) this.#label = { ...this.#label, transport };
    this.#wordEnd = end;
  }

  furniture(start: number, end: number, kind: Furniture['kind']): boolean {
    if (kind === 'time' && this.#mayBeBytes(start, end)) return false;
    this.#begun = true;
    this.#endRun(-1);
    if (kind === 'time') this.#label = { ...this.#label, time: this.#plain.slice(start, end) };
    return true;
  }

  /** Whether what looks like a time of day is all there is in the line, or all behind its label: three bytes. */
  #mayBeBytes(start: number, end: number): boolean {
    if (end - start > CLOCK || this.#lineEnd - end > CLOCK || (this.#begun && !this.#direct)) return false;
    return this.#plain[start - 1] !== '[' && !/\w/.test(this.#plain.slice(end, this.#lineEnd));
  }

  label(): void {
    // The number before the colon is no byte, unless nothing else in the line is.
    const named = this.#tokens.length > 0 || this.#oddity !== undefined;
    const isOffset = this.#tokens.length === 1 && this.#first !== undefined && this.#first.to - this.#first.from >= 4;
    const name = this.#oddity === undefined && this.#tokens.length > 1 ? this.#tokens.pop() : undefined;
    if (name !== undefined) {
      this.#endRun(-1);
      this.#tokens.push(name);
    }
    this.#endRun(-1, true);
    if (named && !isOffset) this.#words++;
    if (named) this.#name = '';
    this.#isNamed = true;
  }

  bracket(character: string): void {
    if (character !== '[' && character !== ']') this.#endRun(-1);
    if (character === '(') this.#parentheses++;
    if (character === ')') this.#parentheses = Math.max(0, this.#parentheses - 1);
    if (character === '[' || character === '{') this.#brackets++;
    if (character === ']' || character === '}') this.#brackets = Math.max(0, this.#brackets - 1);
  }

  again(start: number, end: number, digits: number): boolean {
    const from = end - 1 - digits;
    const value = Number.parseInt(this.#plain.slice(from, end - 1), 16);
    let first = start;
    while (start - first < MOST_BLANKS && /[ \t]/.test(this.#plain[first - 1] ?? '')) first--;
    const isQuoted = /['"]/.test(this.#plain[first - 1] ?? '');
    const before = this.#tokens.at(-1);
    const isBefore = before !== undefined && before.end >= (isQuoted ? first - 2 : first);
    if (isQuoted && first >= 3 && this.#plain.charCodeAt(first - 2) === value) first -= 3;
    else if (isBefore && this.#says(before, value)) first = before.start;
    else return false;
    if (isBefore) this.#tokens.pop();
    this.#oddity = undefined;
    this.number(new Token('number', first, end, from, end - 1, 16));
    return true;
  }

  #says({ start, end, from, to, base }: Token, value: number): boolean {
    const digits = this.#plain.slice(from, to);
    if (end - start > 4) return false;
    return Number.parseInt(digits, 16) === value || (base === 0 && Number.parseInt(digits, 10) === value);
  }

  #isEnglish = ({ from, to }: Token) => to - from < 8 && isEnglish(this.#plain.slice(from, to));

  #isAfterWord = (start: number) => this.#wordEnd >= 0 && start - this.#wordEnd === 1 && !this.#direct;

  /** Ends a run of numbers, before a word at `word` or something else. */
  #endRun(word: number, isName = false): void {
    const odd = this.#oddity;
    this.#oddity = undefined;
    if (odd !== undefined) {
      if (odd.kind === 'left-out' || /\d/.test(this.#plain.slice(odd.start, odd.end))) this.#tokens.push(odd);
      else this.#words++;
    }
    while (word >= 0 && this.#tokens.length > 0) {
      const last = this.#tokens.at(-1) as Token;
      if (last.base !== 0 || word - last.end !== 1 || !this.#isEnglish(last)) break;
      this.#tokens.pop();
      this.#words++;
    }
    if (this.#tokens.some(({ kind }) => kind === 'number')) {
      const tokens = withoutProse(this.#plain, this.#tokens);
      if (tokens.length < this.#tokens.length) this.#words++;
      const isChecksum = this.#isNamed && CHECKSUM.test(this.#name);
      const said = { inParentheses: this.#parentheses > 0, isName, isNamed: this.#isNamed, isChecksum };
      this.#runs.push(run(tokens, said));
      this.#isNamed = false;
    }
    this.#tokens = [];
  }

  /** Ends a section. What stands before the direction of others is not `alone`: it may count or name them. */
  #endSection(isLast = true): void {
    this.#endRun(-1);
    const alone = isLast && this.#words === 0;
    const runs = chooseRuns(this.#runs, alone);
    const tokens = tokensOf(runs);
    if (tokens.length > 0) {
      const own = this.#label;
      this.sections.push({
        label: own.direction === undefined ? { ...this.#inherited, ...own } : own,
        tokens,
        first: this.#first,
        alone,
        certainty: certaintyOf(this.#plain, { tokens, style: runs[0]?.style, alone, direct: this.#direct }),
        continued: alone && own === NO_LABEL && (this.#continued || this.#hanging),
      });
    }
    this.#runs = [];
    this.#first = undefined;
  }
}

const tokensOf = (runs: readonly Run[]): readonly Token[] =>
  runs.length === 1 ? (runs[0] as Run).tokens : runs.flatMap(({ tokens }) => tokens);

/** The sections of a plain text, in order. */
export function sectionsOf(plain: string): readonly Section[] {
  const reader = new SectionReader(plain);
  eachLine(plain, (start, end) => reader.read(plain.slice(start, end), start));
  return reader.sections;
}
