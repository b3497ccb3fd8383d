import type { Expression, Name, Operator, Routine, Statement } from '../code.ts';
import { LEVEL, type Level, type Printer } from '../syntax.ts';

const levelOf = (operator: Operator): Level | undefined => {
  if (operator === '+' || operator === '-') return LEVEL.sum;
  return operator === '*' || operator === '/' || operator === '%' ? LEVEL.product : undefined;
};

const lengthOf = (name: Name, routine: Routine): Name | undefined =>
  routine.parameters.find((parameter) => parameter.name === name)?.lengthOf;

/**
 * Rust counts and indexes with `usize`, all else of `int` is `i32`. Numbers that are made of lengths, counters and bytes without
 * subtraction are written as `usize` as they are; others are converted where an index stands.
 */
export class Sizes {
  readonly #found = new WeakMap<Routine, ReadonlySet<Name>>();

  /** The variables of a routine that are `usize`: counters of loops and constants made of them. */
  in(routine: Routine): ReadonlySet<Name> {
    const known = this.#found.get(routine);
    if (known) return known;
    const found = new Set<Name>();
    this.#found.set(routine, found);
    const look = (statements: readonly Statement[]): void => {
      for (const one of statements) {
        if (one.kind === 'for' && this.is(one.from, routine) && this.is(one.to, routine)) found.add(one.name);
        if (one.kind === 'declare' && !one.changes && one.value.kind !== 'number' && this.is(one.value, routine))
          found.add(one.name);
        if (one.kind === 'for' || one.kind === 'while') look(one.body);
        if (one.kind === 'if') look([...one.then, ...one.otherwise]);
      }
    };
    look(routine.body);
    return found;
  }

  /** Whether an `int` is never negative, and can be written as `usize` without a cast. */
  is(of: Expression, routine: Routine | undefined): boolean {
    if (of.type !== 'int' || routine === undefined) return false;
    if (of.kind === 'number') return of.value >= 0;
    if (of.kind === 'name') return lengthOf(of.name, routine) !== undefined || this.in(routine).has(of.name);
    if (of.kind === 'convert') return of.of.type === 'byte' || of.of.type === 'word';
    return of.kind === 'binary' && of.operator !== '-' && this.is(of.left, routine) && this.is(of.right, routine);
  }

  /** A number that is never negative as `usize`. */
  text(of: Expression, printer: Printer, least: Level = LEVEL.least): string {
    const { routine } = printer;
    if (of.kind === 'number') return String(of.value);
    if (of.kind === 'name' && routine) {
      const array = lengthOf(of.name, routine);
      if (array !== undefined) return `${printer.name(array)}.len()`;
      if (this.in(routine).has(of.name)) return printer.name(of.name);
    }
    if (of.kind === 'put so far') return 'frame.len()';
    if (of.kind === 'convert' && (of.of.type === 'byte' || of.of.type === 'word'))
      return `usize::from(${printer.operand(of.of, LEVEL.least)})`;
    const level = of.kind === 'binary' ? levelOf(of.operator) : undefined;
    if (of.kind === 'binary' && level !== undefined) {
      const right = level === LEVEL.sum ? LEVEL.product : LEVEL.unary;
      const text = `${this.text(of.left, printer, level)} ${of.operator} ${this.text(of.right, printer, right)}`;
      return level < least ? `(${text})` : text;
    }
    const text = `${printer.at(of, LEVEL.unary)} as usize`;
    return least > LEVEL.least ? `(${text})` : text;
  }
}
