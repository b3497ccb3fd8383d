import { hexDigits } from '../../modbus/index.ts';
import type { Expression, Operator, Scalar } from '../code.ts';
import { plainText } from '../print.ts';

/** What languages have in common that write operators as C does. */

export const cOperators: Readonly<Record<Operator, string>> = {
  '+': '+',
  '-': '-',
  '*': '*',
  '/': '/',
  '%': '%',
  '&': '&',
  '|': '|',
  '^': '^',
  '<<': '<<',
  '>>': '>>',
  '=': '==',
  '≠': '!=',
  '<': '<',
  '≤': '<=',
  '>': '>',
  '≥': '>=',
  and: '&&',
  or: '||',
};

const UPDATES: ReadonlySet<Operator> = new Set(['+', '-', '*', '/', '%', '&', '|', '^', '<<', '>>']);

/** Whether `x = x op y` may be written `x op= y`. */
export const isUpdate = (operator: Operator): boolean => UPDATES.has(operator);

const DIGITS: Readonly<Partial<Record<Scalar, number>>> = { byte: 2, word: 4, dword: 8 };

/** A number as C writes it; a real one has a point. */
export function cNumber({
  type,
  value,
  base,
}: Pick<Extract<Expression, { kind: 'number' }>, 'type' | 'value' | 'base'>): string {
  if (type === 'real') return Number.isInteger(value) ? value.toFixed(1) : String(value);
  if (base === 10 || value < 0) return String(value);
  return `0x${hexDigits(value, DIGITS[type] ?? 1)}`;
}

/** A text in double quotes, all in one line. JSON escapes quotes and backslashes as these languages do. */
export const quoted = (text: string): string => JSON.stringify(plainText(text));

export const isUnsigned = (type: Scalar): boolean => DIGITS[type] !== undefined;

/** Whether each value of `from` is one of `to`, both whole numbers. */
export const widens = (from: Scalar, to: Scalar): boolean => {
  const order: readonly Scalar[] = ['byte', 'word', 'dword'];
  if (to === 'int') return from === 'byte' || from === 'word';
  return isUnsigned(from) && isUnsigned(to) && order.indexOf(from) < order.indexOf(to);
};

/** The same text with each line set in. */
export const indented = (text: string, by = '    '): string =>
  text
    .split('\n')
    .map((line) => by + line)
    .join('\n');

/** Calls that tell whether they went well, and the exit code of the program by them. */
export const exitCode = (calls: readonly string[]): string =>
  calls.length === 1
    ? `return ${calls[0]} ? 0 : 1;`
    : [
        'int failures = 0;',
        ...calls.map((call) => `failures += ${call} ? 0 : 1;`),
        'return failures == 0 ? 0 : 1;',
      ].join('\n');
