import { hexDigits } from '../../modbus/index.ts';
import type { Code, Expression, Name, Parameter, Routine, Scalar } from '../code.ts';
import { plainText } from '../print.ts';
import { LEVEL, type Printed, type Printer, type Role, type Syntax, whole } from '../syntax.ts';
import { overflows, WIDTHS } from '../width.ts';

/** In what C99 and the C++ of Arduino differ. */
export interface CFamily {
  readonly name: (name: Name, role: Role) => string;
  /** What stands before what only this file uses. */
  readonly own: string;
  readonly real: string;
  readonly int: string;
  /** What ends a number of 32 bits without a sign. */
  readonly dword: string;
  /** How a table stands in memory: what follows the type's name in its declaration, and how an element is read. */
  readonly memory: string;
  readonly read: (type: Scalar, element: string) => string;
  readonly text: { readonly type: string; readonly literal: (text: string) => string };
}

export const cType = (family: Pick<CFamily, 'real' | 'int'>, type: Scalar): string =>
  ({ byte: 'uint8_t', word: 'uint16_t', dword: 'uint32_t', int: family.int, bool: 'bool', real: family.real })[type];

/** A comment to the end of its line. A backslash there, or the trigraph of one, would make the next line part of it. */
export const cComment = (text: string): string => `// ${/(\\|\?\?\/)$/.test(text) ? `${text}.` : text}`;

/** A string. The question marks cannot make a trigraph. */
export const cString = (text: string): string =>
  `"${plainText(text)
    .replace(/["\\]/g, '\\$&')
    .replace(/\?(?=\?)/g, '?""')}"`;

const isWhole = (type: Scalar): boolean => type === 'byte' || type === 'word' || type === 'dword';

/** Whether C converts the number by itself, so that no cast stands there: from few bits to more. */
const isImplied = (of: Expression): of is Extract<Expression, { kind: 'convert' }> =>
  of.kind === 'convert' &&
  ((of.type === 'real' && of.of.type === 'int') ||
    ((of.of.type === 'byte' || of.of.type === 'word') &&
      (of.type === 'int' || (isWhole(of.type) && WIDTHS[of.type] > WIDTHS[of.of.type])))) &&
  !overflows(of.of);

/** Whether the other side has the type of a number of which the cast is left out, or is a literal with which it cannot overflow. */
const carries = (other: Expression, { of }: { readonly of: Expression }): boolean =>
  other.kind !== 'number' || other.type !== 'int' || (of.type === 'byte' && Math.abs(other.value) < 128);

/** Takes casts out that C does not need: on one side, as the other side has the type. */
function withoutCasts(expression: Expression): Expression {
  if (expression.kind !== 'binary' || expression.operator === '<<' || expression.operator === '>>') return expression;
  const { left, right } = expression;
  if (isImplied(right) && carries(left, right)) return { ...expression, right: right.of };
  return isImplied(left) && carries(right, left) ? { ...expression, left: left.of } : expression;
}

const cast = (type: string, of: string): Printed => ({ text: `(${type})${of}`, level: LEVEL.unary });

export function cSyntax(family: CFamily): Syntax {
  const typed = (type: Scalar) => cType(family, type);
  return {
    name: family.name,
    number: ({ type, value, base }) => {
      if (type === 'real') return /[.e]/.test(String(value)) ? String(value) : `${value}.0`;
      const text = base === 16 ? `0x${hexDigits(value, WIDTHS[type] / 4)}` : String(value);
      return type === 'dword' ? text + family.dword : text;
    },
    truth: String,
    operators: {
      ...{ '+': '+', '-': '-', '*': '*', '/': '/', '%': '%', '&': '&', '|': '|', '^': '^', '<<': '<<', '>>': '>>' },
      ...{ '=': '==', '≠': '!=', '<': '<', '≤': '<=', '>': '>', '≥': '>=', and: '&&', or: '||' },
    },
    not: { text: '!', level: LEVEL.unary },
    convert: ({ type, of }, printer) => cast(typed(type), printer.operand(of, LEVEL.unary)),
    signed: ({ of }, printer) => cast(of.type === 'word' ? 'int16_t' : 'int32_t', printer.operand(of, LEVEL.unary)),
    float: ({ of }, printer) => whole(`float_of(${printer.slot(of)})`),
    floor: ({ of }, printer) => whole(`floor(${printer.slot(of)})`),
    soFar: whole('length'),
    special: (expression, printer) => {
      const short = withoutCasts(expression);
      if (short !== expression) return printer.print(short);
      if (expression.kind !== 'element' || family.memory === '' || printer.role(expression.array) !== 'table')
        return undefined;
      return whole(
        family.read(expression.type, `${printer.name(expression.array)}[${printer.slot(expression.index)}]`),
      );
    },
    fit: (expression, printed, where, printer) => {
      if (where === 'slot') return isImplied(expression) ? printer.print(expression.of) : printed;
      return overflows(expression) && expression.type !== 'dword'
        ? cast(typed(expression.type), `(${printed.text})`)
        : printed;
    },
    declare: ({ name, value }, printer) => `${typed(value.type)} ${printer.name(name)} = ${printer.slot(value)};`,
    set: (to, value) => `${to} = ${value};`,
    update: (to, { operator, right }, printer) => {
      if (['=', '≠', '<', '≤', '>', '≥', 'and', 'or'].includes(operator)) return undefined;
      if (operator === '+' && right.kind === 'number' && right.value === 1 && right.type === 'int') return `${to}++;`;
      return `${to} ${operator}= ${printer.slot(right)};`;
    },
    put: (value) => `frame[length++] = ${value};`,
    give: (value) => `return ${value};`,
    when: (condition) => ({ head: `if (${condition}) {`, end: '}' }),
    otherwise: '} else {',
    otherwiseWhen: (condition) => `} else if (${condition}) {`,
    repeat: ({ name, from, to }, printer) => {
      const counter = printer.name(name);
      return {
        head: `for (int ${counter} = ${printer.slot(from)}; ${counter} < ${printer.operand(to, LEVEL.sum)}; ${counter}++) {`,
        end: '}',
      };
    },
    during: (condition) => ({ head: `while (${condition}) {`, end: '}' }),
    comment: cComment,
    routine: (routine, printer) => {
      const frame = routine.gives.kind === 'frame';
      return {
        before: [...aboutRoutine(routine, printer), cHead(family, routine, printer), '{'],
        inside: frame ? ['int length = 0;', ''] : [],
        last: frame ? ['', 'return length;'] : [],
        end: ['}'],
      };
    },
    constant: ({ name }, value, printer) =>
      `#define ${printer.name(name)} ${value.startsWith('-') ? `(${value})` : value}`,
    table: ({ name, type, values, rows }, printer) => ({
      head: `${family.own}const ${typed(type)} ${printer.name(name)}[${values.length}]${rows ? '' : family.memory} = {`,
      end: '};',
    }),
    texts: ({ name, about, parameter, entries, otherwise }, lines, printer) => {
      const { type, literal } = family.text;
      printer.remark(lines, about);
      lines.add(`${family.own}${type}${printer.name(name, 'routine')}(int ${printer.name(parameter)})`).add('{');
      lines.inside(() => {
        lines.add(`switch (${printer.name(parameter)}) {`);
        for (const { number, text } of entries) lines.add(`case ${number}: return ${literal(text)};`);
        lines.add(`default: return ${literal(otherwise)};`).add('}');
      });
      lines.add('}');
    },
  };
}

/** The declaration of a routine, without what ends it. */
export function cHead(family: CFamily, routine: Routine, printer: Printer): string {
  const { gives, name, parameters } = routine;
  const frame = gives.kind === 'frame' ? [`uint8_t frame[${gives.most}]`] : [];
  const list = [...frame, ...parameters.map((parameter) => parameterOf(family, parameter, parameters, printer))];
  const type = gives.kind === 'frame' ? 'int' : cType(family, gives.type);
  return `${family.own}${type} ${printer.name(name, 'routine')}(${list.join(', ') || 'void'})`;
}

/** An array whose length is another parameter is a pointer; one of fixed length says its length. */
function parameterOf(
  family: CFamily,
  { name, type, size, filled }: Parameter,
  all: readonly Parameter[],
  printer: Printer,
): string {
  const text = `${cType(family, type)} `;
  if (size === undefined) return text + printer.name(name);
  const counted = all.some(({ lengthOf }) => lengthOf === name);
  const constant = filled ? '' : 'const ';
  return counted ? `${constant}${text}*${printer.name(name)}` : `${constant}${text}${printer.name(name)}[${size}]`;
}

function aboutRoutine({ about, parameters }: Routine, printer: Printer): readonly string[] {
  if (!printer.comments) return [];
  const said = parameters
    .filter(({ comment }) => comment !== '')
    .map(({ name, comment }) => `  ${printer.name(name)}: ${comment}`);
  return [...about, ...said].map((text) => cComment(text.startsWith('  ') ? `  ${plainText(text)}` : plainText(text)));
}

/** The kinds of expressions and the types that a program has in it, so that what they need is declared. */
export function kindsIn(code: Code): ReadonlySet<string> {
  const found = new Set<string>();
  const look = (value: unknown): void => {
    if (typeof value !== 'object' || value === null) return;
    for (const [key, inside] of Object.entries(value)) {
      if (typeof inside === 'string' && (key === 'kind' || key === 'type')) found.add(inside);
      look(inside);
    }
  };
  look([code.routines, code.tables]);
  return found;
}
