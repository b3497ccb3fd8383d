import type { Expression, Name, Operator, Routine, Statement } from '../code.ts';
import { LEVEL, type Level, type Printer } from '../syntax.ts';

/**
 * Rust counts and indexes with `usize`, all else of `int` is `i32`. Numbers that are made of lengths, counters and bytes without
 * subtraction are written as `usize` as they are; others are converted where an index stands.
 * @module
 */

const counted = new WeakMap<Routine, ReadonlySet<Name>>();

/** The variables of a routine that are `usize`: counters of loops and constants made of them. */
export function sizesIn(routine: Routine): ReadonlySet<Name> {
  const known = counted.get(routine);
  if (known) return known;
  const found = new Set<Name>();
  counted.set(routine, found);
  const look = (statements: readonly Statement[]): void => {
    for (const one of statements) {
      if (one.kind === 'for') {
        if (isSize(one.from, routine) && isSize(one.to, routine)) found.add(one.name);
        look(one.body);
      } else if (one.kind === 'if') look([...one.then, ...one.otherwise]);
      else if (one.kind === 'while') look(one.body);
      else if (one.kind === 'declare' && !one.changes && one.value.type === 'int' && isSize(one.value, routine)) {
        if (one.value.kind !== 'number') found.add(one.name);
      }
    }
  };
  look(routine.body);
  return found;
}

/** Whether an `int` is never negative, and can be written as `usize` without a cast. */
export function isSize(of: Expression, routine: Routine | undefined): boolean {
  if (of.type !== 'int' || routine === undefined) return false;
  if (of.kind === 'number') return of.value >= 0;
  if (of.kind === 'name') return isLength(of.name, routine) || sizesIn(routine).has(of.name);
  if (of.kind === 'convert') return of.of.type === 'byte' || of.of.type === 'word';
  return of.kind === 'binary' && of.operator !== '-' && isSize(of.left, routine) && isSize(of.right, routine);
}

export const isLength = (name: Name, routine: Routine): boolean =>
  routine.parameters.some((parameter) => parameter.name === name && parameter.lengthOf !== undefined);

const levelOf = (operator: Operator): Level | undefined => {
  if (operator === '+' || operator === '-') return LEVEL.sum;
  return operator === '*' || operator === '/' || operator === '%' ? LEVEL.product : undefined;
};

/** A number that is never negative as `usize`. */
export function sizeText(of: Expression, printer: Printer, least: Level = LEVEL.least): string {
  const { routine } = printer;
  if (of.kind === 'number') return String(of.value);
  if (of.kind === 'name' && routine) {
    const array = routine.parameters.find(({ name }) => name === of.name)?.lengthOf;
    if (array !== undefined) return `${printer.name(array)}.len()`;
    if (sizesIn(routine).has(of.name)) return printer.name(of.name);
  }
  if (of.kind === 'put so far') return 'frame.len()';
  if (of.kind === 'convert' && (of.of.type === 'byte' || of.of.type === 'word'))
    return `usize::from(${printer.operand(of.of, LEVEL.least)})`;
  const level = of.kind === 'binary' ? levelOf(of.operator) : undefined;
  if (of.kind === 'binary' && level !== undefined) {
    const right = level === LEVEL.sum ? LEVEL.product : LEVEL.unary;
    const text = `${sizeText(of.left, printer, level)} ${of.operator} ${sizeText(of.right, printer, right)}`;
    return level < least ? `(${text})` : text;
  }
  const text = `${printer.at(of, LEVEL.unary)} as usize`;
  return least > LEVEL.least ? `(${text})` : text;
}
