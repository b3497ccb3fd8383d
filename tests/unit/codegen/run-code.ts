import type {
  Argument,
  Code,
  Expression,
  Name,
  Operator,
  Routine,
  Scalar,
  Statement,
} from '../../../src/codegen/code.ts';

/** An array, or a number or truth. */
export type Given = number | boolean | (number | boolean)[];
type Value = number | boolean;

const WIDTHS: Readonly<Partial<Record<Scalar, number>>> = { byte: 8, word: 16, dword: 32 };

class Refused extends Error {}
const refuse = (why: string): never => {
  throw new Refused(why);
};

/** Holds a value against its type. */
function fits(type: Scalar, value: Value | undefined, what: string): Value {
  if (value === undefined) return refuse(`${what}: not set`);
  if (type === 'bool' ? typeof value !== 'boolean' : typeof value !== 'number') return refuse(`${what}: no ${type}`);
  if (type === 'bool' || type === 'real') return value;
  const width = WIDTHS[type];
  const [least, most] = width === undefined ? [-(2 ** 31), 2 ** 31 - 1] : [0, 2 ** width - 1];
  const number = value as number;
  if (!Number.isInteger(number) || number < least || number > most) return refuse(`${what}: ${number} is no ${type}`);
  return value;
}

interface Local {
  readonly type: Scalar;
  value: Value | undefined;
  readonly changes: boolean;
  read: boolean;
  readonly isArray?: false;
}
interface LocalArray {
  readonly type: Scalar;
  readonly values: (Value | undefined)[];
  readonly filled: boolean;
  read: boolean;
  readonly isArray: true;
}
type Scope = Map<Name, Local | LocalArray>;

/** Carries out programs in no language, and refuses what is not strict: other types, places outside arrays, what is not set. */
export class CodeRunner {
  readonly #code: Code;

  constructor(code: Code) {
    this.#code = code;
  }

  /** What a routine gives: the bytes of a frame, or a value. Arrays that it fills are changed. */
  run(of: Name, ...given: readonly Given[]): number[] | Value {
    return this.#call(
      this.#routine(of),
      given.map((one) => (Array.isArray(one) ? { values: one } : one)),
    );
  }

  #routine(of: Name): Routine {
    return this.#code.routines.find(({ name }) => name === of) ?? refuse(`no routine ${of}`);
  }

  #call(routine: Routine, given: readonly (Value | { values: (Value | undefined)[] })[]): number[] | Value {
    const { parameters, gives, name } = routine;
    if (given.length !== parameters.length) refuse(`${name}: ${given.length} arguments for ${parameters.length}`);
    const scope: Scope = new Map();
    for (const [index, { name: of, type, size, filled }] of parameters.entries()) {
      const one = given[index] as Value | { values: Value[] };
      if (typeof one === 'object') {
        if (size === undefined) return refuse(`${of}: an array`);
        scope.set(of, { type, values: one.values, filled: filled === true, read: false, isArray: true });
      } else scope.set(of, { type, value: fits(type, one, of), changes: false, read: false });
    }
    const frame: number[] | undefined = gives.kind === 'frame' ? [] : undefined;
    if (frame !== undefined)
      scope.set('frame', { type: 'byte', values: frame, filled: false, read: true, isArray: true });
    const answer = new Run(this.#code, (called, all) => this.#call(this.#routine(called), all), frame, gives).block(
      routine.body,
      scope,
    );
    if (gives.kind === 'value') return fits(gives.type, answer, name);
    if ((frame as number[]).length > gives.most)
      refuse(`${name}: ${(frame as number[]).length} bytes, not ${gives.most}`);
    return frame as number[];
  }
}

type Call = (of: Name, given: readonly (Value | { values: (Value | undefined)[] })[]) => number[] | Value;

class Run {
  constructor(
    readonly code: Code,
    readonly call: Call,
    readonly frame: number[] | undefined,
    readonly gives: Routine['gives'],
  ) {}

  /** Carries out a block in a scope of its own; the value it returns, if it does. */
  block(body: readonly Statement[], outer: Scope): Value | undefined {
    const scope: Scope = new Map(outer);
    for (const statement of body) {
      const given = this.#statement(statement, scope);
      if (given !== undefined) return given;
    }
    return undefined;
  }

  #statement(statement: Statement, scope: Scope): Value | undefined {
    switch (statement.kind) {
      case 'declare': {
        if (scope.has(statement.name)) refuse(`${statement.name}: declared twice`);
        const { type } = statement.value;
        scope.set(statement.name, {
          type,
          value: this.value(statement.value, scope),
          changes: statement.changes,
          read: false,
        });
        return undefined;
      }
      case 'set': {
        const { to } = statement;
        const value = this.value(statement.value, scope);
        if (to.type !== statement.value.type) refuse(`a ${statement.value.type} into a ${to.type}`);
        if (to.kind === 'name') {
          const local = scope.get(to.name);
          if (local === undefined || local.isArray || !local.changes) return refuse(`${to.name}: not changed`);
          local.value = fits(local.type, value, to.name);
        } else {
          const array = this.#array(to.array, scope);
          if (!array.filled) refuse(`${to.array}: not filled`);
          array.values[this.#place(to.index, array.values.length, scope, to.array)] = fits(array.type, value, to.array);
        }
        return undefined;
      }
      case 'put':
        if (statement.value.type !== 'byte' || this.frame === undefined) return refuse('put');
        this.frame.push(fits('byte', this.value(statement.value, scope), 'put') as number);
        return undefined;
      case 'if':
        return this.block(this.#truth(statement.when, scope) ? statement.then : statement.otherwise, scope);
      case 'for': {
        const [from, to] = [this.#int(statement.from, scope), this.#int(statement.to, scope)];
        if (scope.has(statement.name)) refuse(`${statement.name}: declared twice`);
        for (let at = from; at < to; at++) {
          const inside: Scope = new Map(scope);
          inside.set(statement.name, { type: 'int', value: at, changes: false, read: true });
          const given = this.block(statement.body, inside);
          if (given !== undefined) return given;
        }
        return undefined;
      }
      case 'while': {
        for (let turn = 0; this.#truth(statement.when, scope); turn++) {
          if (turn > 10_000) refuse('a loop without an end');
          const given = this.block(statement.body, scope);
          if (given !== undefined) return given;
        }
        return undefined;
      }
      case 'return':
        if (this.gives.kind === 'frame' || this.gives.type !== statement.value.type) refuse('return');
        return this.value(statement.value, scope);
      case 'remark':
        return undefined;
    }
  }

  #truth(of: Expression, scope: Scope): boolean {
    return of.type === 'bool' ? (this.value(of, scope) as boolean) : refuse('a condition that is no bool');
  }

  #int(of: Expression, scope: Scope): number {
    return of.type === 'int' ? (this.value(of, scope) as number) : refuse(`an index of type ${of.type}`);
  }

  #array(of: Name, scope: Scope): LocalArray {
    const local = scope.get(of);
    if (local?.isArray) return local;
    const table = this.code.tables.find(({ name }) => name === of) ?? refuse(`no array ${of}`);
    return { type: table.type, values: [...table.values], filled: false, read: true, isArray: true };
  }

  #place(index: Expression, length: number, scope: Scope, of: Name): number {
    const at = this.#int(index, scope);
    return at >= 0 && at < length ? at : refuse(`${of}[${at}] of ${length}`);
  }

  value(of: Expression, scope: Scope): Value {
    return fits(of.type, this.#raw(of, scope), of.kind);
  }

  #raw(of: Expression, scope: Scope): Value | undefined {
    switch (of.kind) {
      case 'number':
      case 'truth':
        return of.value;
      case 'name': {
        const local =
          scope.get(of.name) ?? this.code.constants.find(({ name }) => name === of.name) ?? refuse(`no ${of.name}`);
        if ('isArray' in local && local.isArray) return refuse(`${of.name}: an array`);
        if (local.type !== of.type) refuse(`${of.name}: a ${local.type}, not ${of.type}`);
        return (local as Local).value;
      }
      case 'element': {
        const array = this.#array(of.array, scope);
        if (array.type !== of.type) refuse(`${of.array}: of ${array.type}, not ${of.type}`);
        return array.values[this.#place(of.index, array.values.length, scope, of.array)];
      }
      case 'binary':
        return this.#binary(of.operator, of.left, of.right, scope);
      case 'not':
        return !this.#truth(of.of, scope);
      case 'convert': {
        const value = this.value(of.of, scope);
        if (of.of.type === of.type || typeof value !== 'number' || of.of.type === 'bool') return refuse('convert');
        const width = WIDTHS[of.type];
        return width === undefined ? value : value - Math.floor(value / 2 ** width) * 2 ** width;
      }
      case 'signed': {
        const width = WIDTHS[of.of.type] ?? refuse('signed');
        return Number(BigInt.asIntN(width, BigInt(this.value(of.of, scope) as number)));
      }
      case 'float': {
        if (of.of.type !== 'dword') refuse('float');
        const view = new DataView(new ArrayBuffer(4));
        view.setUint32(0, this.value(of.of, scope) as number);
        return view.getFloat32(0);
      }
      case 'floor':
        return of.of.type === 'real' ? Math.floor(this.value(of.of, scope) as number) : refuse('floor');
      case 'call': {
        const answer = this.call(
          of.routine,
          of.arguments.map((one) => this.#argument(one, scope)),
        );
        return Array.isArray(answer) ? refuse(`${of.routine}: a frame`) : answer;
      }
      case 'put so far':
        return this.frame?.length ?? refuse('put so far');
    }
  }

  #argument(of: Argument, scope: Scope): Value | { values: (Value | undefined)[] } {
    return of.kind === 'array' ? { values: this.#array(of.array, scope).values } : this.value(of, scope);
  }

  #binary(operator: Operator, left: Expression, right: Expression, scope: Scope): Value {
    const [a, b] = [this.value(left, scope), this.value(right, scope)];
    if (operator === 'and' || operator === 'or') {
      if (left.type !== 'bool' || right.type !== 'bool') refuse(operator);
      return operator === 'and' ? a === true && b === true : a === true || b === true;
    }
    if (operator === '<<' || operator === '>>') {
      const width = WIDTHS[left.type] ?? refuse(`${operator} of ${left.type}`);
      if (right.type !== 'int' || (b as number) < 0 || (b as number) >= width) refuse(`${operator} ${String(b)}`);
      const [value, by] = [a as number, 2 ** (b as number)];
      return operator === '<<' ? (value * by) % 2 ** width : Math.floor(value / by);
    }
    if (left.type !== right.type) refuse(`${left.type} ${operator} ${right.type}`);
    if (operator === '=') return a === b;
    if (operator === '≠') return a !== b;
    const [x, y] = [a as number, b as number];
    if (left.type === 'bool') refuse(`${operator} of bool`);
    switch (operator) {
      case '<':
        return x < y;
      case '≤':
        return x <= y;
      case '>':
        return x > y;
      case '≥':
        return x >= y;
      case '&':
      case '|':
      case '^': {
        if (WIDTHS[left.type] === undefined) refuse(`${operator} of ${left.type}`);
        return (operator === '&' ? x & y : operator === '|' ? x | y : x ^ y) >>> 0;
      }
    }
    if (left.type !== 'int' && left.type !== 'real') refuse(`${operator} of ${left.type}`);
    if (operator === '+') return x + y;
    if (operator === '-') return x - y;
    if (operator === '*') return x * y;
    if (left.type === 'int' && (x < 0 || y <= 0)) refuse(`${x} ${operator} ${y}`);
    if (operator === '%') return left.type === 'int' ? x % y : refuse('% of real');
    return left.type === 'int' ? Math.trunc(x / y) : x / y;
  }
}
