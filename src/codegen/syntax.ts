/**
 * What a language has to say so that `Code` can be printed in it.
 * @module
 */
import type {
  Argument,
  Constant,
  Expression,
  Name,
  Operator,
  Parameter,
  Routine,
  Statement,
  Table,
  Texts,
} from './code.ts';
import type { Lines } from './written.ts';

/** How tightly a text binds; a text that binds less than its place asks for stands in parentheses. */
export const LEVEL = {
  least: 0,
  or: 1,
  and: 2,
  not: 3,
  relation: 4,
  bitwise: 5,
  shift: 6,
  sum: 7,
  product: 8,
  unary: 9,
  whole: 10,
} as const;
export type Level = (typeof LEVEL)[keyof typeof LEVEL];

export interface Printed {
  readonly text: string;
  readonly level: Level;
}

export const whole = (text: string): Printed => ({ text, level: LEVEL.whole });

type Of<Kind extends Expression['kind']> = Extract<Expression, { readonly kind: Kind }>;
export type Binary = Of<'binary'>;
export type Role = 'variable' | 'constant' | 'table' | 'routine';

/** The lines around the body of a block. The head may have line ends; an end that is `''` is not written. */
export interface Block {
  readonly head: string;
  readonly end: string;
}

/** A line with what is said about it, and the spans of its bytes. */
export interface Remarked {
  readonly text: string;
  readonly comment?: string | undefined;
  readonly spans?: readonly string[] | undefined;
  /** Whether the lines below stand in another column, where lines are in sections. */
  readonly ends?: boolean | undefined;
}

/** What a language calls for the pieces inside; `CodePrinter` is one. */
export interface Printer {
  readonly syntax: Syntax;
  readonly comments: boolean;
  /** The routine that is being printed. */
  readonly routine: Routine | undefined;
  /** What a name is that stands in an expression. */
  role(name: Name): Role;
  /** A name in the language's style; the role is found if it is that of a constant or table, and `variable` otherwise. */
  name(name: Name, role?: Role): string;
  print(expression: Expression): Printed;
  /** The text for a place that asks for at least this level. */
  at(expression: Expression, least: Level): string;
  /** The text of an operand that must have no bits above its type, for a place that asks for at least this level. */
  operand(expression: Expression, least: Level): string;
  /** The text of a value that goes into a variable, an argument or a frame. */
  slot(expression: Expression): string;
  argument(argument: Argument): string;
  /** The parameters that the language writes: without the lengths of arrays that know theirs. */
  parameters(routine: Routine): readonly Parameter[];
  statements(lines: Lines, statements: readonly Statement[]): void;
  /** Lines with their comments after them, one below the other; a comment that finds no room stands before its line. */
  aligned(lines: Lines, of: readonly Remarked[]): void;
  /** Comments, each in a line of its own. */
  remark(lines: Lines, ...texts: readonly string[]): void;
}

/** A language: what it writes for each piece of `Code`. `printer` gives the texts of the pieces inside. */
export interface Syntax {
  readonly name: (name: Name, role: Role) => string;
  readonly number: (number: Of<'number'>) => string;
  readonly truth: (value: boolean) => string;
  readonly operators: Readonly<Record<Operator, string>>;
  readonly not: Printed;
  readonly convert: (of: Of<'convert'>, printer: Printer) => Printed;
  readonly signed: (of: Of<'signed'>, printer: Printer) => Printed;
  readonly float: (of: Of<'float'>, printer: Printer) => Printed;
  readonly floor: (of: Of<'floor'>, printer: Printer) => Printed;
  readonly soFar: Printed;
  /**
   * Where arrays know their length: the length of one, and the first elements of one, as texts that bind tightly. A parameter
   * that is the length of an array is then none, and a call gives no such argument.
   */
  readonly slices?: {
    readonly length: (array: string) => Printed;
    readonly first: (array: string, length: string, of: Expression, printer: Printer) => string;
  };
  /** An array that is given to a routine; `name` is as the language writes it. */
  readonly array?: (name: string, printer: Printer, array: Name) => string;
  /** Prints an expression in a way of its own, such as `SHR(crc, 1)`; `undefined` for those that are printed as usual. */
  readonly special?: (expression: Expression, printer: Printer) => Printed | undefined;
  /**
   * Brings a value to the width of its type where that matters: as the operand of something that would show higher bits
   * (`operand`), or in a variable, an argument or a frame (`slot`). `overflows` says whether there can be any.
   */
  readonly fit?: (expression: Expression, printed: Printed, where: 'operand' | 'slot', printer: Printer) => Printed;

  readonly declare: (statement: Extract<Statement, { kind: 'declare' }>, printer: Printer) => string;
  readonly set: (to: string, value: string) => string;
  /** `x = x + y` in short, such as `x += y;`; `undefined` where the language does not write it so. */
  readonly update?: (to: string, value: Binary, printer: Printer) => string | undefined;
  readonly put: (value: string, printer: Printer, of: Expression) => string;
  readonly give: (value: string, printer: Printer) => string;
  /** What gives the value at the end of a routine; `give` by default. */
  readonly giveLast?: (value: string) => string;
  readonly when: (condition: string) => Block;
  readonly otherwise: string;
  readonly otherwiseWhen: (condition: string) => string;
  readonly repeat: (statement: Extract<Statement, { kind: 'for' }>, printer: Printer) => Block;
  readonly during: (condition: string) => Block;
  /** What stands in a body without statements, such as `pass`. */
  readonly nothing?: string;

  /** A comment in a line of its own or after a statement. The text has no line end and no control character. */
  readonly comment: (text: string) => string;
  /** What parts a comment from the statement before it; a blank by default. */
  readonly gap?: string;
  /** Whether a line without a comment ends the lines whose comments stand one below the other. */
  readonly sections?: boolean;
  /** The lines around all constants; what stands before the mark is made as wide for all. */
  readonly constants?: Block & { readonly mark: string };
  /** The lines around a routine's body, those of `inside` set in with it. */
  readonly routine: (
    routine: Routine,
    printer: Printer,
  ) => { before: readonly string[]; inside: readonly string[]; last: readonly string[]; end: readonly string[] };
  readonly constant: (constant: Constant, value: string, printer: Printer) => string;
  /** `lastMark`: a comma follows the last element, too. */
  readonly table: (table: Table, printer: Printer) => Block & { readonly lastMark?: boolean };
  /** An element of a table, where it is not written as any number. */
  readonly element?: (number: Of<'number'>, table: Table) => string | undefined;
  readonly texts: (texts: Texts, lines: Lines, printer: Printer) => void;
}
