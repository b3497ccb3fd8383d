import type { Expression, Parameter, Routine, Scalar } from '../code.ts';
import { plainText } from '../print.ts';
import { LEVEL, type Printed, type Printer, type Syntax, whole } from '../syntax.ts';
import { overflows } from '../width.ts';
import { cNumber, cOperators, isUpdate, quoted, widens } from './c-like.ts';

const TYPES: Readonly<Record<Scalar, string>> = {
  byte: 'byte',
  word: 'ushort',
  dword: 'uint',
  int: 'int',
  bool: 'bool',
  real: 'double',
};

export const csharpType = ({ type, size }: Pick<Parameter, 'type' | 'size'>): string =>
  TYPES[type] + (size === undefined ? '' : '[]');

const cast = (type: Scalar, text: string): Printed => ({ text: `(${TYPES[type]})${text}`, level: LEVEL.unary });

/** Whether C# calculates it as an `int`, although it is a byte or a word. */
const isWide = (of: Expression): boolean =>
  (of.type === 'byte' || of.type === 'word') &&
  (of.kind === 'binary' || (of.kind === 'convert' && widens(of.of.type, of.type) && isWide(of.of)));

/** XML in a comment of documentation. */
const xml = (text: string): string =>
  plainText(text).replace(/&/g, '&amp;').replace(/</g, '&lt;').replace(/>/g, '&gt;');

const attribute = (text: string): string => xml(text).replace(/"/g, '&quot;');

export function csharpDocumentation(
  about: readonly string[],
  parameters: readonly (readonly [string, string])[],
): readonly string[] {
  const [first = '', ...rest] = about.map(xml);
  return [
    ...(rest.length === 0 ? [`<summary>${first}</summary>`] : ['<summary>', first, ...rest, '</summary>']),
    ...parameters.flatMap(([name, comment]) =>
      comment === '' ? [] : [`<param name="${attribute(name)}">${xml(comment)}</param>`],
    ),
  ].map((line) => `/// ${line}`);
}

function heading(routine: Routine, printer: Printer) {
  const { name, parameters, gives, about } = routine;
  const list = parameters.map((parameter) => `${csharpType(parameter)} ${printer.name(parameter.name)}`).join(', ');
  const type = gives.kind === 'frame' ? 'byte[]' : TYPES[gives.type];
  const said = parameters.map((parameter) => [printer.name(parameter.name), parameter.comment] as const);
  const isFrame = gives.kind === 'frame';
  return {
    before: [
      ...(printer.comments ? csharpDocumentation(about, said) : []),
      `public static ${type} ${printer.name(name, 'routine')}(${list})`,
      '{',
    ],
    inside: isFrame ? [`var frame = new byte[${gives.most}];`, 'int length = 0;'] : [],
    last: isFrame ? ['return frame;'] : [],
    end: ['}'],
  };
}

const block = (head: string) => ({ head: `${head}\n{`, end: '}' });

export const csharpSyntax = (name: Syntax['name']): Syntax => ({
  name,
  number: (number) => cNumber(number) + (number.type === 'dword' ? 'u' : ''),
  truth: String,
  operators: cOperators,
  not: { text: '!', level: LEVEL.unary },
  convert: ({ type, of }, printer) => {
    if (widens(of.type, type) && type !== 'dword')
      return overflows(of) ? cast(of.type, `(${printer.print(of).text})`) : printer.print(of);
    return cast(type, printer.operand(of, LEVEL.unary));
  },
  signed: ({ of }, printer) => ({
    text: `(${of.type === 'dword' ? 'int' : 'short'})${printer.operand(of, LEVEL.unary)}`,
    level: LEVEL.unary,
  }),
  float: ({ of }, printer) => whole(`BitConverter.ToSingle(BitConverter.GetBytes(${printer.slot(of)}), 0)`),
  floor: ({ of }, printer) => whole(`Math.Floor(${printer.slot(of)})`),
  soFar: whole('length'),
  fit: (expression, printed, where) =>
    isWide(expression) && (where === 'slot' || overflows(expression))
      ? cast(expression.type, `(${printed.text})`)
      : printed,
  declare: ({ name: of, value }, printer) => `${TYPES[value.type]} ${printer.name(of)} = ${printer.slot(value)};`,
  set: (to, value) => `${to} = ${value};`,
  update: (to, { operator, right }, printer) => {
    if (!isUpdate(operator)) return undefined;
    const isOne = right.kind === 'number' && right.value === 1 && (operator === '+' || operator === '-');
    return isOne ? `${to}${operator}${operator};` : `${to} ${cOperators[operator]}= ${printer.slot(right)};`;
  },
  put: (value) => `frame[length++] = ${value};`,
  give: (value) => `return ${value};`,
  when: (condition) => block(`if (${condition})`),
  otherwise: '}\nelse\n{',
  otherwiseWhen: (condition) => `}\nelse if (${condition})\n{`,
  repeat: ({ name: of, from, to }, printer) => {
    const counter = printer.name(of);
    const until = printer.operand(to, LEVEL.sum);
    return block(`for (int ${counter} = ${printer.slot(from)}; ${counter} < ${until}; ${counter}++)`);
  },
  during: (condition) => block(`while (${condition})`),
  comment: (text) => `// ${text}`,
  routine: heading,
  constant: ({ name: of, type }, value, printer) =>
    `public const ${TYPES[type]} ${printer.name(of, 'constant')} = ${value};`,
  table: ({ name: of, type }, printer) => ({
    head: `public static readonly ${TYPES[type]}[] ${printer.name(of, 'table')} =\n{`,
    end: '};',
  }),
  texts: ({ name: of, about, parameter, entries, otherwise }, lines, printer) => {
    const argument = printer.name(parameter);
    if (printer.comments) for (const line of csharpDocumentation([about], [])) lines.add(line);
    lines.add(`public static string ${printer.name(of, 'routine')}(int ${argument})\n{`).inside(() => {
      lines.add(`switch (${argument})\n{`).inside(() => {
        for (const { number, text } of entries) lines.add(`case ${number}: return ${quoted(text)};`);
        lines.add(`default: return ${quoted(otherwise)};`);
      });
      lines.add('}');
    });
    lines.add('}');
  },
});
