import { hexDigits } from '../../../modbus/index.ts';
import type { Name, Operator, Scalar, Statement } from '../../code.ts';
import type { NameRules } from '../../names.ts';
import { plainText } from '../../print.ts';
import { LEVEL, type Printed, type Syntax, whole } from '../../syntax.ts';
import { iecOperators } from '../iec/iec-syntax.ts';
import { iecNames } from '../iec/words.ts';

/**
 * Structured Text of Studio 5000. A routine has no parameters and no variables of its own: all are tags of the program. There
 * are no types without a sign, no typed literals and no SHR: whole numbers are DINT, of which the low bits are used.
 * @module
 */

export const rockwellNames: NameRules = {
  ...iecNames,
  prefixes: undefined,
  reserved: [
    ...iecNames.reserved,
    'COP',
    'JSR',
    'RET',
    'SBR',
    'THIS',
    'S',
    'FS',
    'MSG',
    'GSV',
    'SSV',
    'MOV',
    'BTD',
    'SIZE',
  ],
  most: 40,
};

const OPERATORS: Readonly<Record<Operator, string>> = { ...iecOperators, '<<': '*', '>>': '/' };
const MASKS: Readonly<Partial<Record<Scalar, string>>> = { byte: '16#FF', word: '16#FFFF' };
const SIGN_WORD = '16#8000';
const HALF_WORD = 32_768;

/** The tag of a variable of a routine. */
export type TagOf = (name: Name) => string;

export const typeOf = (type: Scalar): string => (type === 'bool' ? 'BOOL' : type === 'real' ? 'REAL' : 'DINT');

/** What Code has no statement for, such as JSR, is a `return` of a name that stands for its text. */
export class Raws {
  readonly #texts = new Map<string, string>();

  statement(text: string): Statement {
    const name = `raw ${this.#texts.size}`;
    this.#texts.set(name, text);
    return { kind: 'return', value: { kind: 'name', type: 'int', name } };
  }

  of(name: Name): string | undefined {
    return this.#texts.get(name);
  }
}

export function rockwellSyntax(tagOf: TagOf, raws: Raws): Syntax {
  const masked = (text: string, type: Scalar): Printed => {
    const mask = MASKS[type];
    return mask === undefined ? whole(text) : { text: `${text} AND ${mask}`, level: LEVEL.bitwise };
  };
  return {
    name: (name) => raws.of(name) ?? tagOf(name),
    number: ({ type, value, base }) => {
      if (type === 'real') return Number.isInteger(value) ? value.toFixed(1) : String(value);
      return base === 16 ? `16#${hexDigits(value, 2)}` : String(value);
    },
    truth: (value) => (value ? '1' : '0'),
    operators: OPERATORS,
    not: { text: 'NOT ', level: LEVEL.unary },
    convert: ({ type, of }, printer) => {
      if (of.type === 'real' && type !== 'real') return whole(`TRUNC(${printer.at(of, LEVEL.least)})`);
      const narrower = MASKS[type] !== undefined && !(type === 'word' && of.type === 'byte');
      return narrower ? masked(printer.at(of, LEVEL.unary), type) : printer.print(of);
    },
    signed: ({ of }, printer) =>
      of.type === 'word'
        ? { text: `(${printer.at(of, LEVEL.unary)} XOR ${SIGN_WORD}) - ${HALF_WORD}`, level: LEVEL.sum }
        : printer.print(of),
    // Both are hoisted.
    float: () => whole(''),
    floor: () => whole(''),
    soFar: whole(''),
    special: (expression, printer) => {
      if (expression.kind !== 'binary' || (expression.operator !== '<<' && expression.operator !== '>>'))
        return undefined;
      const { left, right, operator, type } = expression;
      const power = right.kind === 'number' ? String(2 ** right.value) : `(2 ** ${printer.at(right, LEVEL.unary)})`;
      const text = `${printer.at(left, LEVEL.unary)} ${operator === '<<' ? '*' : '/'} ${power}`;
      return operator === '>>' ? { text, level: LEVEL.product } : masked(`(${text})`, type);
    },
    declare: ({ name, value }, printer) => `${tagOf(name)} := ${printer.slot(value)};`,
    set: (to, value) => `${to} := ${value};`,
    put: () => '',
    give: (value) => (value === '0' ? 'RET();' : value),
    when: (condition) => ({ head: `IF ${condition} THEN`, end: 'END_IF;' }),
    otherwise: 'ELSE',
    otherwiseWhen: (condition) => `ELSIF ${condition} THEN`,
    repeat: ({ name, from, to }, printer) => ({
      head: `FOR ${tagOf(name)} := ${printer.at(from, LEVEL.least)} TO ${to.kind === 'number' ? to.value - 1 : `${printer.at(to, LEVEL.sum)} - 1`} BY 1 DO`,
      end: 'END_FOR;',
    }),
    during: (condition) => ({ head: `WHILE ${condition} DO`, end: 'END_WHILE;' }),
    comment: (text) => `// ${plainText(text)}`,
    gap: '  ',
    routine: () => ({ before: [], inside: [], last: [], end: [] }),
    constant: () => '',
    table: () => ({ head: '', end: '' }),
    texts: () => {},
  };
}
