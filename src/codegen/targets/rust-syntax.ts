import type { Expression, Parameter, Routine, Scalar } from '../code.ts';
import { plainText } from '../print.ts';
import { LEVEL, type Printed, type Printer, type Syntax, whole } from '../syntax.ts';
import { cNumber, cOperators, isUpdate, widens } from './c-like.ts';
import { reads } from './go-syntax.ts';
import type { Sizes } from './rust-numbers.ts';

const TYPES: Readonly<Record<Scalar, string>> = {
  byte: 'u8',
  word: 'u16',
  dword: 'u32',
  int: 'i32',
  bool: 'bool',
  real: 'f64',
};

export const rustType = ({ type, size, filled }: Pick<Parameter, 'type' | 'size' | 'filled'>): string =>
  size === undefined ? TYPES[type] : `&${filled ? 'mut ' : ''}[${TYPES[type]}]`;

/** A text in quotes. */
export const rustText = (text: string): string => `"${plainText(text).replace(/["\\]/g, '\\$&')}"`;

/** Behind `as T`, `<` would begin a list of types: so it binds less than what it stands in. */
const as = (text: string, type: string): Printed => ({ text: `${text} as ${type}`, level: LEVEL.relation });

const RELATIONS: ReadonlySet<string> = new Set(['=', '≠', '<', '≤', '>', '≥']);
const WIDEST = 100;
const STEP = '    ';

/** A head with its parameters in one line, or each in its own. */
export function rustHead(before: string, list: readonly string[], after: string): readonly string[] {
  const line = `${before}(${list.join(', ')})${after}`;
  return line.length <= WIDEST ? [line] : [`${before}(`, ...list.map((one) => `${STEP}${one},`), `)${after}`];
}

function heading(routine: Routine, printer: Printer) {
  const { name, gives, about } = routine;
  const parameters = printer.parameters(routine);
  const list = parameters.map((parameter) => `${printer.name(parameter.name)}: ${rustType(parameter)}`);
  const isFrame = gives.kind === 'frame';
  const said = parameters.flatMap((parameter) =>
    parameter.comment === '' ? [] : [`* \`${printer.name(parameter.name)}\`: ${plainText(parameter.comment)}`],
  );
  const documentation = [...about.map(plainText), ...(said.length > 0 ? ['', ...said] : [])];
  const head = rustHead(
    `fn ${printer.name(name, 'routine')}`,
    list,
    ` -> ${isFrame ? 'Vec<u8>' : TYPES[gives.type]} {`,
  );
  return {
    before: [...(printer.comments ? documentation.map((line) => `/// ${line}`.trimEnd()) : []), ...head],
    inside: isFrame ? [`let mut frame = Vec::with_capacity(${gives.most});`] : [],
    last: isFrame ? ['frame'] : [],
    end: ['}'],
  };
}

function convert({ type, of }: Extract<Expression, { kind: 'convert' }>, printer: Printer, sizes: Sizes): Printed {
  const isExact = widens(of.type, type) || (type === 'real' && of.type !== 'real');
  if (isExact) return whole(`${TYPES[type]}::from(${printer.operand(of, LEVEL.least)})`);
  if (sizes.is(of, printer.routine)) return as(sizes.text(of, printer, LEVEL.unary), TYPES[type]);
  return as(printer.at(of, LEVEL.unary), TYPES[type]);
}

function special(expression: Expression, printer: Printer, sizes: Sizes): Printed | undefined {
  const { routine } = printer;
  if (expression.kind === 'element')
    return whole(`${printer.name(expression.array)}[${sizes.text(expression.index, printer)}]`);
  if (expression.kind === 'name' && routine && sizes.in(routine).has(expression.name))
    return as(printer.name(expression.name), 'i32');
  if (expression.kind !== 'binary' || !RELATIONS.has(expression.operator)) return undefined;
  const { left, right, operator } = expression;
  if (!sizes.is(left, routine) || !sizes.is(right, routine)) return undefined;
  const text = `${sizes.text(left, printer, LEVEL.sum)} ${cOperators[operator]} ${sizes.text(right, printer, LEVEL.sum)}`;
  return { text, level: LEVEL.relation };
}

export const rustSyntax = (name: Syntax['name'], sizes: Sizes): Syntax => ({
  name,
  number: cNumber,
  truth: String,
  operators: cOperators,
  not: { text: '!', level: LEVEL.unary },
  convert: (of, printer) => convert(of, printer, sizes),
  signed: ({ of }, printer) => {
    const low = `${printer.at(of, LEVEL.unary)} as ${of.type === 'dword' ? 'i32' : 'i16'}`;
    return of.type === 'dword' ? { text: low, level: LEVEL.relation } : whole(`i32::from(${low})`);
  },
  float: ({ of }, printer) => whole(`f64::from(f32::from_bits(${printer.operand(of, LEVEL.least)}))`),
  floor: ({ of }, printer) => whole(`${printer.at(of, LEVEL.whole)}.floor()`),
  soFar: as('frame.len()', 'i32'),
  slices: {
    length: (array) => as(`${array}.len()`, 'i32'),
    first: (array, _, length, printer) => `&${array.replace(/^&/, '')}[..${sizes.text(length, printer)}]`,
  },
  array: (text, printer, array) =>
    printer.role(array) === 'table' || !printer.routine?.parameters.some((parameter) => parameter.name === array)
      ? `&${text}`
      : text,
  special: (expression, printer) => special(expression, printer, sizes),
  declare: (statement, printer) => {
    const { name: of, value, changes } = statement;
    if (!changes && printer.routine && sizes.in(printer.routine).has(of))
      return `let ${printer.name(of)} = ${sizes.text(value, printer)};`;
    const type = value.kind === 'number' ? `: ${TYPES[value.type]}` : '';
    return `let ${changes ? 'mut ' : ''}${printer.name(of)}${type} = ${printer.slot(value)};`;
  },
  set: (to, value) => `${to} = ${value};`,
  update: (to, { operator, right }, printer) =>
    isUpdate(operator) ? `${to} ${cOperators[operator]}= ${printer.slot(right)};` : undefined,
  put: (value) => `frame.push(${value});`,
  give: (value) => `return ${value};`,
  giveLast: (value) => value,
  when: (condition) => ({ head: `if ${condition} {`, end: '}' }),
  otherwise: '} else {',
  otherwiseWhen: (condition) => `} else if ${condition} {`,
  repeat: ({ name: of, from, to, body }, printer) => {
    const isCount = printer.routine !== undefined && sizes.in(printer.routine).has(of);
    const bound = (value: Expression) =>
      isCount ? sizes.text(value, printer, LEVEL.sum) : printer.operand(value, LEVEL.sum);
    return { head: `for ${reads(body, of) ? printer.name(of) : '_'} in ${bound(from)}..${bound(to)} {`, end: '}' };
  },
  during: (condition) => ({ head: `while ${condition} {`, end: '}' }),
  comment: (text) => `// ${text}`,
  sections: true,
  routine: heading,
  constant: ({ name: of, type }, value, printer) => `const ${printer.name(of, 'constant')}: ${TYPES[type]} = ${value};`,
  table: ({ name: of, type, values }, printer) => ({
    head: `const ${printer.name(of, 'table')}: [${TYPES[type]}; ${values.length}] = [`,
    end: '];',
    lastMark: true,
  }),
  texts: ({ name: of, about, parameter, entries, otherwise }, lines, printer) => {
    const argument = printer.name(parameter);
    if (printer.comments) lines.add(`/// ${plainText(about)}`);
    lines.add(`fn ${printer.name(of, 'routine')}(${argument}: i32) -> &'static str {`).inside(() => {
      lines.add(`match ${argument} {`).inside(() => {
        for (const { number, text } of entries) lines.add(`${number} => ${rustText(text)},`);
        lines.add(`_ => ${rustText(otherwise)},`);
      });
      lines.add('}');
    });
    lines.add('}');
  },
});
