import type { ChunkWord } from './sides.ts';

/** A number as it stands in the text, or something in a row of numbers that is not a number. */
export class Token {
  readonly kind: 'number' | 'not-a-byte' | 'left-out';
  readonly start: number;
  readonly end: number;
  /** Its digits; with its prefix and its suffix it is `[start, end)`. */
  readonly from: number;
  readonly to: number;
  /** What its prefix or suffix says; 0 if it has neither. */
  readonly base: 0 | 2 | 16;
  /** A sign stands before it. */
  negative = false;
  /** Alone between `[` and `]` or between `<` and `>`. */
  bracket: '' | '[' | '<' = '';
  /** A comma stands before it. */
  comma = false;
  /** A comma, a semicolon, a slash or a bar stands before it. */
  parted = false;
  /** It says how many bytes there are. */
  isCount = false;
  /** What a program computes here instead of writing it: `frame[2] = (byte)(address >> 8)`. */
  value: number | undefined = undefined;

  constructor(kind: Token['kind'], start: number, end: number, from: number, to: number, base: Token['base']) {
    this.kind = kind;
    this.start = start;
    this.end = end;
    this.from = from;
    this.to = to;
    this.base = base;
  }
}

/**
 * Anything else in a line: a `word`; a word of the bus that says a `side`; a `time`; the `address` of a network card; other `noise` around bytes; an `oddity`,
 * which may be a misspelt byte; a `label`, the colon or equals sign behind a name; a bracket that `open`s or `close`s; a
 * `comment`, which goes to `end`.
 */
export interface Mark {
  readonly kind: 'word' | 'side' | 'time' | 'address' | 'noise' | 'oddity' | 'label' | 'open' | 'close' | 'comment';
  readonly start: number;
  readonly end: number;
  /** Of a side only. */
  readonly says?: ChunkWord;
}

/** One part of a line. All places are in the text. */
export type Item = Token | Mark;

export const isToken = (item: Item | undefined): item is Token => item instanceof Token;
export const isNumber = (item: Item | undefined): item is Token => item?.kind === 'number';
