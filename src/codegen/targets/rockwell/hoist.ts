import {
  type Argument,
  type Code,
  type Expression,
  type Name,
  name,
  type Routine,
  type Scalar,
  type Statement,
} from '../../code.ts';
import { FRAME } from '../iec/lower.ts';
import type { Raws } from './rockwell-syntax.ts';

/** What stands in a routine by names of tags. */
export interface Tags {
  /** The tag of a variable of a routine. */
  readonly of: (routine: Name, variable: Name) => string;
  /** The tag of what a routine gives. */
  readonly result: (routine: Name) => string;
  readonly routine: (routine: Name) => string;
  /** A new variable of the routine that is written. */
  readonly spare: (type: Scalar) => Name;
  /** How many elements the array of a parameter has. */
  readonly size: (routine: Name, parameter: Name) => number;
}

/** Writes calls as statements of their own, in front of those that use what they give: JSR has no value. */
export class Hoist {
  readonly #code: Code;
  readonly #routine: Routine;
  readonly #tags: Tags;
  readonly #raws: Raws;
  readonly #print: (expression: Expression) => string;

  constructor(code: Code, routine: Routine, tags: Tags, raws: Raws, print: (expression: Expression) => string) {
    this.#code = code;
    this.#routine = routine;
    this.#tags = tags;
    this.#raws = raws;
    this.#print = print;
  }

  statements(all: readonly Statement[]): readonly Statement[] {
    return all.flatMap((one) => {
      const before: Statement[] = [];
      const of = (expression: Expression) => this.#expression(expression, before);
      switch (one.kind) {
        case 'declare':
          return after(before, { ...one, value: of(one.value) });
        case 'set':
          return after(before, { ...one, to: of(one.to) as typeof one.to, value: of(one.value) });
        case 'if': {
          const then = this.statements(one.then);
          const when = of(one.when);
          return after(before, { ...one, when, then, otherwise: this.statements(one.otherwise) });
        }
        case 'for':
          return after(before, { ...one, from: of(one.from), to: of(one.to), body: this.statements(one.body) });
        case 'while': {
          const when = of(one.when);
          if (before.length > 0) throw new TypeError('a call in the condition of a loop');
          return [{ ...one, when, body: this.statements(one.body) }];
        }
        default:
          return [one];
      }
    });
  }

  #raw(text: string): Statement {
    return this.#raws.statement(text);
  }

  #expression(expression: Expression, before: Statement[]): Expression {
    const of = (one: Expression) => this.#expression(one, before);
    switch (expression.kind) {
      case 'element':
        return { ...expression, index: of(expression.index) };
      case 'binary':
        return { ...expression, left: of(expression.left), right: of(expression.right) };
      case 'not':
      case 'convert':
      case 'signed':
        return { ...expression, of: of(expression.of) };
      case 'float':
        return this.#float(of(expression.of), before);
      case 'floor':
        return this.#floor(of(expression.of), before);
      case 'call':
        return this.#call(expression, before);
      default:
        return expression;
    }
  }

  #own(variable: Name): string {
    return this.#tags.of(this.#routine.name, variable);
  }

  #call({ routine, arguments: given, type }: Extract<Expression, { kind: 'call' }>, before: Statement[]): Expression {
    const { parameters = [] } = this.#code.routines.find((one) => one.name === routine) ?? {};
    const after: Statement[] = [];
    for (const [index, argument] of given.entries()) {
      const parameter = parameters[index];
      if (parameter === undefined) throw new TypeError(`${routine} has no such parameter`);
      const tag = this.#tags.of(routine, parameter.name);
      if (argument.kind === 'array') {
        const [array, size] = [this.#array(argument), this.#tags.size(routine, parameter.name)];
        before.push(this.#raw(`COP(${array}[0], ${tag}[0], ${size});`));
        if (parameter.filled) after.push(this.#raw(`COP(${tag}[0], ${array}[0], ${size});`));
      } else before.push(this.#raw(`${tag} := ${this.#print(this.#expression(argument, before))};`));
    }
    before.push(this.#raw(`JSR(${this.#tags.routine(routine)}, 0);`), ...after);
    const spare = this.#tags.spare(type);
    before.push(this.#raw(`${this.#own(spare)} := ${this.#tags.result(routine)};`));
    return name(type, spare);
  }

  #array({ array }: Extract<Argument, { kind: 'array' }>): string {
    return this.#own(array === FRAME ? FRAME : array);
  }

  /** COP copies the bits. */
  #float(of: Expression, before: Statement[]): Expression {
    const [bits, real] = [this.#tags.spare('dword'), this.#tags.spare('real')];
    before.push(this.#raw(`${this.#own(bits)} := ${this.#print(of)};`));
    before.push(this.#raw(`COP(${this.#own(bits)}, ${this.#own(real)}, 1);`));
    return name('real', real);
  }

  #floor(of: Expression, before: Statement[]): Expression {
    const [whole, text] = [this.#tags.spare('real'), this.#print(of)];
    const tag = this.#own(whole);
    before.push(this.#raw(`${tag} := TRUNC(${text});`));
    before.push(this.#raw(`IF ${tag} > ${text} THEN ${tag} := ${tag} - 1.0; END_IF;`));
    return name('real', whole);
  }
}

const after = (before: readonly Statement[], statement: Statement): readonly Statement[] => [...before, statement];
