import { Refused, type Token, tokensOf } from './tokens.ts';

export type Expression = { readonly line: number } & (
  | { readonly kind: 'literal'; readonly type: string | undefined; readonly value: number | boolean | string }
  | { readonly kind: 'real'; readonly value: number }
  | { readonly kind: 'time'; readonly value: number }
  | { readonly kind: 'name'; readonly name: string }
  | { readonly kind: 'element'; readonly array: string; readonly index: Expression }
  | { readonly kind: 'member'; readonly block: string; readonly name: string }
  | { readonly kind: 'call'; readonly name: string; readonly given: readonly Given[] }
  | { readonly kind: 'binary'; readonly operator: string; readonly left: Expression; readonly right: Expression }
  | { readonly kind: 'unary'; readonly operator: '-' | 'NOT'; readonly of: Expression }
);
export interface Given {
  /** Absent where it is given by its place. */
  readonly name: string | undefined;
  readonly value: Expression;
}

export type Statement = { readonly line: number } & (
  | { readonly kind: 'set'; readonly to: Expression; readonly value: Expression }
  | { readonly kind: 'invoke'; readonly block: string; readonly given: readonly Given[] }
  | {
      readonly kind: 'if';
      readonly cases: readonly { readonly when: Expression; readonly body: readonly Statement[] }[];
      readonly otherwise: readonly Statement[];
    }
  | {
      readonly kind: 'case';
      readonly of: Expression;
      readonly cases: readonly { readonly labels: readonly number[]; readonly body: readonly Statement[] }[];
      readonly otherwise: readonly Statement[];
    }
  | {
      readonly kind: 'for';
      readonly name: string;
      readonly from: Expression;
      readonly to: Expression;
      readonly body: readonly Statement[];
    }
  | { readonly kind: 'while'; readonly when: Expression; readonly body: readonly Statement[] }
  | { readonly kind: 'return' }
);

export interface Variable {
  readonly section: string;
  readonly name: string;
  readonly type: Type;
  readonly first: readonly Expression[] | undefined;
  readonly line: number;
}
export type Type = string | { readonly size: number; readonly of: string };

export interface Unit {
  readonly kind: 'FUNCTION' | 'FUNCTION_BLOCK';
  readonly name: string;
  readonly gives: string | undefined;
  readonly variables: readonly Variable[];
  readonly body: readonly Statement[];
  readonly line: number;
}

export interface Source {
  readonly types: ReadonlyMap<string, Extract<Type, object>>;
  readonly units: readonly Unit[];
}

const SECTIONS = new Set(['VAR', 'VAR_INPUT', 'VAR_OUTPUT', 'VAR_IN_OUT']);
/** From what binds least to what binds most (IEC 61131-3, table 71). */
const LEVELS: readonly (readonly string[])[] = [
  ['OR'],
  ['XOR'],
  ['AND'],
  ['=', '<>'],
  ['<', '>', '<=', '>='],
  ['+', '-'],
  ['*', '/', 'MOD'],
];

export const parse = (text: string): Source => new Parser(tokensOf(text)).source();

class Parser {
  readonly #tokens: readonly Token[];
  #at = 0;

  constructor(tokens: readonly Token[]) {
    this.#tokens = tokens;
  }

  source(): Source {
    const types = new Map<string, Extract<Type, object>>();
    const units: Unit[] = [];
    while (this.#token.kind !== 'end') {
      if (this.#is('TYPE')) {
        this.#next();
        while (!this.#is('END_TYPE')) {
          const name = this.#name();
          this.#take(':');
          const type = this.#type();
          if (typeof type === 'string') throw this.#refused('a type is an array here');
          types.set(name.toUpperCase(), type);
          this.#take(';');
        }
        this.#next();
      } else units.push(this.#unit());
    }
    return { types, units };
  }

  #unit(): Unit {
    const { line } = this.#token;
    const kind = this.#next().text;
    if (kind !== 'FUNCTION' && kind !== 'FUNCTION_BLOCK') throw new Refused('not a unit', line, kind);
    const name = this.#name();
    if (kind === 'FUNCTION') this.#take(':');
    const gives = kind === 'FUNCTION' ? this.#name() : undefined;
    const variables: Variable[] = [];
    let constants = false;
    while (SECTIONS.has(this.#token.text)) {
      const begun = this.#next();
      let section = begun.text;
      if (this.#is('CONSTANT')) {
        this.#next();
        section = 'CONSTANT';
        constants = true;
      } else if (constants) throw new Refused('variables come before constants', begun.line);
      while (!this.#is('END_VAR')) variables.push(this.#variable(section));
      this.#next();
    }
    const body = this.#statements(`END_${kind}`);
    this.#take(`END_${kind}`);
    return { kind, name, gives, variables, body, line };
  }

  #variable(section: string): Variable {
    const { line } = this.#token;
    const name = this.#name();
    this.#take(':');
    const type = this.#type();
    let first: Expression[] | undefined;
    if (this.#is(':=')) {
      this.#next();
      first = this.#is('[') ? this.#list() : [this.#expression()];
    }
    this.#take(';');
    return { section, name, type, first, line };
  }

  #list(): Expression[] {
    this.#take('[');
    const list = [this.#expression()];
    while (this.#is(',')) {
      this.#next();
      list.push(this.#expression());
    }
    this.#take(']');
    return list;
  }

  #type(): Type {
    if (!this.#is('ARRAY')) return this.#name();
    this.#next();
    this.#take('[');
    if (this.#next().text !== '0') throw this.#refused('arrays begin at 0 here');
    this.#take('..');
    const last = this.#next();
    if (last.kind !== 'number') throw this.#refused('a constant bound');
    this.#take(']');
    this.#take('OF');
    return { size: Number(last.text) + 1, of: this.#name() };
  }

  #statements(...ends: readonly string[]): Statement[] {
    const found: Statement[] = [];
    while (!ends.includes(this.#token.text) && !(ends.includes('label') && this.#isLabel)) {
      found.push(this.#statement());
    }
    return found;
  }

  #statement(): Statement {
    const { line, text, kind } = this.#token;
    switch (text) {
      case 'IF': {
        const cases = [];
        let next: string = text;
        while (next === 'IF' || next === 'ELSIF') {
          this.#next();
          const when = this.#expression();
          this.#take('THEN');
          cases.push({ when, body: this.#body(line, 'ELSIF', 'ELSE', 'END_IF') });
          next = this.#token.text;
        }
        const otherwise = this.#otherwise('END_IF');
        return { kind: 'if', line, cases, otherwise };
      }
      case 'CASE': {
        this.#next();
        const of = this.#expression();
        this.#take('OF');
        const cases = [];
        while (this.#isLabel) {
          const negative = this.#is('-');
          if (negative) this.#next();
          const label = Number(this.#next().text);
          const labels = [negative ? -label : label];
          this.#take(':');
          cases.push({ labels, body: this.#body(line, 'label', 'ELSE', 'END_CASE') });
        }
        return { kind: 'case', line, of, cases, otherwise: this.#otherwise('END_CASE') };
      }
      case 'FOR': {
        this.#next();
        const name = this.#name();
        this.#take(':=');
        const from = this.#expression();
        this.#take('TO');
        const to = this.#expression();
        this.#take('DO');
        const body = this.#body(line, 'END_FOR');
        this.#closed('END_FOR');
        return { kind: 'for', line, name, from, to, body };
      }
      case 'WHILE': {
        this.#next();
        const when = this.#expression();
        this.#take('DO');
        const body = this.#body(line, 'END_WHILE');
        this.#closed('END_WHILE');
        return { kind: 'while', line, when, body };
      }
      case 'RETURN':
        this.#next();
        this.#take(';');
        return { kind: 'return', line };
    }
    if (kind !== 'name') throw this.#refused('no statement');
    const name = this.#name();
    if (this.#is('(')) {
      const given = this.#given();
      this.#take(';');
      return { kind: 'invoke', line, block: name, given };
    }
    const to = this.#variableOf(name, line);
    this.#take(':=');
    const value = this.#expression();
    this.#take(';');
    return { kind: 'set', line, to, value };
  }

  #body(line: number, ...ends: readonly string[]): Statement[] {
    const body = this.#statements(...ends);
    if (body.length === 0) throw new Refused('a block without a statement', line);
    return body;
  }

  #otherwise(end: string): readonly Statement[] {
    let otherwise: Statement[] = [];
    if (this.#is('ELSE')) {
      const { line } = this.#next();
      otherwise = this.#body(line, end);
    }
    this.#closed(end);
    return otherwise;
  }

  #closed(end: string): void {
    this.#take(end);
    this.#take(';');
  }

  #expression(level = 0): Expression {
    const operators = LEVELS[level];
    if (operators === undefined) return this.#unary();
    let left = this.#expression(level + 1);
    while (operators.includes(this.#token.text)) {
      const { text: operator, line } = this.#next();
      left = { kind: 'binary', line, operator, left, right: this.#expression(level + 1) };
    }
    return left;
  }

  #unary(): Expression {
    const { text, line } = this.#token;
    if (text === '-' || text === 'NOT') {
      this.#next();
      const of = this.#unary();
      if (text === '-' && of.kind === 'literal') return { ...of, value: -Number(of.value) };
      return { kind: 'unary', line, operator: text, of };
    }
    if (text === '(') {
      this.#next();
      const inside = this.#expression();
      this.#take(')');
      return inside;
    }
    const token = this.#next();
    switch (token.kind) {
      case 'number':
        return { kind: 'literal', line, type: undefined, value: Number(text) };
      case 'real':
        return { kind: 'real', line, value: Number(text) };
      case 'time':
        return { kind: 'time', line, value: Number.parseInt(text.slice(2), 10) * (text.endsWith('ms') ? 1 : 1000) };
      case 'string':
        return { kind: 'literal', line, type: 'STRING', value: text.slice(1, -1).replace(/\$([$'])/g, '$1') };
      case 'typed': {
        const [type = '', ...digits] = text.split('#');
        const value = digits.length === 2 ? Number.parseInt(digits[1] ?? '', 16) : Number(digits[0]);
        return { kind: 'literal', line, type, value };
      }
      case 'name':
        if (text === 'TRUE' || text === 'FALSE') return { kind: 'literal', line, type: 'BOOL', value: text === 'TRUE' };
        return this.#is('(') ? { kind: 'call', line, name: text, given: this.#given() } : this.#variableOf(text, line);
      default:
        throw new Refused('no expression', line, text);
    }
  }

  #variableOf(name: string, line: number): Expression {
    if (this.#is('[')) {
      this.#next();
      const index = this.#expression();
      this.#take(']');
      return { kind: 'element', line, array: name, index };
    }
    if (!this.#is('.')) return { kind: 'name', line, name };
    this.#next();
    return { kind: 'member', line, block: name, name: this.#name() };
  }

  #given(): readonly Given[] {
    this.#take('(');
    const given: Given[] = [];
    while (!this.#is(')')) {
      if (given.length > 0) this.#take(',');
      const named = this.#token.kind === 'name' && this.#tokens[this.#at + 1]?.text === ':=';
      const name = named ? this.#name() : undefined;
      if (named) this.#take(':=');
      given.push({ name, value: this.#expression() });
    }
    this.#next();
    return given;
  }

  get #token(): Token {
    const token = this.#tokens[this.#at];
    if (!token) throw new RangeError('behind the end');
    return token;
  }

  get #isLabel(): boolean {
    return this.#token.kind === 'number' || this.#is('-');
  }

  #is(text: string): boolean {
    return this.#token.text === text && this.#token.kind !== 'string';
  }

  #next(): Token {
    const token = this.#token;
    this.#at++;
    return token;
  }

  #take(text: string): void {
    if (!this.#is(text)) throw this.#refused(`${text} is missing`);
    this.#at++;
  }

  #name(): string {
    if (this.#token.kind !== 'name') throw this.#refused('a name is missing');
    return this.#next().text;
  }

  #refused(rule: string): Refused {
    return new Refused(rule, this.#token.line, this.#token.text);
  }
}
