import type { Code, Expression, Name, Parameter, Routine, Scalar } from '../code.ts';
import { plainText } from '../print.ts';
import { LEVEL, type Printed, type Printer, type Syntax, whole } from '../syntax.ts';
import { overflows } from '../width.ts';
import { cNumber, cOperators, isUpdate, quoted, widens } from './c-like.ts';

/** Java has no unsigned numbers: they are held in wider ones, but for arrays of bytes. */
const TYPES: Readonly<Record<Scalar, string>> = {
  byte: 'int',
  word: 'int',
  dword: 'long',
  int: 'int',
  bool: 'boolean',
  real: 'double',
};
const MASKS: Readonly<Partial<Record<Scalar, string>>> = { byte: '0xFF', word: '0xFFFF', dword: '0xFFFFFFFFL' };

const MOST_SIGNED = 0x7f;

/** What is filled for the program itself is not of bytes, as those have a sign. */
export const javaType = ({ type, size, filled }: Pick<Parameter, 'type' | 'size' | 'filled'>): string =>
  size === undefined ? TYPES[type] : `${type === 'byte' && !filled ? 'byte' : TYPES[type]}[]`;

const masked = (text: string, type: Scalar): Printed => ({ text: `${text} & ${MASKS[type]}`, level: LEVEL.bitwise });
const cast = (type: string, text: string): Printed => ({ text: `(${type}) ${text}`, level: LEVEL.unary });

/** How many bits a shift to the right leaves of a word. */
const isByte = (of: Expression): boolean =>
  of.type === 'byte' ||
  (of.kind === 'binary' &&
    of.operator === '>>' &&
    of.type === 'word' &&
    of.right.kind === 'number' &&
    of.right.value >= 8);

/** Text of a comment, in which neither the end of a comment nor `\u` nor HTML or a tag can stand. */
export const javaComment = (text: string): string => plainText(text).replace(/\\(?=u)/g, '\\ ');
const javadoc = (text: string): string =>
  javaComment(text).replace(/[&<>@*]/g, (character) => `&#${character.charCodeAt(0)};`);

export function javaDocumentation(
  about: readonly string[],
  parameters: readonly (readonly [string, string])[] = [],
): readonly string[] {
  const tags = parameters.flatMap(([name, comment]) => (comment === '' ? [] : [`@param ${name} ${javadoc(comment)}`]));
  const lines = [...about.map(javadoc), ...(tags.length > 0 ? ['', ...tags] : [])];
  if (lines.length === 1) return [`/** ${lines[0]} */`];
  return ['/**', ...lines.map((line) => ` * ${line}`.trimEnd()), ' */'];
}

function heading(routine: Routine, printer: Printer) {
  const { name, parameters, gives, about } = routine;
  const list = parameters.map((parameter) => `${javaType(parameter)} ${printer.name(parameter.name)}`).join(', ');
  const said = parameters.map((parameter) => [printer.name(parameter.name), parameter.comment] as const);
  const isFrame = gives.kind === 'frame';
  const type = isFrame ? 'byte[]' : TYPES[gives.type];
  return {
    before: [
      ...(printer.comments ? javaDocumentation(about, said) : []),
      `static ${type} ${printer.name(name, 'routine')}(${list}) {`,
    ],
    inside: isFrame ? [`byte[] frame = new byte[${gives.most}];`, 'int length = 0;'] : [],
    last: isFrame ? ['return frame;'] : [],
    end: ['}'],
  };
}

function convert({ type, of }: Extract<Expression, { kind: 'convert' }>, printer: Printer): Printed {
  if (type === 'real') return cast('double', printer.operand(of, LEVEL.unary));
  if (of.type === 'real') return cast(TYPES[type], printer.at(of, LEVEL.unary));
  if (type === 'int' && of.type === 'dword') return cast('int', printer.at(of, LEVEL.unary));
  if (type === 'dword' && of.type !== 'int') return cast('long', printer.operand(of, LEVEL.unary));
  if (widens(of.type, type) || (type === 'byte' && isByte(of)))
    return overflows(of) ? masked(printer.at(of, LEVEL.unary), of.type) : printer.print(of);
  const low = masked(printer.at(of, LEVEL.unary), type);
  return of.type === 'dword' ? cast('int', `(${low.text})`) : low;
}

const byteNumber = (of: Extract<Expression, { kind: 'number' }>): string =>
  of.value > MOST_SIGNED ? `(byte) ${cNumber(of)}` : cNumber(of);

/** A byte of a frame. */
function byteOf(of: Expression, printer: Printer): string {
  if (of.kind === 'number') return byteNumber(of);
  const inner = of.kind === 'convert' && of.type === 'byte' ? of.of : of;
  return `(byte) ${printer.at(inner, LEVEL.unary)}`;
}

type Element = Extract<Expression, { kind: 'element' }>;

/** Tables of bytes that are sent are arrays of bytes, others arrays of `int`. */
export const javaSyntax = (name: Syntax['name'], { tables }: Pick<Code, 'tables'>): Syntax => {
  const element = (of: Element, printer: Printer) => `${printer.name(of.array)}[${printer.slot(of.index)}]`;
  /** Whether it is an element of an array of bytes, which have a sign. */
  const isSigned = ({ type, array }: Element, { routine }: Printer): boolean =>
    type === 'byte' &&
    !ofInts.has(array) &&
    !routine?.parameters.some(({ name: of, filled }) => of === array && filled);
  const ofInts: ReadonlySet<Name> = new Set(tables.filter(({ rows }) => rows === undefined).map((table) => table.name));
  return {
    name,
    number: (number) => cNumber(number) + (number.type === 'dword' ? 'L' : ''),
    truth: String,
    operators: cOperators,
    not: { text: '!', level: LEVEL.unary },
    convert,
    signed: ({ of }, printer) => cast(of.type === 'dword' ? 'int' : 'short', printer.at(of, LEVEL.unary)),
    float: ({ of }, printer) => whole(`Float.intBitsToFloat((int) ${printer.at(of, LEVEL.unary)})`),
    floor: ({ of }, printer) => whole(`Math.floor(${printer.slot(of)})`),
    soFar: whole('length'),
    special: (expression, printer) => {
      const signed = (of: Expression): string | undefined =>
        of.kind === 'element' && isSigned(of, printer) ? element(of, printer) : undefined;
      if (expression.kind === 'binary') {
        const { operator, left, right } = expression;
        const [first, second] = [signed(left), signed(right)];
        // The signs are alike, or masked.
        if (first !== undefined && second !== undefined && (operator === '=' || operator === '≠'))
          return { text: `${first} ${cOperators[operator]} ${second}`, level: LEVEL.relation };
        if (first !== undefined && operator === '&' && right.kind === 'number')
          return { text: `${first} & ${cNumber(right)}`, level: LEVEL.bitwise };
      }
      const own = signed(expression);
      return own === undefined ? undefined : masked(own, 'byte');
    },
    fit: (expression, printed) => (overflows(expression) ? masked(`(${printed.text})`, expression.type) : printed),
    declare: ({ name: of, value }, printer) => `${TYPES[value.type]} ${printer.name(of)} = ${printer.slot(value)};`,
    set: (to, value) => `${to} = ${value};`,
    update: (to, value, printer) => {
      const { operator, right } = value;
      if (!isUpdate(operator) || overflows(value)) return undefined;
      const isOne = right.kind === 'number' && right.value === 1 && (operator === '+' || operator === '-');
      return isOne ? `${to}${operator}${operator};` : `${to} ${cOperators[operator]}= ${printer.slot(right)};`;
    },
    put: (_, printer, of) => `frame[length++] = ${byteOf(of, printer)};`,
    give: (value) => `return ${value};`,
    when: (condition) => ({ head: `if (${condition}) {`, end: '}' }),
    otherwise: '} else {',
    otherwiseWhen: (condition) => `} else if (${condition}) {`,
    repeat: ({ name: of, from, to }, printer) => {
      const counter = printer.name(of);
      const until = printer.operand(to, LEVEL.sum);
      return { head: `for (int ${counter} = ${printer.slot(from)}; ${counter} < ${until}; ${counter}++) {`, end: '}' };
    },
    during: (condition) => ({ head: `while (${condition}) {`, end: '}' }),
    comment: (text) => `// ${javaComment(text)}`,
    routine: heading,
    constant: ({ name: of, type }, value, printer) =>
      `static final ${TYPES[type]} ${printer.name(of, 'constant')} = ${value};`,
    table: ({ name: of, type, rows }, printer) => ({
      head: `static final ${javaType({ type: type === 'byte' && !rows ? 'int' : type, size: 0 })} ${printer.name(of, 'table')} = {`,
      end: '};',
    }),
    element: (number, { rows }) => (rows && number.type === 'byte' ? byteNumber(number) : undefined),
    texts: ({ name: of, about, parameter, entries, otherwise }, lines, printer) => {
      const argument = printer.name(parameter);
      if (printer.comments) for (const line of javaDocumentation([about])) lines.add(line);
      lines.add(`static String ${printer.name(of, 'routine')}(int ${argument}) {`).inside(() => {
        lines.add(`switch (${argument}) {`).inside(() => {
          for (const { number, text } of entries)
            lines.add(`case ${number}:`).inside(() => lines.add(`return ${quoted(text)};`));
          lines.add('default:').inside(() => lines.add(`return ${quoted(otherwise)};`));
        });
        lines.add('}');
      });
      lines.add('}');
    },
  };
};
