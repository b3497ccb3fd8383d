/**
 * Prints `Code` in a language, which a `Syntax` describes. Parentheses stand where operators of different kinds meet (a shift
 * in a bitwise operation, `and` in `or`), whether the language needs them or not: so one rule serves all languages, and
 * compilers that warn of doubtful precedence are content.
 * @module
 */
import { inColumns, inOneColumn, inSections } from './align.ts';
import type {
  Argument,
  Code,
  Constant,
  Expression,
  Name,
  Operator,
  Parameter,
  Routine,
  Statement,
  Table,
} from './code.ts';
import {
  type Block,
  LEVEL,
  type Level,
  type Printed,
  type Printer,
  type Remarked,
  type Role,
  type Syntax,
  whole,
} from './syntax.ts';
import type { Lines } from './written.ts';

export { overflows } from './width.ts';

const LEVELS: Readonly<Record<Operator, Level>> = {
  '*': LEVEL.product,
  '/': LEVEL.product,
  '%': LEVEL.product,
  '+': LEVEL.sum,
  '-': LEVEL.sum,
  '<<': LEVEL.shift,
  '>>': LEVEL.shift,
  '&': LEVEL.bitwise,
  '|': LEVEL.bitwise,
  '^': LEVEL.bitwise,
  '=': LEVEL.relation,
  '≠': LEVEL.relation,
  '<': LEVEL.relation,
  '≤': LEVEL.relation,
  '>': LEVEL.relation,
  '≥': LEVEL.relation,
  and: LEVEL.and,
  or: LEVEL.or,
};
/** What stands beside these without parentheses: the same operator, and what binds at least as tightly as this. */
const BESIDE: Readonly<Partial<Record<Level, Level>>> = {
  [LEVEL.product]: LEVEL.unary,
  [LEVEL.sum]: LEVEL.product,
  [LEVEL.shift]: LEVEL.unary,
  [LEVEL.bitwise]: LEVEL.unary,
  [LEVEL.relation]: LEVEL.sum,
  [LEVEL.and]: LEVEL.not,
  [LEVEL.or]: LEVEL.not,
};
const JOINS: ReadonlySet<Operator> = new Set(['&', '|', '^', 'and', 'or']);

const sameTarget = (one: Expression, other: Expression): boolean => JSON.stringify(one) === JSON.stringify(other);

/** Text that may stand in a comment: in one line, without control characters and without marks that turn the direction of writing. */
export const plainText = (text: string): string =>
  text.replace(/[\p{Cc}\p{Zl}\p{Zp}\p{Bidi_Control}\p{Cs}]+/gu, ' ').trim();

const ELEMENTS_A_LINE = 8;

export class CodePrinter implements Printer {
  readonly syntax: Syntax;
  readonly comments: boolean;
  routine: Routine | undefined;
  readonly #roles: ReadonlyMap<Name, Role>;
  readonly #routines: ReadonlyMap<Name, Routine>;

  /** `code` is everything that is known in the file. */
  constructor(syntax: Syntax, code: Code, comments: boolean) {
    this.syntax = syntax;
    this.comments = comments;
    this.#roles = new Map<Name, Role>([
      ...code.constants.map(({ name }) => [name, 'constant'] as const),
      ...code.tables.map(({ name }) => [name, 'table'] as const),
    ]);
    this.#routines = new Map(code.routines.map((routine) => [routine.name, routine]));
  }

  role(name: Name): Role {
    return this.#roles.get(name) ?? 'variable';
  }

  name(name: Name, role: Role = this.role(name)): string {
    return this.syntax.name(name, role);
  }

  at(expression: Expression, least: Level): string {
    return enclosed(this.print(expression), least);
  }

  operand(expression: Expression, least: Level): string {
    return enclosed(this.#fit(expression, 'operand'), least);
  }

  slot(expression: Expression): string {
    return this.#fit(expression, 'slot').text;
  }

  print(expression: Expression): Printed {
    const { syntax } = this;
    const special = syntax.special?.(expression, this);
    if (special) return special;
    switch (expression.kind) {
      case 'number':
        return whole(syntax.number(expression));
      case 'truth':
        return whole(syntax.truth(expression.value));
      case 'name':
        return this.#lengthName(expression.name) ?? whole(this.name(expression.name));
      case 'element':
        return whole(`${this.name(expression.array)}[${this.slot(expression.index)}]`);
      case 'binary':
        return this.#binary(expression);
      case 'not':
        return { text: syntax.not.text + this.at(expression.of, syntax.not.level), level: syntax.not.level };
      case 'call':
        return whole(`${this.name(expression.routine, 'routine')}(${this.#arguments(expression).join(', ')})`);
      case 'put so far':
        return syntax.soFar;
      case 'convert':
      case 'signed':
      case 'float':
      case 'floor':
        return (syntax[expression.kind] as (of: Expression, printer: Printer) => Printed)(expression, this);
    }
  }

  argument(argument: Argument): string {
    if (argument.kind !== 'array') return this.slot(argument);
    const name = this.name(argument.array);
    return this.syntax.array?.(name, this, argument.array) ?? name;
  }

  parameters(routine: Routine): readonly Parameter[] {
    return routine.parameters.filter(({ lengthOf }) => this.syntax.slices === undefined || lengthOf === undefined);
  }

  /** A parameter that is the length of an array which knows it. */
  #lengthName(name: Name): Printed | undefined {
    const array = this.routine?.parameters.find((parameter) => parameter.name === name)?.lengthOf;
    return array === undefined ? undefined : this.syntax.slices?.length(this.name(array));
  }

  #arguments({ routine, arguments: given }: Extract<Expression, { kind: 'call' }>): readonly string[] {
    const { slices } = this.syntax;
    const texts = given.map((argument) => this.argument(argument));
    const parameters = this.#routines.get(routine)?.parameters ?? [];
    if (slices === undefined) return texts;
    return texts.flatMap((text, at) => {
      if (parameters[at]?.lengthOf !== undefined) return [];
      const name = parameters[at]?.name;
      const length = given[parameters.findIndex(({ lengthOf }) => lengthOf !== undefined && lengthOf === name)];
      const array = given[at];
      if (length === undefined || length.kind === 'array' || array?.kind !== 'array') return [text];
      return this.#isWhole(array.array, length) ? [text] : [slices.first(text, this.slot(length), length, this)];
    });
  }

  /** Whether this is the length of the whole array. */
  #isWhole(array: Name, length: Expression): boolean {
    if (length.kind === 'put so far') return true;
    const own = this.routine?.parameters.find(({ lengthOf }) => lengthOf === array);
    return length.kind === 'name' && length.name === own?.name;
  }

  statements(lines: Lines, statements: readonly Statement[]): void {
    if (this.syntax.nothing !== undefined && !statements.some(({ kind }) => kind !== 'remark'))
      lines.add(this.syntax.nothing);
    let run: Remarked[] = [];
    const align = () => {
      this.aligned(lines, run);
      run = [];
    };
    for (const statement of statements) {
      const text = this.#simple(statement);
      if (text !== undefined) run.push({ text, comment: statement.comment, spans: statement.spans });
      else {
        align();
        this.#block(lines, statement);
      }
    }
    align();
  }

  aligned(lines: Lines, of: readonly Remarked[]): void {
    const rows = of.map(({ text, comment, spans, ends }) => ({
      text,
      ends,
      mark: comment && this.comments ? this.syntax.comment(plainText(comment)) : '',
      spans,
    }));
    const align = this.syntax.sections ? inSections : inOneColumn;
    align(lines, rows, this.syntax.gap ?? ' ');
  }

  remark(lines: Lines, ...texts: readonly string[]): void {
    if (this.comments) for (const text of texts) lines.add(this.syntax.comment(plainText(text)));
  }

  /** Everything of `code`, each part after an empty line. */
  code(lines: Lines, code: Code): void {
    lines.add('');
    this.constants(lines, code.constants);
    for (const table of code.tables) this.table(lines.add(''), table);
    for (const texts of code.texts) this.syntax.texts(texts, lines.part(), this);
    for (const routine of code.routines) this.routineOf(lines.part(), routine);
  }

  routineOf(lines: Lines, routine: Routine): void {
    this.routine = routine;
    const { before, inside, last, end } = this.syntax.routine(routine, this);
    const add = (texts: readonly string[]) => {
      for (const text of texts) lines.add(text);
    };
    add(before);
    lines.inside(() => {
      add(inside);
      this.statements(lines, routine.body);
      add(last);
    });
    add(end);
    this.routine = undefined;
  }

  constants(lines: Lines, constants: readonly Constant[]): void {
    this.group(
      lines,
      constants.map((constant) => ({
        text: this.syntax.constant(constant, this.syntax.number({ ...constant, kind: 'number' }), this),
        comment: constant.comment,
      })),
    );
  }

  /** Constants, as they are written, with what the language writes around all of them. */
  group(lines: Lines, of: readonly Remarked[]): void {
    const { constants: around } = this.syntax;
    if (around === undefined || of.length === 0) this.aligned(lines, of);
    else {
      const texts = inColumns(
        of.map(({ text }) => text),
        around.mark,
      );
      lines.add(around.head);
      lines.inside(() =>
        this.aligned(
          lines,
          of.map((one, at) => ({ ...one, text: texts[at] ?? one.text })),
        ),
      );
      lines.add(around.end);
    }
  }

  table(lines: Lines, table: Table): void {
    const { head, end, lastMark = false } = this.syntax.table(table, this);
    const texts = table.values.map((value, index) => {
      const number = { kind: 'number', type: table.type, value, base: table.base } as const;
      const text = this.syntax.element?.(number, table) ?? this.syntax.number(number);
      return text + (lastMark || index < table.values.length - 1 ? ',' : '');
    });
    const rows =
      table.rows ??
      texts.flatMap((_, from) => (from % ELEMENTS_A_LINE === 0 ? [{ from, to: from + ELEMENTS_A_LINE }] : []));
    if (table.comment !== '') this.remark(lines, table.comment);
    lines.add(head);
    lines.inside(() =>
      this.aligned(
        lines,
        rows.map((row) => ({
          text: texts.slice(row.from, row.to).join(' '),
          comment: 'comment' in row ? row.comment : undefined,
          spans: 'span' in row ? [row.span] : undefined,
          // As gofmt has it.
          ends: row.to - row.from > 1,
        })),
      ),
    );
    if (end !== '') lines.add(end);
  }

  #fit(expression: Expression, where: 'operand' | 'slot'): Printed {
    const printed = this.print(expression);
    return this.syntax.fit?.(expression, printed, where, this) ?? printed;
  }

  #binary(expression: Extract<Expression, { kind: 'binary' }>): Printed {
    const { operator, left, right } = expression;
    const level = LEVELS[operator];
    const side = (of: Expression, isRight: boolean): string => {
      const inside = of.kind === 'binary' ? of.operator : undefined;
      const same = inside !== undefined && (inside === operator || (level >= LEVEL.sum && LEVELS[inside] === level));
      const beside =
        same && level !== LEVEL.relation && (!isRight || JOINS.has(operator)) ? level : (BESIDE[level] ?? LEVEL.unary);
      const shows =
        level === LEVEL.relation || operator === '>>' || level >= LEVEL.sum || (level === LEVEL.shift && isRight);
      return shows ? this.operand(of, beside) : this.at(of, beside);
    };
    return { text: `${side(left, false)} ${this.syntax.operators[operator]} ${side(right, true)}`, level };
  }

  /** The text of a statement that is one line; `undefined` for blocks and remarks. */
  #simple(statement: Statement): string | undefined {
    const { syntax } = this;
    if (statement.kind === 'declare') return syntax.declare(statement, this);
    if (statement.kind === 'put') return syntax.put(this.slot(statement.value), this, statement.value);
    if (statement.kind === 'return') {
      const last = statement === this.routine?.body.at(-1) ? syntax.giveLast : undefined;
      return (last ?? syntax.give)(this.slot(statement.value), this);
    }
    if (statement.kind !== 'set') return undefined;
    const { to, value } = statement;
    const target = this.print(to).text;
    const short =
      value.kind === 'binary' && sameTarget(value.left, to) ? syntax.update?.(target, value, this) : undefined;
    return short ?? syntax.set(target, this.slot(value));
  }

  #block(lines: Lines, statement: Statement): void {
    const { syntax } = this;
    if (statement.comment !== undefined) this.remark(lines, statement.comment);
    if (statement.kind === 'remark') this.remark(lines, statement.text);
    const within = (head: string, body: readonly Statement[], spans = statement.spans) =>
      lines.add(head, spans).inside(() => this.statements(lines, body));
    const around = (block: Block, body: readonly Statement[]) => {
      within(block.head, body);
      if (block.end !== '') lines.add(block.end);
    };
    if (statement.kind === 'while') around(syntax.during(this.print(statement.when).text), statement.body);
    if (statement.kind === 'for') around(syntax.repeat(statement, this), statement.body);
    if (statement.kind !== 'if') return;
    const block = syntax.when(this.print(statement.when).text);
    within(block.head, statement.then);
    let rest = statement.otherwise;
    for (let next = rest[0]; rest.length === 1 && next?.kind === 'if' && !next.comment; next = rest[0]) {
      within(syntax.otherwiseWhen(this.print(next.when).text), next.then, next.spans);
      rest = next.otherwise;
    }
    if (rest.length > 0) within(syntax.otherwise, rest, []);
    if (block.end !== '') lines.add(block.end);
  }
}

const enclosed = ({ text, level }: Printed, least: Level): string => (level >= least ? text : `(${text})`);
