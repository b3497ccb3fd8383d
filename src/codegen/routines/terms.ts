import {
  type Argument,
  binary,
  convert,
  type Expression,
  element,
  int,
  type Name,
  name,
  number,
  type Scalar,
  type Statement,
} from '../code.ts';

/** What a statement has to do with the frame, and a remark. */
export interface Remarks {
  readonly spans?: readonly string[] | undefined;
  readonly comment?: string | undefined;
}

export const set = (
  to: Extract<Expression, { kind: 'name' | 'element' }>,
  value: Expression,
  remarks: Remarks = {},
): Statement => ({
  kind: 'set',
  to,
  value,
  ...remarks,
});

export const declare = (of: Name, value: Expression, changes: boolean, remarks: Remarks = {}): Statement => ({
  kind: 'declare',
  name: of,
  value,
  changes,
  ...remarks,
});

export const put = (value: Expression, remarks: Remarks = {}): Statement => ({ kind: 'put', value, ...remarks });

export const giveBack = (value: Expression, remarks: Remarks = {}): Statement => ({
  kind: 'return',
  value,
  ...remarks,
});

export const when = (
  condition: Expression,
  then: readonly Statement[],
  otherwise: readonly Statement[] = [],
  remarks: Remarks = {},
): Statement => ({ kind: 'if', when: condition, then, otherwise, ...remarks });

export const loop = (
  of: Name,
  from: Expression,
  to: Expression,
  body: readonly Statement[],
  remarks: Remarks = {},
): Statement => ({ kind: 'for', name: of, from, to, body, ...remarks });

export const call = (type: Scalar, routine: Name, ...given: readonly Argument[]): Expression => ({
  kind: 'call',
  type,
  routine,
  arguments: given,
});

export const array = (of: Name): Argument => ({ kind: 'array', array: of });
export const not = (of: Expression): Expression => ({ kind: 'not', type: 'bool', of });
export const signed = (of: Expression): Expression => ({ kind: 'signed', type: 'int', of });

const isNumber = (of: Expression): of is Extract<Expression, { kind: 'number' }> => of.kind === 'number';

/** The sum of two of `int`; numbers are added at once. */
export function plus(left: Expression, right: Expression): Expression {
  if (isNumber(left) && isNumber(right)) return int(left.value + right.value);
  if (isNumber(right) && right.value === 0) return left;
  if (isNumber(left) && left.value === 0) return right;
  if (isNumber(right) && right.value < 0) return binary(left, '-', int(-right.value));
  if (left.kind === 'binary' && left.operator === '+' && isNumber(left.right) && isNumber(right))
    return plus(left.left, int(left.right.value + right.value));
  if (isNumber(left)) return plus(right, left);
  return binary(left, '+', right);
}

export function times(factor: number, of: Expression): Expression {
  if (isNumber(of)) return int(factor * of.value);
  if (factor === 0) return int(0);
  return factor === 1 ? of : binary(int(factor), '*', of);
}

/** The item of an `int` index, as an `int`. */
export const toInt = (of: Expression): Expression => convert('int', of);

/** Two bytes as a word, the high one first. */
export const wordOf = (high: Expression, low: Expression): Expression =>
  binary(binary(convert('word', high), '<<', int(8)), '|', convert('word', low));

export const highByte = (of: Expression): Expression => convert('byte', binary(of, '>>', int(8)));
export const lowByte = (of: Expression): Expression => convert('byte', of);

export const byte = (value: number): Expression => number('byte', value);

export { element, int, name };
