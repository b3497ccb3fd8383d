import { isReserved } from '../../../src/codegen/targets/iec/words.ts';
import {
  BITS,
  checked,
  conversion,
  firstOf,
  holdsNumber,
  isBits,
  isElementary,
  isNumeric,
  isWhole,
} from './elementary.ts';
import { type Expression, type Given, parse, type Statement, type Type, type Unit, type Variable } from './parse.ts';
import { Refused } from './tokens.ts';

interface Cell {
  v: unknown;
}
type Scope = readonly Cell[];
interface Typed {
  readonly type: string;
  readonly run: (scope: Scope) => unknown;
}
type Run = (scope: Scope) => typeof RETURNED | undefined;
const RETURNED = Symbol('returned');
const MOST_ROUNDS = 100_000;

interface Ready {
  readonly unit: Unit;
  readonly slots: ReadonlyMap<string, Slot>;
  readonly fresh: () => Cell[];
  readonly run: Run;
}
interface Slot {
  readonly index: number;
  readonly variable: Variable;
  readonly type: string;
  used: boolean;
  set: boolean;
  fixed: boolean;
}

/** A program that a strict compiler takes, ready to run; `Refused` for any other. Time stands still but for `now`. */
export class Machine {
  /** Milliseconds. */
  now = 0;
  readonly #types: ReadonlyMap<string, { readonly size: number; readonly of: string }>;
  readonly #ready = new Map<string, Ready>();

  constructor(text: string) {
    const { types, units } = parse(text);
    this.#types = types;
    const names = new Set<string>();
    for (const { name, line } of [...[...types.keys()].map((name) => ({ name, line: 1 })), ...units]) {
      legal(name, line, names);
    }
    for (const unit of units) this.#ready.set(unit.name.toUpperCase(), this.#compile(unit));
  }

  get units(): readonly string[] {
    return [...this.#ready.values()].map(({ unit }) => unit.name);
  }

  /** Calls a function with its parameters in their order. Arrays are filled. */
  call(name: string, ...given: readonly unknown[]): unknown {
    const ready = this.#unit(name, 'FUNCTION', 0);
    const scope = ready.fresh();
    const parameters = parametersOf(ready.unit);
    if (parameters.length !== given.length) throw new RangeError(`${name} has ${parameters.length} parameters`);
    for (const [index, variable] of parameters.entries())
      (scope[index] as Cell).v = this.#passed(variable, given[index]);
    ready.run(scope);
    return scope.at(-1)?.v;
  }

  parameters(name: string): readonly string[] {
    return parametersOf(this.#unit(name, undefined, 0).unit).map((one) => one.name);
  }

  /** An array of a type of the program, or of so many bytes. */
  array(size: number): number[] {
    return new Array<number>(size).fill(0);
  }

  frame(): number[] {
    return this.array(this.#types.get('T_MODBUSFRAME')?.size ?? 0);
  }

  /** An instance of a function block. */
  instance(name: string): Instance {
    const ready = this.#unit(name, 'FUNCTION_BLOCK', 0);
    const scope = ready.fresh();
    const cell = (of: string): Cell => {
      const slot = ready.slots.get(of.toUpperCase());
      if (!slot) throw new RangeError(`${name} has no ${of}`);
      return scope[slot.index] as Cell;
    };
    return {
      cycle: (given) => {
        for (const [of, value] of Object.entries(given)) cell(of).v = value;
        ready.run(scope);
      },
      get: (of) => cell(of).v,
      has: (of) => ready.slots.has(of.toUpperCase()),
    };
  }

  #passed({ type }: Variable, value: unknown): unknown {
    const size = typeof type === 'string' ? this.#types.get(type.toUpperCase())?.size : type.size;
    if (size === undefined) return value;
    const list = value as readonly unknown[];
    if (list.length === size) return list;
    throw new RangeError(`an array of ${size}, not ${list.length}`);
  }

  #unit(name: string, kind: Unit['kind'] | undefined, line: number): Ready {
    const found = this.#ready.get(name.toUpperCase());
    if (!found || (kind && found.unit.kind !== kind)) throw new Refused('not declared before', line, name);
    return found;
  }

  #compile(unit: Unit): Ready {
    return new UnitCompiler(unit, this, this.#types, (name, line) => this.#unit(name, 'FUNCTION', line)).ready();
  }
}

export interface Instance {
  /** One cycle; arrays are passed as they are. */
  cycle(given: Readonly<Record<string, unknown>>): void;
  get(name: string): unknown;
  has(name: string): boolean;
}

const parametersOf = ({ variables }: Unit): readonly Variable[] =>
  variables.filter(({ section }) => section === 'VAR_INPUT' || section === 'VAR_IN_OUT');

function legal(name: string, line: number, taken: Set<string>): void {
  if (isReserved(name)) throw new Refused('a name that the language keeps', line, name);
  if (/__|_$|^_/.test(name)) throw new Refused('underlines in a row or at an end', line, name);
  if (taken.has(name.toUpperCase())) throw new Refused('a name twice', line, name);
  taken.add(name.toUpperCase());
}

class UnitCompiler {
  readonly #unit: Unit;
  readonly #clock: { readonly now: number };
  readonly #types: ReadonlyMap<string, { readonly size: number; readonly of: string }>;
  readonly #function: (name: string, line: number) => Ready;
  readonly #slots = new Map<string, Slot>();
  #gives = false;

  constructor(
    unit: Unit,
    clock: { readonly now: number },
    types: ReadonlyMap<string, { readonly size: number; readonly of: string }>,
    find: (name: string, line: number) => Ready,
  ) {
    this.#unit = unit;
    this.#clock = clock;
    this.#types = types;
    this.#function = find;
  }

  ready(): Ready {
    const { variables, kind, gives, line, name, body } = this.#unit;
    const taken = new Set([name.toUpperCase(), ...this.#types.keys()]);
    // Parameters stand in front, so that a call finds them.
    const isParameter = ({ section }: Variable) => section === 'VAR_INPUT' || section === 'VAR_IN_OUT';
    const ordered = [...variables.filter(isParameter), ...variables.filter((one) => !isParameter(one))];
    for (const [index, variable] of ordered.entries()) {
      legal(variable.name, variable.line, taken);
      const type = typeof variable.type === 'string' ? variable.type : `ARRAY ${variable.name}`;
      if (typeof variable.type === 'string' && !isElementary(type) && !this.#types.has(type.toUpperCase()))
        throw new Refused('an unknown type', variable.line, type);
      this.#slots.set(variable.name.toUpperCase(), { index, variable, type, used: false, set: false, fixed: false });
    }
    if (kind === 'FUNCTION' && parametersOf(this.#unit).length === 0)
      throw new Refused('a function has a parameter', line);
    const firsts = ordered.map((variable) => this.#first(variable));
    const run = this.#statements(body);
    for (const { variable, used, set } of this.#slots.values()) {
      if (variable.section === 'VAR_OUTPUT' ? !set : !used) throw new Refused('not used', variable.line, variable.name);
    }
    if (kind === 'FUNCTION' && !this.#gives) throw new Refused('a function gives something', line, name);
    return {
      unit: this.#unit,
      slots: this.#slots,
      fresh: () => [...firsts.map((first) => ({ v: first() })), { v: firstOf(gives ?? 'DINT') }],
      run,
    };
  }

  #arrayOf(type: Type | string): { readonly size: number; readonly of: string } | undefined {
    return typeof type === 'string' ? this.#types.get(type.toUpperCase()) : type;
  }

  #first({ type, first, section, line }: Variable): () => unknown {
    const array = this.#arrayOf(type);
    if (section === 'CONSTANT' && first === undefined) throw new Refused('a constant has a value', line);
    if (section === 'VAR_IN_OUT' && first !== undefined) throw new Refused('what is passed has no first value', line);
    const value = (of: Expression, wanted: string) => {
      const typed = this.#expression(of);
      same(typed.type, wanted, of.line);
      return typed.run([]);
    };
    if (array === undefined) {
      const wanted = type as string;
      const [only] = first ?? [];
      if (only === undefined) return () => firstOf(wanted);
      const given = value(only, wanted);
      return () => given;
    }
    if (first === undefined) return () => new Array(array.size).fill(firstOf(array.of));
    if (first.length !== array.size) throw new Refused('as many values as the array has', line);
    const values = first.map((one) => value(one, array.of));
    return () => [...values];
  }

  #statements(all: readonly Statement[]): Run {
    const runs = all.map((one) => this.#statement(one));
    return (scope) => {
      for (const run of runs) if (run(scope) === RETURNED) return RETURNED;
      return undefined;
    };
  }

  #statement(one: Statement): Run {
    switch (one.kind) {
      case 'set':
        return this.#set(one);
      case 'invoke':
        return this.#timer(one.block, one.given, one.line);
      case 'return':
        return () => RETURNED;
      case 'if': {
        const cases = one.cases.map(({ when, body }) => ({ when: this.#truth(when), body: this.#statements(body) }));
        const otherwise = this.#statements(one.otherwise);
        return (scope) => (cases.find(({ when }) => when(scope))?.body ?? otherwise)(scope);
      }
      case 'case': {
        const of = this.#expression(one.of);
        same(of.type, 'DINT', one.line);
        const cases = new Map<number, Run>();
        for (const { labels, body } of one.cases) {
          for (const label of labels) {
            if (cases.has(label)) throw new Refused('a label twice', one.line, String(label));
            cases.set(label, this.#statements(body));
          }
        }
        const otherwise = this.#statements(one.otherwise);
        return (scope) => (cases.get(of.run(scope) as number) ?? otherwise)(scope);
      }
      case 'for':
        return this.#for(one);
      case 'while': {
        const when = this.#truth(one.when);
        const body = this.#statements(one.body);
        return (scope) => {
          for (let round = 0; when(scope); round++) {
            if (round > MOST_ROUNDS) throw new RangeError('a loop without end');
            if (body(scope) === RETURNED) return RETURNED;
          }
          return undefined;
        };
      }
    }
  }

  #for({ name, from, to, body, line }: Extract<Statement, { kind: 'for' }>): Run {
    const slot = this.#slot(name, line);
    if (slot.variable.section !== 'VAR' || slot.fixed)
      throw new Refused('a loop has a variable of its own', line, name);
    same(slot.type, 'DINT', line);
    const [first, last] = [this.#expression(from), this.#expression(to)];
    for (const { type } of [first, last]) same(type, 'DINT', line);
    slot.used = true;
    slot.fixed = true;
    const inside = this.#statements(body);
    slot.fixed = false;
    return (scope) => {
      const end = last.run(scope) as number;
      const cell = scope[slot.index] as Cell;
      for (let at = first.run(scope) as number; at <= end; at++) {
        cell.v = at;
        if (inside(scope) === RETURNED) return RETURNED;
      }
      return undefined;
    };
  }

  #set({ to, value, line }: Extract<Statement, { kind: 'set' }>): Run {
    const given = this.#expression(value);
    if (to.kind === 'name' && to.name.toUpperCase() === this.#unit.name.toUpperCase()) {
      same(given.type, this.#unit.gives ?? '', line);
      this.#gives = true;
      return (scope) => {
        (scope.at(-1) as Cell).v = given.run(scope);
        return undefined;
      };
    }
    if (to.kind !== 'name' && to.kind !== 'element') throw new Refused('nothing is set there', line);
    const slot = this.#slot(to.kind === 'name' ? to.name : to.array, line);
    if (slot.variable.section === 'CONSTANT') throw new Refused('a constant stays', line, slot.variable.name);
    if (slot.variable.section === 'VAR_INPUT') throw new Refused('an input stays', line, slot.variable.name);
    if (slot.fixed) throw new Refused('the variable of a loop stays', line, slot.variable.name);
    slot.set = true;
    if (to.kind === 'name') {
      if (this.#arrayOf(slot.type)) throw new Refused('arrays are not set', line);
      same(given.type, slot.type, line);
      return (scope) => {
        (scope[slot.index] as Cell).v = given.run(scope);
        return undefined;
      };
    }
    const { type, array, at } = this.#element(to);
    same(given.type, type, line);
    return (scope) => {
      const index = at(scope);
      array(scope)[index] = given.run(scope);
      return undefined;
    };
  }

  /** A timer is called: TON is the only block there is. */
  #timer(block: string, given: readonly Given[], line: number): Run {
    const slot = this.#slot(block, line);
    same(slot.type, 'TON', line);
    slot.used = true;
    const of = (name: string, type: string) => {
      const found = given.find((one) => one.name === name);
      if (!found) throw new Refused(`${name} is missing`, line);
      const typed = this.#expression(found.value);
      same(typed.type, type, line);
      return typed.run;
    };
    if (given.length !== 2) throw new Refused('a timer has two inputs', line);
    const [runs, time] = [of('IN', 'BOOL'), of('PT', 'TIME')];
    return (scope) => {
      const timer = (scope[slot.index] as Cell).v as { since: number | undefined; Q: boolean };
      timer.since = runs(scope) ? (timer.since ?? this.#clock.now) : undefined;
      timer.Q = timer.since !== undefined && this.#clock.now - timer.since >= (time(scope) as number);
      return undefined;
    };
  }

  #truth(expression: Expression): (scope: Scope) => boolean {
    const { type, run } = this.#expression(expression);
    same(type, 'BOOL', expression.line);
    return run as (scope: Scope) => boolean;
  }

  #slot(name: string, line: number): Slot {
    const slot = this.#slots.get(name.toUpperCase());
    if (!slot) throw new Refused('not declared', line, name);
    return slot;
  }

  #element({ array: name, index, line }: Extract<Expression, { kind: 'element' }>): {
    readonly type: string;
    readonly array: (scope: Scope) => unknown[];
    readonly at: (scope: Scope) => number;
  } {
    const slot = this.#slot(name, line);
    const array = this.#arrayOf(slot.variable.type);
    if (!array) throw new Refused('not an array', line, name);
    slot.used = true;
    const at = this.#expression(index);
    same(at.type, 'DINT', line);
    if (index.kind === 'literal' && Number(index.value) >= array.size)
      throw new Refused('outside the array', line, name);
    return {
      type: array.of,
      array: (scope) => (scope[slot.index] as Cell).v as unknown[],
      at: (scope) => {
        const found = at.run(scope) as number;
        if (found < 0 || found >= array.size) throw new RangeError(`line ${line}: ${name}[${found}]`);
        return found;
      },
    };
  }

  #expression(one: Expression): Typed {
    const { line } = one;
    switch (one.kind) {
      case 'literal': {
        const { type = 'DINT', value } = one;
        if (typeof value === 'number' && !holdsNumber(type, value)) throw new Refused('out of range', line, `${value}`);
        if (!isElementary(type)) throw new Refused('an unknown type', line, type);
        return { type, run: () => value };
      }
      case 'real':
        return { type: 'LREAL', run: () => one.value };
      case 'time':
        return { type: 'TIME', run: () => one.value };
      case 'name': {
        const slot = this.#slot(one.name, line);
        slot.used = true;
        return { type: slot.type, run: (scope) => (scope[slot.index] as Cell).v };
      }
      case 'element': {
        const { type, array, at } = this.#element(one);
        return { type, run: (scope) => array(scope)[at(scope)] };
      }
      case 'member': {
        const slot = this.#slot(one.block, line);
        same(slot.type, 'TON', line);
        if (one.name !== 'Q') throw new Refused('a timer has no such output', line, one.name);
        return { type: 'BOOL', run: (scope) => ((scope[slot.index] as Cell).v as { Q: boolean }).Q };
      }
      case 'unary': {
        const of = this.#expression(one.of);
        if (one.operator === 'NOT') {
          same(of.type, 'BOOL', line);
          return { type: 'BOOL', run: (scope) => !of.run(scope) };
        }
        if (!isNumeric(of.type)) throw new Refused('a sign of a number', line);
        return { type: of.type, run: (scope) => -(of.run(scope) as number) };
      }
      case 'binary':
        return this.#binary(one);
      case 'call':
        return this.#call(one);
    }
  }

  #binary({ operator, left, right, line }: Extract<Expression, { kind: 'binary' }>): Typed {
    const [one, other] = [this.#expression(left), this.#expression(right)];
    if (one.type !== other.type) throw new Refused(`${one.type} ${operator} ${other.type}`, line);
    const { type } = one;
    // Both sides are calculated, as systems do not agree on whether they are.
    const of =
      <T>(calculate: (a: T, b: T) => unknown) =>
      (scope: Scope) => {
        const a = one.run(scope) as T;
        return calculate(a, other.run(scope) as T);
      };
    if (operator === 'AND' || operator === 'OR' || operator === 'XOR') {
      if (type === 'BOOL') return { type, run: of<boolean>(TRUTH[operator]) };
      if (!isBits(type)) throw new Refused(`${operator} of ${type}`, line);
      return { type, run: of<number>((a, b) => BITWISE[operator](a, b) >>> 0) };
    }
    const compare = COMPARE[operator];
    if (compare) {
      if (!isElementary(type) || (type === 'BOOL' && operator !== '=' && operator !== '<>'))
        throw new Refused(`${operator} of ${type}`, line);
      return { type: 'BOOL', run: of<number>(compare) };
    }
    const calculate = CALCULATE[operator];
    if (!calculate || !isNumeric(type) || (operator === 'MOD' && !isWhole(type)))
      throw new Refused(`${operator} of ${type}`, line);
    return {
      type,
      run: of<number>((a, b) => {
        if (b === 0 && (operator === '/' || operator === 'MOD')) throw new RangeError(`line ${line}: division by 0`);
        const result = calculate(a, b);
        return checked(type, isWhole(type) ? Math.trunc(result) : result);
      }),
    };
  }

  #call({ name, given, line }: Extract<Expression, { kind: 'call' }>): Typed {
    if (name === 'SHL' || name === 'SHR') return this.#shift(name, given, line);
    const [, from, to] = /^([A-Z]+)_TO_([A-Z]+)$/.exec(name) ?? [];
    if (from !== undefined && to !== undefined) {
      const convert = conversion(from, to);
      const [only, ...more] = given;
      if (!convert || !only || more.length > 0) throw new Refused('no such conversion in all systems', line, name);
      const of = this.#expression(only.value);
      same(of.type, from, line);
      return { type: to, run: (scope) => convert(of.run(scope) as number) };
    }
    const { unit, fresh, run } = this.#function(name, line);
    const parameters = parametersOf(unit);
    if (given.length !== parameters.length) throw new Refused('all parameters are given', line, name);
    const passed = parameters.map((parameter, index) => {
      const found =
        given[0]?.name === undefined ? given[index] : given.find((one) => upper(one.name) === upper(parameter.name));
      if (!found) throw new Refused(`${parameter.name} is missing`, line, name);
      const { value } = found;
      if (parameter.section === 'VAR_IN_OUT') {
        if (value.kind !== 'name') throw new Refused('a variable is passed', line, parameter.name);
        const slot = this.#slot(value.name, line);
        if (slot.variable.section === 'CONSTANT' || slot.variable.section === 'VAR_INPUT')
          throw new Refused('it may change there', line, value.name);
        slot.used = true;
        slot.set = true;
        same(upper(slot.type), upper(parameter.type as string), line);
        return (scope: Scope) => scope[slot.index] as Cell;
      }
      const typed = this.#expression(value);
      same(upper(typed.type), upper(parameter.type as string), line);
      return (scope: Scope) => {
        const v = typed.run(scope);
        return { v: Array.isArray(v) ? [...v] : v };
      };
    });
    return {
      type: unit.gives ?? '',
      run: (scope) => {
        const cells = passed.map((pass) => pass(scope));
        const inside = [...cells, ...fresh().slice(cells.length)];
        run(inside);
        return inside.at(-1)?.v;
      },
    };
  }

  #shift(name: 'SHL' | 'SHR', given: readonly Given[], line: number): Typed {
    const [value, by] = given.map((one) => this.#expression(one.value));
    if (!value || !by || !isBits(value.type)) throw new Refused(`${name} of bits`, line);
    same(by.type, 'DINT', line);
    const width = BITS[value.type] ?? 0;
    return {
      type: value.type,
      run: (scope) => {
        const [of, places] = [value.run(scope) as number, by.run(scope) as number];
        if (places < 0 || places >= width) throw new RangeError(`line ${line}: ${name} by ${places}`);
        return name === 'SHR' ? Math.floor(of / 2 ** places) : (of * 2 ** places) % 2 ** width;
      },
    };
  }
}

const upper = (name: string | undefined): string => (name ?? '').toUpperCase();

/** Nothing is converted by itself. */
function same(given: string, wanted: string, line: number): void {
  if (upper(given) !== upper(wanted)) throw new Refused(`${given} where ${wanted} stands`, line);
}

const TRUTH: Readonly<Record<'AND' | 'OR' | 'XOR', (a: boolean, b: boolean) => boolean>> = {
  AND: (a, b) => a && b,
  OR: (a, b) => a || b,
  XOR: (a, b) => a !== b,
};
const BITWISE: Readonly<Record<'AND' | 'OR' | 'XOR', (a: number, b: number) => number>> = {
  AND: (a, b) => a & b,
  OR: (a, b) => a | b,
  XOR: (a, b) => a ^ b,
};
const COMPARE: Readonly<Record<string, (a: number, b: number) => boolean>> = {
  '=': (a, b) => a === b,
  '<>': (a, b) => a !== b,
  '<': (a, b) => a < b,
  '>': (a, b) => a > b,
  '<=': (a, b) => a <= b,
  '>=': (a, b) => a >= b,
};
const CALCULATE: Readonly<Record<string, (a: number, b: number) => number>> = {
  '+': (a, b) => a + b,
  '-': (a, b) => a - b,
  '*': (a, b) => a * b,
  '/': (a, b) => a / b,
  MOD: (a, b) => a % b,
};
