import type { Argument, Expression, Operator, Routine, Scalar } from '../code.ts';
import type { NameRules } from '../names.ts';
import { plainText } from '../print.ts';
import { LEVEL, type Printed, type Printer, type Syntax, whole } from '../syntax.ts';
import { overflows, WIDTHS } from '../width.ts';
import { cNumber, isUnsigned } from './c-like.ts';

const KEYWORDS = `begin break catch class continue data define do dynamicparam else elseif end enum exit filter finally for foreach
from function hidden if in inlinescript parallel param process return sequence static switch throw trap try until using var while
workflow`;

/** Variables that PowerShell sets, and what the programs define themselves. */
const OWN = `args consolefilename error errorview event eventargs eventsubscriber executioncontext false foreach home host input
iscoreclr islinux ismacos iswindows lastexitcode matches myinvocation nestedpromptlevel null ofs pid pause profile psboundparameters
pscmdlet pscommandpath psculture psdebugcontext psedition pshome psitem psscriptroot psuiculture psversiontable pwd sender
shellid stacktrace this true bytes check client clock exchange finish frame good holds left line more port send server serverport silence steps timeout verdict
waituntil`;

export const powershellRules: NameRules = {
  styles: { routine: 'pascal', variable: 'camel', constant: 'pascal', table: 'pascal', type: 'pascal' },
  reserved: `${KEYWORDS} ${OWN}`.split(/\s+/),
  ignoresCase: true,
};

/** A text between single quotes. PowerShell takes the typographic ones for the same. */
export const powershellText = (text: string): string => `'${plainText(text).replace(/['\u2018-\u201b]/g, '$&$&')}'`;

const TYPES: Readonly<Record<Scalar, string>> = {
  byte: 'byte',
  word: 'int',
  dword: 'long',
  int: 'int',
  bool: 'bool',
  real: 'double',
};

const OPERATORS: Readonly<Record<Operator, string>> = {
  '+': '+',
  '-': '-',
  '*': '*',
  '/': '/',
  '%': '%',
  '&': '-band',
  '|': '-bor',
  '^': '-bxor',
  '<<': '-shl',
  '>>': '-shr',
  '=': '-eq',
  '≠': '-ne',
  '<': '-lt',
  '≤': '-le',
  '>': '-gt',
  '≥': '-ge',
  and: '-and',
  or: '-or',
};

/** A mask as PowerShell has no doubt about its sign. */
const maskOf = (type: Scalar): string => (type === 'dword' ? '4294967295' : `0x${'FF'.repeat(WIDTHS[type] / 8)}`);
const masked = (text: string, type: Scalar): Printed => ({ text: `${text} -band ${maskOf(type)}`, level: LEVEL.or });

const numberText = ({ value, type, base }: Extract<Expression, { kind: 'number' }>): string =>
  type === 'dword' ? `[long]${value}` : cNumber({ value, type, base });

/** What is given to a function: in a command all but the plainest stands in parentheses. */
function argumentText(argument: Argument, printer: Printer): string {
  const text = printer.argument(argument);
  return /^(\$\w+|\d+|0x[0-9A-F]+)$/.test(text) ? text : `(${text})`;
}

/** Operators bind in ways that nobody remembers, so that parentheses stand wherever two meet. */
function special(expression: Expression, printer: Printer): Printed | undefined {
  if (expression.kind === 'call') {
    const given = expression.arguments.map((argument) => argumentText(argument, printer));
    return whole(`(${[printer.name(expression.routine, 'routine'), ...given].join(' ')})`);
  }
  if (expression.kind !== 'binary') return undefined;
  const { operator, type, left, right } = expression;
  const text = `${printer.operand(left, LEVEL.unary)} ${OPERATORS[operator]} ${printer.operand(right, LEVEL.unary)}`;
  if (operator === '/' && type !== 'real') return whole(`[int][Math]::Floor(${text})`);
  return { text, level: LEVEL.or };
}

function convert({ type, of }: Extract<Expression, { kind: 'convert' }>, printer: Printer): Printed {
  if (type === 'real') return whole(`[double]${printer.operand(of, LEVEL.whole)}`);
  const isFraction = of.type === 'real';
  const text = isFraction
    ? `[int][Math]::Truncate(${printer.operand(of, LEVEL.least)})`
    : printer.operand(of, LEVEL.whole);
  // A byte that is shifted to the left would stay a byte.
  if (!isUnsigned(type) || (isUnsigned(of.type) && WIDTHS[of.type] <= WIDTHS[type]))
    return whole(`[${TYPES[type]}]${text}`);
  return masked(type === 'dword' ? `[long]${text}` : text, type);
}

function heading(routine: Routine, printer: Printer) {
  const written = routine.parameters.map(({ name, type, size }) => {
    const list = size === undefined ? '' : '[]';
    return `[${TYPES[type]}${list}] ${printer.name(name)}`;
  });
  const about = [
    ...routine.about,
    ...routine.parameters.flatMap(({ name, comment }) => (comment === '' ? [] : [`${printer.name(name)}: ${comment}`])),
  ];
  const isFrame = routine.gives.kind === 'frame';
  return {
    before: [
      ...(printer.comments ? about.map((text) => `# ${plainText(text)}`) : []),
      `function ${printer.name(routine.name, 'routine')}(${written.join(', ')}) {`,
    ],
    inside: isFrame ? ['$frame = [System.Collections.Generic.List[byte]]::new()'] : [],
    last: isFrame ? ['return , $frame.ToArray()'] : [],
    end: ['}'],
  };
}

const block = (text: string) => ({ head: `${text} {`, end: '}' });

/** `name` gives names without the mark of variables. */
export const powershellSyntax = (name: Syntax['name']): Syntax => ({
  name: (of, role) => (role === 'routine' ? name(of, role) : `$${name(of, role)}`),
  number: numberText,
  truth: (value) => `$${value}`,
  operators: OPERATORS,
  not: { text: '-not ', level: LEVEL.unary },
  convert,
  signed: ({ of }, printer) => {
    const sign = of.type === 'dword' ? '[long]2147483648' : '0x8000';
    return { text: `(${printer.operand(of, LEVEL.unary)} -bxor ${sign}) - ${sign}`, level: LEVEL.or };
  },
  float: ({ of }, printer) =>
    whole(`[double][BitConverter]::ToSingle([BitConverter]::GetBytes([uint32]${printer.operand(of, LEVEL.whole)}), 0)`),
  floor: ({ of }, printer) => whole(`[Math]::Floor(${printer.operand(of, LEVEL.least)})`),
  soFar: whole('$frame.Count'),
  array: (text, { routine }, array) =>
    array === 'frame' && routine?.gives.kind === 'frame' ? '$frame.ToArray()' : text,
  special,
  fit: (expression, { text, level }) =>
    overflows(expression) && isUnsigned(expression.type)
      ? masked(level >= LEVEL.unary ? text : `(${text})`, expression.type)
      : { text, level },
  declare: ({ name: of, value }, printer) => `${printer.name(of)} = ${printer.slot(value)}`,
  set: (to, value) => `${to} = ${value}`,
  put: (value) => `$frame.Add(${value})`,
  give: (value) => `return ${value}`,
  when: (condition) => block(`if (${condition})`),
  otherwise: '} else {',
  otherwiseWhen: (condition) => `} elseif (${condition}) {`,
  repeat: ({ name: of, from, to }, printer) => {
    const index = printer.name(of);
    const end = printer.operand(to, LEVEL.unary);
    return block(`for (${index} = ${printer.slot(from)}; ${index} -lt ${end}; ${index}++)`);
  },
  during: (condition) => block(`while (${condition})`),
  comment: (text) => `# ${text}`,
  routine: heading,
  constant: (constant, value, printer) => `${printer.name(constant.name, 'constant')} = ${value}`,
  table: ({ name: of, type }, printer) => ({
    head: `[${TYPES[type]}[]] ${printer.name(of, 'table')} = @(`,
    end: ')',
  }),
  texts: ({ name: of, about, parameter, entries, otherwise }, lines, printer) => {
    printer.remark(lines, about);
    lines.add(`function ${printer.name(of, 'routine')}([int] ${printer.name(parameter)}) {`).inside(() => {
      lines.add(`switch (${printer.name(parameter)}) {`).inside(() => {
        for (const { number, text } of entries)
          lines.add(`${number < 0 ? `(${number})` : number} { return ${powershellText(text)} }`);
        lines.add(`default { return ${powershellText(otherwise)} }`);
      });
      lines.add('}');
    });
    lines.add('}');
  },
});
