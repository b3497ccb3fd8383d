import { type Certainty, certaintyOf } from './certainty.ts';
import { type Clause, clausesOf, type Hint, NO_LABEL } from './clauses.ts';
import { type Item, isNumber, type Token } from './items.ts';
import type { Line } from './plain-text.ts';
import { chooseRuns, type Run } from './runs.ts';
import { scanLine } from './scan-line.ts';
import type { ChunkLabel } from './types.ts';

/** A line of the text, or the part of it that one direction governs, with the numbers that may be its bytes. */
export interface Section {
  readonly label: ChunkLabel;
  readonly tokens: readonly Token[];
  /** All its runs of numbers, those that are not its bytes too. */
  readonly runs: readonly Run[];
  /** The first number of the line, where the line begins with it: perhaps an offset. */
  readonly first: Token | undefined;
  readonly certainty: Certainty;
  /** Nothing but numbers and what is known around them stands there. */
  readonly alone: boolean;
  /** It goes on with the section before: a bracket that an earlier line opened holds it, or it is indented more. */
  readonly continued: boolean;
  readonly hint: Hint;
  /** What stands before its bytes tells two directions apart, if the text has both: `[` and `<`, `->` and `<-`, `S:` and `R:`. */
  readonly mark: string;
  readonly isComment: boolean;
  readonly line: Line;
}

/** A heading that ends like this speaks of what follows behind empty lines too. */
const HEADING = /:\s*\**$|^\d{6}: [^:]{1,40}, [\d:. +]+$/;
/** Between a heading and its bytes Node-RED says what they are: `msg.payload : buffer[8]`. */
const BETWEEN = /^\s*msg\.\w+ : buffer\[\d+\]/i;

/** What tells directions apart at the beginning of a line. */
const MARK = /^[<>]/;
/** The same behind a time, and a letter that is a label. */
const BEFORE_BYTES = /(?:[\d\]Z)]\s{1,4}|^)([<>»«])$|(?:^|[\s[(])([AIMOQRS])(?: ?-{1,3}> ?[MS])?[:\])]:?$/;
/** The same at the beginning of a heading. */
const HEADING_MARK = /^[<>](?=\s)/;
const LEAD = 24;
/** Bytes of a full row of a dump. */
const FULL = 16;
/** The most digits of a number that is one byte. */
const DIGITS = 3;

/** A label with what the lines before have said: all of it, or the time if both say a direction. */
function inherit(label: ChunkLabel, before: ChunkLabel): ChunkLabel {
  if (label.direction === undefined) return { ...before, ...label };
  if (label.time !== undefined || before.time === undefined || before.direction !== undefined) return label;
  return { ...label, time: before.time };
}

/** Takes the lines one after the other and makes sections of them. */
class SectionReader {
  readonly sections: Section[] = [];
  readonly numbers: Token[] = [];
  readonly addresses: Item[] = [];
  readonly #plain: string;
  /** No bytes have been found since a bracket was left open. */
  #opens = false;
  /** How many brackets earlier lines have left open. */
  #brackets = 0;
  /** How far the latest line with a label is indented; the lines below that are indented more go on with it. */
  #indent = Number.POSITIVE_INFINITY;
  /** The line before was such a one, or has the label itself. */
  #hangs = false;
  /** Of a line that has a label and no bytes, which may be those of the next. */
  #inherited: ChunkLabel = NO_LABEL;
  /** Of such a line that has a time. */
  #inheritedMark = '';

  constructor(plain: string) {
    this.#plain = plain;
  }

  read(line: Line): void {
    const text = this.#plain.slice(line.start, line.end);
    const items = scanLine(text, line.start);
    for (const item of items) if (isNumber(item)) this.numbers.push(item);
    const [only] = items;
    if (items.length === 1 && isNumber(only) && only.to - only.from <= DIGITS && this.#addToColumn(only, text)) return;
    const indent = text.length - text.trimStart().length;
    if (indent === text.length || items.length === 0) {
      this.#indent = Number.POSITIVE_INFINITY;
      if (this.#inherited !== NO_LABEL && !HEADING.test(this.#heading)) this.#inherited = NO_LABEL;
      if (this.#inherited === NO_LABEL) this.#inheritedMark = '';
      return;
    }
    if (this.#inherited !== NO_LABEL && BETWEEN.test(text)) return;
    const clauses = clausesOf(this.#plain, items);
    const isHanging = this.#hangs && indent > this.#indent;
    const isHeld = this.#brackets > 0 && !this.#opens;
    const isRow = this.#isRow(line);
    const before = this.sections.length;
    for (const clause of clauses) this.#add(clause, line, isHeld || isHanging || isRow, false);
    const hasBytes = this.sections.length > before;
    for (const item of items) {
      if (item.kind === 'comment') this.#addComment(item, line);
      if (item.kind === 'address') this.addresses.push(item);
    }
    const last = clauses.at(-1);
    this.#count(items, clauses.length === 1 && last?.alone === true && last.label === NO_LABEL, hasBytes);
    const hasSure = this.sections.slice(before).some(({ certainty }) => certainty === 3);
    this.#goOn(indent, last?.label ?? NO_LABEL, hasSure);
    this.#heading = text;
    this.#inheritedMark = hasSure || last?.label.time === undefined ? '' : (HEADING_MARK.exec(text)?.[0] ?? '');
    const added = this.sections.at(-1);
    this.#column = undefined;
    if (
      items.length === 1 &&
      isNumber(only) &&
      only.to - only.from <= DIGITS &&
      added?.tokens.length === 1 &&
      !MARK.test(text)
    ) {
      this.#numbers = [only];
      this.#column = { ...added, tokens: this.#numbers };
      this.sections[this.sections.length - 1] = this.#column;
    }
  }

  #heading = '';

  /** Whether a line goes on with a full row of a dump without offsets, as its column of characters shows. */
  #isRow(line: Line): boolean {
    const last = this.sections.at(-1);
    if (!line.hasColumn || last === undefined || !last.line.hasColumn || last.line.after !== line.start) return false;
    return last.alone && last.tokens.reduce((sum, { from, to }) => sum + ((to - from + 1) >> 1), 0) === FULL;
  }

  /** Adds a number that is all of its line to those of the lines before that are such too: bytes one below the other. */
  #addToColumn(token: Token, text: string): boolean {
    const last = this.sections.at(-1);
    if (last === undefined || last !== this.#column || this.#inherited !== NO_LABEL || MARK.test(text)) return false;
    this.#numbers.push(token);
    return true;
  }

  /** The section of a line that is one number, and its numbers. */
  #column: Section | undefined;
  #numbers: Token[] = [];

  #add(
    { label, runs, first, alone, direct, hint, arrow }: Clause,
    line: Line,
    goesOn: boolean,
    isComment: boolean,
  ): void {
    const chosen = chooseRuns(runs, alone);
    const tokens = chosen.length === 1 ? (chosen[0] as Run).tokens : chosen.flatMap((one) => one.tokens);
    if (tokens.length === 0) return;
    this.sections.push({
      label: this.#inherited === NO_LABEL ? label : inherit(label, this.#inherited),
      tokens,
      runs,
      first,
      certainty: certaintyOf(this.#plain, { tokens, runs: chosen, alone, direct }),
      alone,
      continued: alone && label === NO_LABEL && goesOn,
      hint,
      mark: this.#markOf(line, tokens, arrow),
      isComment,
      line,
    });
  }

  #markOf({ start }: Line, [first]: readonly Token[], arrow: Clause['arrow']): Section['mark'] {
    if (first !== undefined && first.bracket !== '') return first.bracket;
    const end = first?.start ?? start;
    const before = BEFORE_BYTES.exec(this.#plain.slice(Math.max(start, end - LEAD), end).trimEnd());
    const behind = before?.[1] ?? before?.[2];
    if (behind !== undefined) return behind;
    if (arrow !== undefined) return arrow === 'tx' ? '->' : '<-';
    const sign = this.#plain[start];
    return sign === '>' || (sign === '<' && /[\s0-9a-f]/i.test(this.#plain[start + 1] ?? ''))
      ? sign
      : this.#inheritedMark;
  }

  /** A comment behind other items of its line. */
  #addComment({ start, end }: Item, line: Line): void {
    const items = scanLine(this.#plain.slice(start, end), start, true);
    for (const item of items) if (isNumber(item)) this.numbers.push(item);
    for (const clause of clausesOf(this.#plain, items)) this.#add(clause, line, false, true);
  }

  /** Counts the brackets of a line. One that a sentence leaves open holds nothing. */
  #count(items: readonly Item[], isBare: boolean, hasBytes: boolean): void {
    const before = this.#brackets;
    for (const { kind, start } of items) {
      if (kind !== 'open' && kind !== 'close') continue;
      if (!'[]{}'.includes(this.#plain[start] ?? ' ')) continue;
      this.#brackets = Math.max(0, this.#brackets + (kind === 'open' ? 1 : -1));
    }
    if (!isBare) this.#brackets = Math.max(0, this.#brackets - before);
    if (this.#brackets > before) this.#opens = !hasBytes;
    else if (hasBytes) this.#opens = false;
  }

  /** Prepares for the next line, by what was found in this one. */
  #goOn(indent: number, label: ChunkLabel, hasBytes: boolean): void {
    // What a line says of its own bytes is added to the time of the line before: a time, and below it `TX:`.
    this.#inherited = hasBytes ? NO_LABEL : label.direction === undefined ? label : inherit(label, this.#inherited);
    const isLabelled = label.direction !== undefined || label.time !== undefined;
    if (isLabelled || indent <= this.#indent) this.#indent = isLabelled ? indent : Number.POSITIVE_INFINITY;
    this.#hangs = hasBytes && this.#indent < Number.POSITIVE_INFINITY;
  }
}

/** The sections of a plain text, in order, and all numbers and addresses of network cards in it. */
export function sectionsOf(
  plain: string,
  lines: readonly Line[],
  tell: (done: number) => void,
): Readonly<
  Record<'sections', readonly Section[]> & Record<'numbers', readonly Token[]> & Record<'addresses', readonly Item[]>
> {
  const reader = new SectionReader(plain);
  lines.forEach((line, index) => {
    reader.read(line);
    tell(index / lines.length);
  });
  return reader;
}
