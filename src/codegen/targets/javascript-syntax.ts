import type { Expression, Routine, Scalar } from '../code.ts';
import { plainText } from '../print.ts';
import { LEVEL, type Printed, type Printer, type Syntax, whole } from '../syntax.ts';
import { overflows, WIDTHS } from '../width.ts';
import { cNumber, cOperators, isUnsigned, isUpdate, quoted } from './c-like.ts';

const TYPES: Readonly<Record<Scalar, string>> = {
  byte: 'number',
  word: 'number',
  dword: 'number',
  int: 'number',
  bool: 'boolean',
  real: 'number',
};

export const javascriptType = (type: Scalar, isList: boolean): string => {
  if (!isList) return TYPES[type];
  return type === 'byte' ? 'Uint8Array' : `${TYPES[type]}[]`;
};

const enclosed = ({ text, level }: Printed): string => (level >= LEVEL.unary ? text : `(${text})`);

/** The low bits of a text. Operators on bits give numbers of 32 bits with a sign, which `>>> 0` takes away. */
const masked = (text: string, type: Scalar): Printed =>
  type === 'dword'
    ? { text: `${text} >>> 0`, level: LEVEL.shift }
    : { text: `${text} & 0x${'FF'.repeat(WIDTHS[type] / 8)}`, level: LEVEL.bitwise };

/** How many bits a value takes at most; `undefined` if it may be negative or a fraction. */
function bitsOf(of: Expression): number | undefined {
  if (!isUnsigned(of.type)) return undefined;
  const shifted = of.kind === 'binary' && of.operator === '>>' && of.right.kind === 'number' ? of.right.value : 0;
  return WIDTHS[of.type] - shifted;
}

/** Text that cannot end a comment in `/** … *\/`. */
const inComment = (text: string): string => plainText(text).replaceAll('*/', '* /');

/** A comment before a function; empty if there is nothing to say. */
export const jsdoc = (texts: readonly string[]): readonly string[] =>
  texts.length === 1 && texts[0] !== undefined
    ? [`/** ${inComment(texts[0])} */`]
    : ['/**', ...texts.map((text) => ` * ${inComment(text)}`), ' */'];

function convert(of: Extract<Expression, { kind: 'convert' }>, printer: Printer): Printed {
  const { type, of: inner } = of;
  if (inner.type === 'bool') return whole(`Number(${printer.operand(inner, LEVEL.least)})`);
  if (type === 'bool') return { text: `${printer.operand(inner, LEVEL.sum)} !== 0`, level: LEVEL.relation };
  const isFraction = inner.type === 'real' && type !== 'real';
  const cut = (): string => {
    if (inner.kind === 'floor') return printer.at(inner, LEVEL.unary);
    return isFraction ? `Math.trunc(${printer.operand(inner, LEVEL.least)})` : printer.at(inner, LEVEL.unary);
  };
  if (!isUnsigned(type)) {
    if (isFraction) return whole(cut());
    return overflows(inner) || inner.type === 'dword'
      ? whole(printer.operand(inner, LEVEL.unary))
      : printer.print(inner);
  }
  const bits = isFraction ? undefined : bitsOf(inner);
  if (bits === undefined || bits > WIDTHS[type]) return masked(cut(), type);
  return overflows(inner) ? whole(printer.operand(inner, LEVEL.unary)) : printer.print(inner);
}

/** What JavaScript writes in a way of its own. */
function special(expression: Expression, printer: Printer): Printed | undefined {
  if (expression.kind !== 'binary') return undefined;
  const { operator, type, left, right } = expression;
  if (operator === '/' && type !== 'real')
    return whole(`Math.trunc(${printer.operand(left, LEVEL.product)} / ${printer.operand(right, LEVEL.unary)})`);
  const isZero = right.kind === 'number' && right.value === 0 && right.base !== 10;
  if (!isZero || (operator !== '=' && operator !== '≠')) return undefined;
  const text = `${printer.operand(left, LEVEL.sum)} ${printer.syntax.operators[operator]} 0`;
  return { text, level: LEVEL.relation };
}

function heading(routine: Routine, printer: Printer) {
  const parameters = printer.parameters(routine);
  const isFrame = routine.gives.kind === 'frame';
  const gives = routine.gives.kind === 'frame' ? 'Uint8Array' : TYPES[routine.gives.type];
  const about = [
    ...routine.about,
    ...parameters.map(
      ({ name, type, size, comment }) =>
        `@param {${javascriptType(type, size !== undefined)}} ${printer.name(name)} ${comment}`,
    ),
    `@returns {${gives}}`,
  ];
  const written = parameters.map(({ name }) => printer.name(name)).join(', ');
  return {
    before: [
      ...(printer.comments ? jsdoc(about) : []),
      `export function ${printer.name(routine.name, 'routine')}(${written}) {`,
    ],
    inside: isFrame ? ['const frame = [];'] : [],
    last: isFrame ? ['return Uint8Array.from(frame);'] : [],
    end: ['}'],
  };
}

const block = (text: string) => ({ head: `${text} {`, end: '}' });
const isBitwise = (of: Expression): boolean => of.kind === 'binary' && ['&', '|', '^', '<<'].includes(of.operator);

export const javascriptSyntax = (name: Syntax['name']): Syntax => ({
  name,
  number: cNumber,
  truth: String,
  operators: { ...cOperators, '=': '===', '≠': '!==', '>>': '>>>' },
  not: { text: '!', level: LEVEL.unary },
  convert,
  signed: ({ of }, printer) => {
    const text = printer.at(of, LEVEL.unary);
    return of.type === 'dword'
      ? { text: `${text} | 0`, level: LEVEL.bitwise }
      : { text: `(${text} << 16) >> 16`, level: LEVEL.shift };
  },
  float: ({ of }, printer) => whole(`new Float32Array(Uint32Array.of(${printer.operand(of, LEVEL.least)}).buffer)[0]`),
  floor: ({ of }, printer) => whole(`Math.floor(${printer.operand(of, LEVEL.least)})`),
  soFar: whole('frame.length'),
  array: (text, { routine }, array) => (array === 'frame' && routine?.gives.kind === 'frame' ? 'frame' : text),
  slices: {
    length: (array) => whole(`${array}.length`),
    first: (array, length) => `${array}.subarray(0, ${length})`,
  },
  special,
  fit: (expression, printed) =>
    overflows(expression) || (expression.type === 'dword' && isBitwise(expression))
      ? masked(enclosed(printed), expression.type)
      : printed,
  declare: ({ name: of, value, changes }, printer) =>
    `${changes ? 'let' : 'const'} ${printer.name(of)} = ${printer.slot(value)};`,
  set: (to, value) => `${to} = ${value};`,
  update: (to, value, printer) => {
    const isOwn = value.operator === '/' || (value.type === 'dword' && isBitwise(value)) || overflows(value);
    if (isOwn || !isUpdate(value.operator)) return undefined;
    return `${to} ${printer.syntax.operators[value.operator]}= ${printer.operand(value.right, LEVEL.least)};`;
  },
  put: (value) => `frame.push(${value});`,
  give: (value) => `return ${value};`,
  when: (condition) => block(`if (${condition})`),
  otherwise: '} else {',
  otherwiseWhen: (condition) => `} else if (${condition}) {`,
  repeat: ({ name: of, from, to }, printer) => {
    const index = printer.name(of);
    return block(
      `for (let ${index} = ${printer.slot(from)}; ${index} < ${printer.operand(to, LEVEL.sum)}; ${index}++)`,
    );
  },
  during: (condition) => block(`while (${condition})`),
  comment: (text) => `// ${text}`,
  routine: heading,
  constant: (constant, value, printer) => `const ${printer.name(constant.name, 'constant')} = ${value};`,
  table: ({ name: of, type }, printer) => {
    const isBytes = type === 'byte';
    const head = `const ${printer.name(of, 'table')} = ${isBytes ? 'Uint8Array.of(' : '['}`;
    return { head, end: isBytes ? ');' : '];', lastMark: true };
  },
  texts: ({ name: of, about, parameter, entries, otherwise }, lines, printer) => {
    const argument = printer.name(parameter);
    if (printer.comments) {
      const given = [about, `@param {number} ${argument}`, '@returns {string}'];
      for (const line of jsdoc(given)) lines.add(line);
    }
    lines.add(`export function ${printer.name(of, 'routine')}(${argument}) {`).inside(() => {
      lines.add('const texts = new Map([').inside(() => {
        for (const { number, text } of entries) lines.add(`[${number}, ${quoted(text)}],`);
      });
      lines.add(']);').add(`return texts.get(${argument}) ?? ${quoted(otherwise)};`);
    });
    lines.add('}');
  },
});
