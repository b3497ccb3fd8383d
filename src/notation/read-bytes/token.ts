/** A number as it stands in the text, or something in a row of numbers that is none. */
export class Token {
  readonly kind: 'number' | 'not-a-byte' | 'left-out';
  readonly start: number;
  readonly end: number;
  /** Its digits; with its prefix and its suffix it is `[start, end)`. */
  readonly from: number;
  readonly to: number;
  /** What its prefix or suffix says; 0 where it has none. */
  readonly base: 0 | 2 | 16;
  /** A sign stands before it. */
  negative = false;
  /** Alone between `[` and `]` or between `<` and `>`. */
  bracket: '' | '[' | '<' = '';
  /** A comma stands before it. */
  comma = false;

  constructor(kind: Token['kind'], start: number, end: number, from: number, to: number, base: Token['base']) {
    this.kind = kind;
    this.start = start;
    this.end = end;
    this.from = from;
    this.to = to;
    this.base = base;
  }
}
