import type { Expression, Scalar } from './code.ts';

/** How many bits a number of a type has; of an `int` at least. */
export const WIDTHS: Readonly<Record<Scalar, number>> = { byte: 8, word: 16, dword: 32, int: 32, bool: 1, real: 64 };
/** How many bits a number may have: fewer than its type where it comes from a narrower one. */
const widthOf = (of: Expression): number =>
  of.kind === 'convert' ? Math.min(widthOf(of.of), WIDTHS[of.type]) : WIDTHS[of.type];

/** Whether a language that calculates wider than the type may find bits above it in the value: only shifts to the left make them. */
export const overflows = (expression: Expression): boolean => {
  if (expression.kind !== 'binary') return false;
  const { operator, left, right } = expression;
  if (operator === '<<') return !(right.kind === 'number' && widthOf(left) + right.value <= WIDTHS[expression.type]);
  if (operator === '&') return overflows(left) && overflows(right);
  return (operator === '|' || operator === '^') && (overflows(left) || overflows(right));
};
