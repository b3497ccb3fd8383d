import { hexDigits } from '../../modbus/index.ts';
import type { Expression, Routine, Scalar } from '../code.ts';
import { overflows, plainText } from '../print.ts';
import { LEVEL, type Printed, type Printer, type Syntax, whole } from '../syntax.ts';
import { cOperators } from './c-like.ts';

const HEX = 16;
const WIDTHS: Readonly<Partial<Record<Scalar, number>>> = { byte: 8, word: 16, dword: 32 };
const TYPES: Readonly<Record<Scalar, string>> = {
  byte: 'int',
  word: 'int',
  dword: 'int',
  int: 'int',
  bool: 'bool',
  real: 'float',
};

const hex = (value: number, bits: number): string => `0x${hexDigits(value, bits / 4)}`;

const masked = (text: string, type: Scalar): Printed => {
  const width = WIDTHS[type] ?? 32;
  return { text: `${text} & ${hex(2 ** width - 1, width)}`, level: LEVEL.bitwise };
};

/** How many bits a value takes at most; `undefined` if it may be negative or anything. */
function bitsOf(of: Expression): number | undefined {
  const width = WIDTHS[of.type];
  if (of.kind === 'binary' && of.operator === '>>' && of.right.kind === 'number' && width !== undefined)
    return width - of.right.value;
  return width;
}

const literal = (value: number, type: Scalar, base: 10 | 16): string => {
  if (type === 'real') return Number.isInteger(value) ? value.toFixed(1) : String(value);
  return base === 16 && value >= 0 ? hex(value, WIDTHS[type] ?? 32) : String(value);
};

/** A text in quotes. JSON escapes quotes, backslashes and line ends as Python does. */
export const pythonText = (text: string): string => JSON.stringify(plainText(text));

/** A text between triple quotes that stands before the last line: no backslash and no quotes of it end them. */
const inDocstring = (text: string): string => plainText(text).replace(/\\/g, '\\\\').replaceAll('"""', '\\"\\"\\"');

/** The lines of a docstring: paragraphs, an empty line between them. */
export function docstring(...paragraphs: readonly (readonly string[])[]): readonly string[] {
  const lines = paragraphs
    .filter((paragraph) => paragraph.length > 0)
    .flatMap((paragraph, at) => [...(at === 0 ? [] : ['']), ...paragraph.map(inDocstring)]);
  const [first = '', ...rest] = lines;
  return rest.length === 0 ? [`"""${first.replace(/"$/, '\\"')}"""`] : [`"""${first}`, ...rest, '"""'];
}

export const pythonType = (type: Scalar, isList: boolean): string => {
  if (!isList) return TYPES[type];
  return type === 'byte' ? 'bytes' : `list[${TYPES[type]}]`;
};

function convert(of: Extract<Expression, { kind: 'convert' }>, printer: Printer): Printed {
  const { type, of: inner } = of;
  if (type === 'real') return whole(`float(${printer.operand(inner, LEVEL.least)})`);
  if (type === 'bool') return { text: `${printer.operand(inner, LEVEL.sum)} != 0`, level: LEVEL.relation };
  const isWhole = inner.type !== 'real';
  const text = isWhole
    ? printer.at(inner, LEVEL.unary)
    : inner.kind === 'floor'
      ? `math.floor(${printer.operand(inner.of, LEVEL.least)})`
      : `int(${printer.operand(inner, LEVEL.least)})`;
  if (inner.type === 'bool') return whole(`int(${text})`);
  const width = WIDTHS[type];
  const bits = isWhole ? bitsOf(inner) : undefined;
  if (width === undefined || (bits !== undefined && bits <= width)) {
    if (!isWhole) return whole(text);
    return overflows(inner)
      ? { text: printer.operand(inner, LEVEL.bitwise), level: LEVEL.bitwise }
      : printer.print(inner);
  }
  return masked(text, type);
}

function heading(routine: Routine, printer: Printer) {
  const parameters = printer.parameters(routine);
  const written = parameters.map(
    ({ name, type, size, filled }) =>
      `${printer.name(name)}: ${filled && type === 'byte' ? 'list[int]' : pythonType(type, size !== undefined)}`,
  );
  const gives = routine.gives.kind === 'frame' ? 'bytes' : TYPES[routine.gives.type];
  const about = parameters.flatMap(({ name, comment }) =>
    comment === '' ? [] : [`${printer.name(name)}: ${comment}`],
  );
  const isFrame = routine.gives.kind === 'frame';
  return {
    before: [`def ${printer.name(routine.name, 'routine')}(${written.join(', ')}) -> ${gives}:`],
    inside: [...(printer.comments ? docstring(routine.about, about) : []), ...(isFrame ? ['frame = bytearray()'] : [])],
    last: isFrame ? ['return bytes(frame)'] : [],
    end: [],
  };
}

/** The element that many places before the end of its array; `undefined` if it is not said so. */
function fromEnd(expression: Expression, printer: Printer): number | undefined {
  if (expression.kind !== 'element' || expression.index.kind !== 'binary') return undefined;
  const { operator, left, right } = expression.index;
  if (operator !== '-' || left.kind !== 'name' || right.kind !== 'number') return undefined;
  const length = printer.routine?.parameters.find(({ lengthOf }) => lengthOf === expression.array);
  return length?.name === left.name && right.value > 0 ? right.value : undefined;
}

/** What Python writes in a way of its own. */
function special(expression: Expression, printer: Printer): Printed | undefined {
  const back = fromEnd(expression, printer);
  if (back !== undefined && expression.kind === 'element') return whole(`${printer.name(expression.array)}[-${back}]`);
  if (expression.kind !== 'binary') return undefined;
  const { operator, type, left, right } = expression;
  if (operator === '/' && type !== 'real') {
    const text = `${printer.operand(left, LEVEL.product)} // ${printer.operand(right, LEVEL.unary)}`;
    return { text, level: LEVEL.product };
  }
  const isZero = right.kind === 'number' && right.value === 0 && right.base === HEX;
  if (isZero && (operator === '=' || operator === '≠')) {
    const text = `${printer.operand(left, LEVEL.sum)} ${printer.syntax.operators[operator]} 0`;
    return { text, level: LEVEL.relation };
  }
  return undefined;
}

const block = (text: string) => ({ head: `${text}:`, end: '' });

export const pythonSyntax = (name: Syntax['name']): Syntax => ({
  name,
  number: ({ value, type, base }) => literal(value, type, base),
  truth: (value) => (value ? 'True' : 'False'),
  operators: { ...cOperators, and: 'and', or: 'or' },
  not: { text: 'not ', level: LEVEL.not },
  convert,
  signed: ({ of }, printer) => {
    const sign = of.type === 'dword' ? 0x8000_0000 : 0x8000;
    const text = hex(sign, WIDTHS[of.type] ?? 16);
    return { text: `(${printer.operand(of, LEVEL.unary)} ^ ${text}) - ${text}`, level: LEVEL.sum };
  },
  float: ({ of }, printer) =>
    whole(`float(struct.unpack(">f", struct.pack(">I", ${printer.operand(of, LEVEL.least)}))[0])`),
  floor: ({ of }, printer) => whole(`float(math.floor(${printer.operand(of, LEVEL.least)}))`),
  soFar: whole('len(frame)'),
  slices: {
    length: (array) => whole(`len(${array})`),
    first: (array, length) => `${array}[:${length.replace(`len(${array}) `, '').replace(/^- /, '-')}]`,
  },
  array: (text, { routine }, array) => (array === 'frame' && routine?.gives.kind === 'frame' ? 'bytes(frame)' : text),
  special,
  fit: (expression, printed) =>
    overflows(expression) && WIDTHS[expression.type] !== undefined
      ? masked(printed.level >= LEVEL.unary ? printed.text : `(${printed.text})`, expression.type)
      : printed,
  declare: ({ name: of, value }, printer) => `${printer.name(of)} = ${printer.slot(value)}`,
  set: (to, value) => `${to} = ${value}`,
  update: (to, value, printer) => {
    if (overflows(value)) return undefined;
    const isWholeDivision = value.operator === '/' && value.type !== 'real';
    const mark = isWholeDivision ? '//' : printer.syntax.operators[value.operator];
    return ['and', 'or', '=', '≠', '<', '≤', '>', '≥'].includes(value.operator)
      ? undefined
      : `${to} ${mark}= ${printer.operand(value.right, LEVEL.least)}`;
  },
  put: (value) => `frame.append(${value})`,
  give: (value) => `return ${value}`,
  when: (condition) => block(`if ${condition}`),
  otherwise: 'else:',
  otherwiseWhen: (condition) => `elif ${condition}:`,
  repeat: ({ name: of, from, to }, printer) => {
    const isFromZero = from.kind === 'number' && from.value === 0;
    const range = isFromZero ? printer.slot(to) : `${printer.slot(from)}, ${printer.slot(to)}`;
    return block(`for ${printer.name(of)} in range(${range})`);
  },
  during: (condition) => block(`while ${condition}`),
  nothing: 'pass',
  comment: (text) => `# ${text}`,
  gap: '  ',
  routine: heading,
  constant: (constant, value, printer) => `${printer.name(constant.name, 'constant')} = ${value}`,
  table: ({ name: of, type }, printer) => {
    const isBytes = type === 'byte';
    return {
      head: `${printer.name(of, 'table')} = ${isBytes ? 'bytes((' : '('}`,
      end: isBytes ? '))' : ')',
      lastMark: true,
    };
  },
  texts: ({ name: of, about, parameter, entries, otherwise }, lines, printer) => {
    const argument = printer.name(parameter);
    lines.add(`def ${printer.name(of, 'routine')}(${argument}: int) -> str:`);
    lines.inside(() => {
      if (printer.comments) for (const line of docstring([about])) lines.add(line);
      lines.add('texts = {');
      lines.inside(() => {
        for (const { number, text } of entries) lines.add(`${number}: ${pythonText(text)},`);
      });
      lines.add('}').add(`return texts.get(${argument}, ${pythonText(otherwise)})`);
    });
  },
});
