import type { Routine, Scalar, Statement } from '../code.ts';
import { plainText } from '../print.ts';
import { LEVEL, type Printer, type Syntax, whole } from '../syntax.ts';
import { cNumber, cOperators, isUpdate, quoted } from './c-like.ts';
import { spaced } from './go-spacing.ts';

const TYPES: Readonly<Record<Scalar, string>> = {
  byte: 'byte',
  word: 'uint16',
  dword: 'uint32',
  int: 'int',
  bool: 'bool',
  real: 'float64',
};

export const goType = ({ type, size }: { readonly type: Scalar; readonly size?: number | undefined }): string =>
  (size === undefined ? '' : '[]') + TYPES[type];

/** Whether statements read a variable. */
export const reads = (statements: readonly Statement[], variable: string): boolean =>
  JSON.stringify(statements).includes(`"name":${JSON.stringify(variable)}`);

/** A literal that stands alone has the type of `int` or `float64`. */
const declared = ({ value }: Extract<Statement, { kind: 'declare' }>, printer: Printer): string => {
  const text = printer.slot(value);
  const isBare = value.kind === 'number' && value.type !== 'int' && value.type !== 'real';
  return isBare ? `${TYPES[value.type]}(${text})` : spaced(text);
};

function heading(routine: Routine, printer: Printer) {
  const parameters = printer.parameters(routine);
  const written = parameters.map((parameter) => `${printer.name(parameter.name)} ${goType(parameter)}`);
  const { gives } = routine;
  const result = gives.kind === 'frame' ? '[]byte' : TYPES[gives.type];
  const about = [
    ...routine.about,
    ...parameters.flatMap(({ name, comment }) => (comment === '' ? [] : [`${printer.name(name)}: ${comment}`])),
  ];
  return {
    before: [
      ...(printer.comments ? about.map((text) => `// ${plainText(text)}`) : []),
      `func ${printer.name(routine.name, 'routine')}(${written.join(', ')}) ${result} {`,
    ],
    inside: gives.kind === 'frame' ? [`frame := make([]byte, 0, ${gives.most})`] : [],
    last: gives.kind === 'frame' ? ['return frame'] : [],
    end: ['}'],
  };
}

/** `uses` gets the packages that are needed. */
export const goSyntax = (name: Syntax['name'], uses: Set<string>): Syntax => ({
  name,
  number: cNumber,
  truth: String,
  operators: cOperators,
  not: { text: '!', level: LEVEL.unary },
  convert: ({ type, of }, printer) => whole(`${TYPES[type]}(${printer.operand(of, LEVEL.least)})`),
  signed: ({ of }, printer) =>
    whole(`int(${of.type === 'dword' ? 'int32' : 'int16'}(${printer.operand(of, LEVEL.least)}))`),
  float: ({ of }, printer) => {
    uses.add('math');
    return whole(`float64(math.Float32frombits(${printer.operand(of, LEVEL.least)}))`);
  },
  floor: ({ of }, printer) => {
    uses.add('math');
    return whole(`math.Floor(${printer.operand(of, LEVEL.least)})`);
  },
  soFar: whole('len(frame)'),
  slices: { length: (array) => whole(`len(${array})`), first: (array, length) => `${array}[:${length}]` },
  declare: (statement, printer) => `${printer.name(statement.name)} := ${declared(statement, printer)}`,
  set: (to, value) => `${spaced(to)} = ${spaced(value)}`,
  update: (to, { operator, right }, printer) => {
    if (!isUpdate(operator)) return undefined;
    const isOne = right.kind === 'number' && right.value === 1 && (operator === '+' || operator === '-');
    if (isOne) return `${spaced(to)}${operator}${operator}`;
    return `${spaced(to)} ${cOperators[operator]}= ${spaced(printer.operand(right, LEVEL.least))}`;
  },
  put: (value) => `frame = append(frame, ${spaced(value, 2)})`,
  give: (value) => `return ${spaced(value)}`,
  when: (condition) => ({ head: `if ${spaced(condition)} {`, end: '}' }),
  otherwise: '} else {',
  otherwiseWhen: (condition) => `} else if ${spaced(condition)} {`,
  repeat: ({ name: of, from, to, body }, printer) => {
    const variable = printer.name(of);
    if (from.kind !== 'number' || from.value !== 0)
      return {
        head: `for ${variable} := ${spaced(printer.slot(from))}; ${spaced(`${variable} < ${printer.operand(to, LEVEL.sum)}`)}; ${variable}++ {`,
        end: '}',
      };
    return {
      head: reads(body, of)
        ? `for ${variable} := range ${spaced(printer.slot(to))} {`
        : `for range ${spaced(printer.slot(to))} {`,
      end: '}',
    };
  },
  during: (condition) => ({ head: `for ${spaced(condition)} {`, end: '}' }),
  comment: (text) => `// ${text}`,
  sections: true,
  routine: heading,
  constant: (constant, value, printer) => `${printer.name(constant.name, 'constant')} = ${value}`,
  constants: { head: 'const (', end: ')', mark: ' =' },
  table: (table, printer) => ({
    head: `var ${printer.name(table.name, 'table')} = ${table.rows ? '[]' : '[...]'}${TYPES[table.type]}{`,
    end: '}',
    lastMark: true,
  }),
  texts: ({ name: of, about, parameter, entries, otherwise }, lines, printer) => {
    const argument = printer.name(parameter);
    printer.remark(lines, about);
    lines.add(`func ${printer.name(of, 'routine')}(${argument} int) string {`).inside(() => {
      lines.add(`switch ${argument} {`);
      for (const { number, text } of entries)
        lines.add(`case ${number}:`).inside(() => lines.add(`return ${quoted(text)}`));
      lines.add('}').add(`return ${quoted(otherwise)}`);
    });
    lines.add('}');
  },
});
