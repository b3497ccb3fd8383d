/**
 * A program in no language: what a target prints. It is small, so that it means the same everywhere: whole numbers of fixed
 * width, arrays of known size, loops that end. Nothing here relies on an `and` or `or` that leaves its right side out.
 * @module
 */

/**
 * `byte`, `word` and `dword` are unsigned, of 8, 16 and 32 bits; `int` is signed and has at least 32 bits; `real` is a
 * floating-point number of 64 bits, or of 32 where a target has no more.
 */
export type Scalar = 'byte' | 'word' | 'dword' | 'int' | 'bool' | 'real';

/** Words in lower case with blanks between them, such as `start address`: a target writes them in its own style. */
export type Name = string;

/** Of whole numbers: `int` only, with truncation; nothing negative is divided. All four of `real`. */
export type Arithmetic = '+' | '-' | '*' | '/' | '%';
/** Of `byte`, `word` and `dword`, both sides of one type. */
export type Bitwise = '&' | '|' | '^';
/** The right side is an `int`, less than the width of the left side. What is shifted out is lost. */
export type Shift = '<<' | '>>';
/** Of two numbers of one type; `=` and `≠` also of two of `bool`. */
export type Relation = '=' | '≠' | '<' | '≤' | '>' | '≥';
export type Logical = 'and' | 'or';
export type Operator = Arithmetic | Bitwise | Shift | Relation | Logical;

export type Expression =
  /** `base` 16 is printed in hexadecimal, with all digits of the type. */
  | { readonly kind: 'number'; readonly type: Scalar; readonly value: number; readonly base: 10 | 16 }
  | { readonly kind: 'truth'; readonly type: 'bool'; readonly value: boolean }
  /** A variable, a parameter or a constant. */
  | { readonly kind: 'name'; readonly type: Scalar; readonly name: Name }
  /** An element of an array: a parameter, a variable or a table. `index` is an `int`, from 0. */
  | { readonly kind: 'element'; readonly type: Scalar; readonly array: Name; readonly index: Expression }
  | {
      readonly kind: 'binary';
      readonly type: Scalar;
      readonly operator: Operator;
      readonly left: Expression;
      readonly right: Expression;
    }
  | { readonly kind: 'not'; readonly type: 'bool'; readonly of: Expression }
  /**
   * The same number in another type. To a narrower unsigned type the low bits stay; from `real` to `int` the number is whole
   * already, but for its type.
   */
  | { readonly kind: 'convert'; readonly type: Scalar; readonly of: Expression }
  /** An `int` whose two's complement of 16 bits (of a `word`) or 32 bits (of a `dword`) this is. */
  | { readonly kind: 'signed'; readonly type: 'int'; readonly of: Expression }
  /** A `real` whose IEEE 754 form of 32 bits is this `dword`. */
  | { readonly kind: 'float'; readonly type: 'real'; readonly of: Expression }
  /** The greatest whole number that is not greater, of a `real`, as a `real`. */
  | { readonly kind: 'floor'; readonly type: 'real'; readonly of: Expression }
  /** A routine that returns a number. An argument that is an array is its name. */
  | { readonly kind: 'call'; readonly type: Scalar; readonly routine: Name; readonly arguments: readonly Argument[] }
  /** How many bytes the routine has put into its frame so far, an `int`. Only in a routine that makes a frame. */
  | { readonly kind: 'put so far'; readonly type: 'int' };

/** `frame` as an array is what the routine around has put so far. */
export type Argument = Expression | { readonly kind: 'array'; readonly array: Name };

/** Where a value goes. */
export type Target = Extract<Expression, { readonly kind: 'name' | 'element' }>;

/** What a statement has to do with the frame: the spans, by name, whose bytes it makes or reads; and a remark for a reader. */
interface Remarked {
  readonly spans?: readonly string[] | undefined;
  readonly comment?: string | undefined;
}

export type Statement = Remarked &
  (
    | { readonly kind: 'declare'; readonly name: Name; readonly value: Expression; readonly changes: boolean }
    | { readonly kind: 'set'; readonly to: Target; readonly value: Expression }
    /** Appends a `byte` to the frame that the routine makes. */
    | { readonly kind: 'put'; readonly value: Expression }
    | {
        readonly kind: 'if';
        readonly when: Expression;
        readonly then: readonly Statement[];
        readonly otherwise: readonly Statement[];
      }
    /** `name` is an `int` that goes from `from` up to, but not including, `to`. The body changes neither. */
    | {
        readonly kind: 'for';
        readonly name: Name;
        readonly from: Expression;
        readonly to: Expression;
        readonly body: readonly Statement[];
      }
    | { readonly kind: 'while'; readonly when: Expression; readonly body: readonly Statement[] }
    /** Never in a routine that makes a frame: such a routine ends at its end. */
    | { readonly kind: 'return'; readonly value: Expression }
    /** A line of its own for a reader. */
    | { readonly kind: 'remark'; readonly text: string }
  );

/**
 * `size` makes it an array of this many elements; `filled` says that the routine writes into it. `lengthOf` is the parameter
 * before it whose elements it counts: in a language whose arrays know their length it is no parameter, and a call gives a slice.
 */
export interface Parameter {
  readonly name: Name;
  readonly type: Scalar;
  readonly size?: number | undefined;
  readonly filled?: boolean | undefined;
  readonly lengthOf?: Name | undefined;
  readonly comment: string;
}

export interface Routine {
  readonly name: Name;
  /** What it does, in sentences, each a line. */
  readonly about: readonly string[];
  readonly parameters: readonly Parameter[];
  /**
   * `frame`: it puts bytes, at most `most`, and gives them and their number. Each target gives them as is usual there: as an
   * array and a length that are filled, or as a list that is returned.
   */
  readonly gives: { readonly kind: 'frame'; readonly most: number } | { readonly kind: 'value'; readonly type: Scalar };
  readonly body: readonly Statement[];
}

export interface Constant {
  readonly name: Name;
  readonly type: Scalar;
  readonly value: number;
  readonly base: 10 | 16;
  readonly comment: string;
}

/** An array of constants. `spans`, if it is a frame, has the span of each byte. */
export interface Table {
  readonly name: Name;
  readonly type: Scalar;
  readonly values: readonly number[];
  readonly base: 10 | 16;
  readonly comment: string;
  readonly rows?: readonly TableRow[] | undefined;
}

/** Some of the elements of a table that stand in a line of their own, with what they are. */
export interface TableRow {
  readonly from: number;
  readonly to: number;
  readonly span: string;
  readonly comment: string;
}

/** Texts by number, such as the names of exceptions: a target makes a routine of it that gives the text, or `otherwise`. */
export interface Texts {
  readonly name: Name;
  readonly about: string;
  readonly parameter: Name;
  readonly entries: readonly { readonly number: number; readonly text: string }[];
  readonly otherwise: string;
}

/** What is written into one file, each part before what needs it. */
export interface Code {
  readonly constants: readonly Constant[];
  readonly tables: readonly Table[];
  readonly texts: readonly Texts[];
  readonly routines: readonly Routine[];
}

const DIGITS_16 = 16;

/** A whole number of a type; bytes, words and double words are printed in hexadecimal unless said otherwise. */
export const number = (
  type: Scalar,
  value: number,
  base: 10 | 16 = type === 'byte' || type === 'word' || type === 'dword' ? DIGITS_16 : 10,
): Expression => ({ kind: 'number', type, value, base });

export const int = (value: number): Expression => number('int', value);
export const name = (type: Scalar, of: Name): Extract<Expression, { kind: 'name' }> => ({
  kind: 'name',
  type,
  name: of,
});
export const element = (type: Scalar, array: Name, index: Expression): Extract<Expression, { kind: 'element' }> => ({
  kind: 'element',
  type,
  array,
  index,
});

const TRUTHS: ReadonlySet<Operator> = new Set(['=', '≠', '<', '≤', '>', '≥', 'and', 'or']);

/** `left operator right`; the type is that of the left side, or `bool` of a comparison. */
export const binary = (left: Expression, operator: Operator, right: Expression): Expression => ({
  kind: 'binary',
  type: TRUTHS.has(operator) ? 'bool' : left.type,
  operator,
  left,
  right,
});

/** The number in another type; itself, if it has the type. */
export const convert = (type: Scalar, of: Expression): Expression =>
  of.type === type ? of : { kind: 'convert', type, of };
