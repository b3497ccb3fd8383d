import { MOST_RTU } from '../../modbus/index.ts';
import type { Expression, Name, Parameter, Routine, Scalar } from '../code.ts';
import { plainText } from '../print.ts';
import { LEVEL, type Printed, type Printer, type Role, type Syntax, whole } from '../syntax.ts';
import { overflows } from '../width.ts';
import { cNumber, cOperators, isUpdate, quoted, widens } from './c-like.ts';

/** In what C99 and the C++ of Arduino differ. */
export interface CFamily {
  readonly name: (name: Name, role: Role) => string;
  /** What stands before what only this file uses. */
  readonly own: string;
  readonly real: string;
  /** The type of an `int`, by what it is: a place in a frame, or any number. */
  readonly int: (of: 'place' | 'number') => string;
  /** What ends a number of 32 bits without a sign. */
  readonly dword: string;
  /** Whether each `uint16_t` is also an `int` of the language. */
  readonly wordsAreInts: boolean;
  /** What stands behind the name of a table, and how an element of it is read. */
  readonly memory?: { readonly mark: string; readonly read: (type: Scalar, element: string) => string };
  /** The type of texts, as it stands before a name, and one of them. */
  readonly texts: string;
  readonly string: (text: string) => string;
}

export const cType = (family: CFamily, type: Scalar, of: 'place' | 'number' = 'number'): string =>
  ({ byte: 'uint8_t', word: 'uint16_t', dword: 'uint32_t', int: family.int(of), bool: 'bool', real: family.real })[
    type
  ];

/** A comment to the end of its line. A backslash there, or the trigraph of one, would make the next line part of it. */
export const cComment = (text: string): string => `// ${/(\\|\?\?\/)$/.test(text) ? `${text}.` : text}`;

/** A string. The question marks cannot make a trigraph. */
export const cString = (text: string): string => quoted(text).replace(/\?(?=\?)/g, '?""');

type Convert = Extract<Expression, { kind: 'convert' }>;

/** Whether C converts the number by itself, so that no cast stands there: from few bits to more. */
const isImplied = (of: Expression): of is Convert =>
  of.kind === 'convert' &&
  ((of.type === 'real' && of.of.type === 'int') || widens(of.of.type, of.type)) &&
  !overflows(of.of);

/** Whether the other side has the type of a number of which the cast is left out, or is a literal with which it cannot overflow. */
const carries = (other: Expression, { of }: { readonly of: Expression }): boolean =>
  other.kind !== 'number' || other.type !== 'int' || (of.type === 'byte' && Math.abs(other.value) < 128);

/** Takes casts out that C does not need: on one side, as the other side has the type. */
function withoutCasts(expression: Expression, wordsAreInts: boolean): Expression {
  if (expression.kind !== 'binary' || expression.operator === '<<' || expression.operator === '>>') return expression;
  const { left, right } = expression;
  const spare = (of: Expression): of is Convert =>
    isImplied(of) && (wordsAreInts || of.type !== 'int' || of.of.type === 'byte');
  if (spare(right) && carries(left, right)) return { ...expression, right: right.of };
  return spare(left) && carries(right, left) ? { ...expression, left: left.of } : expression;
}

/** Zero that something is compared with is `0`, whatever its type. */
function shortZero(expression: Expression): Expression {
  if (expression.kind !== 'binary' || expression.type !== 'bool') return expression;
  const { right } = expression;
  if (right.kind !== 'number' || right.value !== 0 || right.base === 10 || right.type === 'real') return expression;
  return { ...expression, right: { ...right, type: 'int', base: 10 } };
}

const cast = (type: string, of: string): Printed => ({ text: `(${type})${of}`, level: LEVEL.unary });

export function cSyntax(family: CFamily): Syntax {
  const typed = (type: Scalar) => cType(family, type);
  const [frame, length] = [family.name('frame', 'variable'), family.name('length', 'variable')];
  return {
    name: family.name,
    number: (of) => cNumber(of) + (of.type === 'dword' ? family.dword : ''),
    truth: String,
    operators: cOperators,
    not: { text: '!', level: LEVEL.unary },
    convert: ({ type, of }, printer) => cast(typed(type), printer.operand(of, LEVEL.unary)),
    signed: ({ of }, printer) => cast(of.type === 'word' ? 'int16_t' : 'int32_t', printer.operand(of, LEVEL.unary)),
    float: ({ of }, printer) => whole(`float_of(${printer.slot(of)})`),
    floor: ({ of }, printer) => whole(`floor(${printer.slot(of)})`),
    soFar: whole(length),
    special: (expression, printer) => {
      const short = shortZero(withoutCasts(expression, family.wordsAreInts));
      if (short !== expression) return printer.print(short);
      const { memory } = family;
      if (expression.kind !== 'element' || !memory || printer.role(expression.array) !== 'table') return undefined;
      return whole(
        memory.read(expression.type, `${printer.name(expression.array)}[${printer.slot(expression.index)}]`),
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
      if (!isUpdate(operator)) return undefined;
      if (operator === '+' && right.kind === 'number' && right.value === 1 && right.type === 'int') return `${to}++;`;
      return `${to} ${operator}= ${printer.slot(right)};`;
    },
    put: (value) => `${frame}[${length}++] = ${value};`,
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
      const isFrame = routine.gives.kind === 'frame';
      return {
        before: [...aboutRoutine(routine, printer), ...cHead(family, routine, printer), '{'],
        inside: [...unused(routine, printer), ...(isFrame ? [`int ${length} = 0;`, ''] : [])],
        last: isFrame ? ['', `return ${length};`] : [],
        end: ['}'],
      };
    },
    constant: ({ name }, value, printer) =>
      `#define ${printer.name(name)} ${value.startsWith('-') ? `(${value})` : value}`,
    table: ({ name, type, values }, printer) => ({
      head: `${family.own}const ${typed(type)} ${printer.name(name)}[${values.length}]${family.memory?.mark ?? ''} = {`,
      end: '};',
    }),
    texts: ({ name, about, parameter, entries, otherwise }, lines, printer) => {
      const { texts: type, string } = family;
      printer.remark(lines, about);
      lines.add(`${family.own}${type}${printer.name(name, 'routine')}(int ${printer.name(parameter)})`).add('{');
      lines.inside(() => {
        lines.add(`switch (${printer.name(parameter)}) {`);
        for (const { number, text } of entries) lines.add(`case ${number}: return ${string(text)};`);
        lines.add(`default: return ${string(otherwise)};`).add('}');
      });
      lines.add('}');
    },
  };
}

const WIDEST_HEAD = 112;

/** The declaration of a routine, without what ends it; in two lines if it is long. */
function cHead(family: CFamily, { gives, name, parameters }: Routine, printer: Printer): readonly string[] {
  const frame = gives.kind === 'frame' ? [`uint8_t ${family.name('frame', 'variable')}[${gives.most}]`] : [];
  const list = [...frame, ...parameters.map((parameter) => parameterOf(family, parameter, printer))];
  const type = gives.kind === 'frame' ? 'int' : cType(family, gives.type);
  const head = `${family.own}${type} ${printer.name(name, 'routine')}(`;
  const line = `${head}${list.join(', ') || 'void'})`;
  return line.length <= WIDEST_HEAD ? [line] : [head, `        ${list.join(', ')})`];
}

/** An array that may hold any frame is a pointer, as fewer bytes may be given; one of fixed length says its length. */
function parameterOf(family: CFamily, { name, type, size, filled, lengthOf }: Parameter, printer: Printer): string {
  const text = `${cType(family, type, lengthOf === undefined ? 'number' : 'place')} `;
  const called = printer.name(name);
  if (size === undefined) return text + called;
  return `${filled ? '' : 'const '}${text}${size >= MOST_RTU ? `*${called}` : `${called}[${size}]`}`;
}

/** Parameters that stand there because all routines of a kind have them. */
function unused({ parameters, body }: Routine, printer: Printer): readonly string[] {
  const used = textsOf(body, ['name', 'array']);
  return parameters.filter(({ name }) => !used.has(name)).map(({ name }) => `(void)${printer.name(name)};`);
}

function aboutRoutine({ about, parameters }: Routine, printer: Printer): readonly string[] {
  if (!printer.comments) return [];
  const said = parameters
    .filter(({ comment }) => comment !== '')
    .map(({ name, comment }) => `  ${printer.name(name)}: ${comment}`);
  return [...about, ...said].map((text) => cComment(text.startsWith('  ') ? `  ${plainText(text)}` : plainText(text)));
}

/** The texts that stand under some keys, however deep. */
function textsOf(value: unknown, keys: readonly string[], found = new Set<string>()): ReadonlySet<string> {
  if (typeof value !== 'object' || value === null) return found;
  for (const [key, inside] of Object.entries(value))
    if (typeof inside === 'string' && keys.includes(key)) found.add(inside);
    else textsOf(inside, keys, found);
  return found;
}

/** A text that is written by hand, without the comments in lines of their own. */
export const withoutComments = (text: string): string =>
  text
    .split('\n')
    .filter((line) => !line.trimStart().startsWith('//'))
    .join('\n');
