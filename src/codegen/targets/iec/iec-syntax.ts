import { hexDigits } from '../../../modbus/index.ts';
import type { Code, Expression, Name, Operator, Routine, Scalar, Statement } from '../../code.ts';
import { LEVEL, type Printed, type Printer, type Syntax, whole } from '../../syntax.ts';
import type { Dialect } from './dialect.ts';
import { RESULT } from './lower.ts';

/** What the languages of the family have in common. IEC 61131-3 has no `>>`, no `%` and no conversion by itself. */
export const iecOperators: Readonly<Record<Operator, string>> = {
  '+': '+',
  '-': '-',
  '*': '*',
  '/': '/',
  '%': 'MOD',
  '&': 'AND',
  '|': 'OR',
  '^': 'XOR',
  '<<': 'SHL',
  '>>': 'SHR',
  '=': '=',
  '≠': '<>',
  '<': '<',
  '≤': '<=',
  '>': '>',
  '≥': '>=',
  and: 'AND',
  or: 'OR',
};

const HEX_DIGITS: Readonly<Partial<Record<Scalar, number>>> = { byte: 2, word: 4, dword: 8 };
const WHOLE_AND_FRACTION = /^(-?\d+)(\.\d+)?(?:e([+-]\d+))?$/;

/** A real literal always has a point (IEC 61131-3, 6.3.2). */
const real = (value: number): string => {
  const [, digits = '0', fraction = '.0', exponent] = WHOLE_AND_FRACTION.exec(String(value)) ?? [];
  return `${digits}${fraction}${exponent === undefined ? '' : `E${exponent}`}`;
};

/** The conversions on the way from one type to another: through whole numbers, as some systems copy the bits of a double word. */
function way(from: Scalar, to: Scalar, of: Dialect['conversions']): readonly string[] {
  const types = { real: of('real'), int: of('int'), dword: of('dword') };
  if (to === 'real')
    return from === 'dword' ? ['UDINT', types.real] : from === 'int' ? [types.real] : [types.int, types.real];
  if (from === 'real')
    return to === 'dword' ? ['UDINT', types.dword] : to === 'int' ? [types.int] : [types.int, of(to)];
  return [of(to)];
}

export function iecSyntax(
  dialect: Dialect,
  code: Code,
): { readonly syntax: Syntax; readonly begin: (routine: Routine) => void } {
  const { types, conversions, used } = dialect;
  const routines = new Map<Name, Routine>(code.routines.map((routine) => [routine.name, routine]));
  const tables = new Set<Name>(code.tables.map(({ name }) => name));
  let current: Routine | undefined;

  const converted = (text: string, from: string, path: readonly string[]): Printed => {
    let [type, result] = [from, text];
    for (const next of path) {
      result = `${type}_TO_${next}(${result})`;
      type = next;
    }
    return whole(result);
  };

  const special = (expression: Expression, printer: Printer): Printed | undefined => {
    switch (expression.kind) {
      case 'binary':
        if (expression.operator !== '<<' && expression.operator !== '>>') return undefined;
        return whole(
          dialect.shift(
            expression.operator === '<<' ? 'SHL' : 'SHR',
            printer.at(expression.left, LEVEL.least),
            printer.at(expression.right, LEVEL.least),
          ),
        );
      case 'name':
        return expression.name === RESULT ? whole(dialect.result(current?.name ?? '')) : undefined;
      case 'element':
        if (dialect.table === undefined || !tables.has(expression.array)) return undefined;
        return whole(`${dialect.table(expression.array)}[${printer.at(expression.index, LEVEL.least)}]`);
      case 'call': {
        const { parameters = [] } = routines.get(expression.routine) ?? {};
        const given = expression.arguments.map((argument, index) => {
          const parameter = parameters[index];
          const name = parameter ? dialect.declared(parameter.name, 'variable') : '';
          return `${name} := ${printer.argument(argument)}`;
        });
        return whole(`${used(expression.routine, 'routine')}(${given.join(', ')})`);
      }
      default:
        return undefined;
    }
  };

  const syntax: Syntax = {
    name: (name, role) => used(name, role),
    number: ({ type, value, base }) => {
      if (type === 'real') return real(value);
      const digits = HEX_DIGITS[type];
      if (digits === undefined) return String(value);
      return base === 16 ? `${conversions(type)}#16#${hexDigits(value, digits)}` : `${conversions(type)}#${value}`;
    },
    truth: (value) => (value ? 'TRUE' : 'FALSE'),
    operators: iecOperators,
    not: { text: 'NOT ', level: LEVEL.unary },
    convert: ({ type, of }, printer) =>
      converted(printer.at(of, LEVEL.least), conversions(of.type), way(of.type, type, conversions)),
    signed: ({ of }, printer) =>
      converted(
        printer.at(of, LEVEL.least),
        conversions(of.type),
        of.type === 'word' ? ['INT', conversions('int')] : [conversions('int')],
      ),
    float: ({ of }, printer) => whole(dialect.float(printer.at(of, LEVEL.least))),
    floor: ({ of }, printer) => whole(dialect.floor(printer.at(of, LEVEL.least))),
    // Lowering has replaced it.
    soFar: whole(''),
    special,
    declare: ({ name, value }, printer) => `${used(name, 'variable')} := ${printer.slot(value)};`,
    set: (to, value) => `${to} := ${value};`,
    put: () => '',
    give: () => 'RETURN;',
    when: (condition) => ({ head: `IF ${condition} THEN`, end: 'END_IF;' }),
    otherwise: 'ELSE',
    otherwiseWhen: (condition) => `ELSIF ${condition} THEN`,
    repeat: ({ name, from, to }, printer) => ({
      head: `FOR ${used(name, 'variable')} := ${printer.at(from, LEVEL.least)} TO ${lastOf(to, printer)} DO`,
      end: 'END_FOR;',
    }),
    during: (condition) => ({ head: `WHILE ${condition} DO`, end: 'END_WHILE;' }),
    comment: dialect.comment,
    gap: '  ',
    routine: () => ({ before: [], inside: [], last: [], end: [] }),
    constant: ({ name, type }, value) => `${dialect.declared(name, 'constant')} : ${types[type]} := ${value};`,
    table: ({ name, type, values }) => ({
      head: `${dialect.declared(name, 'table')} : ARRAY[0..${values.length - 1}] OF ${types[type]} := [`,
      end: '];',
    }),
    texts: () => {},
  };
  return {
    syntax,
    begin: (routine) => {
      current = routine;
    },
  };
}

/** The last value of a loop that does not reach its end: a signed number, so that nothing is done for an end of 0. */
function lastOf(to: Extract<Statement, { kind: 'for' }>['to'], printer: Printer): string {
  if (to.kind === 'number') return String(to.value - 1);
  if (to.kind === 'binary' && to.operator === '+' && to.right.kind === 'number' && to.right.value === 1)
    return printer.at(to.left, LEVEL.sum);
  return `${printer.at(to, LEVEL.sum)} - 1`;
}
