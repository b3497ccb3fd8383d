import type { Name, Parameter, Scalar } from '../../code.ts';
import type { NameKind } from '../../names.ts';

/** In what a language of the IEC 61131-3 family differs from the others. */
export interface Dialect {
  /** What a type is called. */
  readonly types: Readonly<Record<Scalar, string>>;
  /** What it is called in the names of conversions. */
  readonly conversions: (type: Scalar) => string;
  readonly timer: string;
  readonly string: string;
  readonly time: string;
  /** A name as it stands where it is declared (a `type` is a function block), and in front of `:=` in a call. */
  readonly declared: (name: Name, role: NameKind) => string;
  /** A name as it stands in a statement. */
  readonly used: (name: Name, role: NameKind) => string;
  /** What a function gives, where it is set. */
  readonly result: (name: Name) => string;
  readonly comment: (text: string) => string;
  readonly shift: (way: 'SHL' | 'SHR', value: string, by: string) => string;
  /** The number whose IEEE 754 form a double word is; `bits` is its text. */
  readonly float: (bits: string) => string;
  readonly floor: (of: string) => string;
  /** The type of an array of so many elements; `name` is what the type is called where it needs a name. */
  readonly array: (type: Scalar, size: number, name: Name) => string;
  /** Whether an array can have first values where it is declared. */
  readonly arrayValues: boolean;
  /** A table where it is used, if it does not stand among the variables of the function. */
  readonly table: ((name: Name) => string) | undefined;
  /** The line that begins a function or function block, and what follows it. */
  readonly head: (kind: 'FUNCTION' | 'FUNCTION_BLOCK', name: string, gives: string | undefined) => readonly string[];
  /** The section of variables that a function has for itself. */
  readonly locals: 'VAR' | 'VAR_TEMP';
  /** What stands between the variables and the statements. */
  readonly begin: string;
}

/** Arrays of bytes of at least this many elements hold whole frames; they have one type. */
const SHORTEST_FRAME_ARRAY = 253;
export const holdsFrame = ({ type, size = 0, filled = false }: Pick<Parameter, 'type' | 'size' | 'filled'>): boolean =>
  type === 'byte' && size >= SHORTEST_FRAME_ARRAY && !filled;

/** Whether a parameter is passed by reference: what is filled, and frames, so that they are not copied. */
export const byReference = (parameter: Parameter): boolean =>
  parameter.size !== undefined && (parameter.filled === true || holdsFrame(parameter));
